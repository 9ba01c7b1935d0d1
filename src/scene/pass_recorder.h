// What a technique does for a picture, written down while it draws. Costs a reading of the clock a pass.
#pragma once
#include <algorithm>
#include <utility>

#include "scene/cpu_clock.h"
#include "scene/frame.h"
#include "scene/only_plain.h"

namespace cg {

// The memory that a list or an image holds, used or not.
template <class List>
std::size_t bytes_of(const List& list) {
  return list.capacity() * sizeof(typename List::value_type);
}
template <class Pixel>
std::size_t bytes_of(const Image<Pixel>& image) {
  return bytes_of(image.pixels());
}

// Room for exactly `count`: what a larger picture left is given back.
template <class List>
void fit(List& list, std::size_t count) {
  if (list.capacity() != count) List().swap(list);
  list.resize(count);
}

class PassRecorder {
 public:
  // A pass that has just ended: it began where the one before it ended. Returns its milliseconds.
  double pass(std::string id, std::size_t bytes = 0, bool kept = false) {
    if constexpr (only_plain) return 0;
    const double ms = clock_.lap_ms();
    add({std::move(id), ms, bytes, kept});
    return ms;
  }
  // A resource, a part of the code, or a pass whose result is there from a picture before.
  void item(std::string id, std::size_t bytes = 0, bool kept = false) { add({std::move(id), 0, bytes, kept}); }
  // More bytes of a line that is there.
  void hold(std::string_view id, std::size_t bytes) {
    for (PassRun& p : passes_)
      if (p.id == id) p.bytes += bytes;
  }
  // What lies between two passes and belongs to neither.
  void skip() {
    if constexpr (!only_plain) clock_.lap_ms();
  }

  // Ends it all: fills Frame::passes. Returns the milliseconds since the recorder was made.
  double finish(Frame& frame) {
    clock_.lap_ms();
    frame.passes = std::move(passes_);
    return clock_.total_ms();
  }

 private:
  // A pass that runs again adds to its line.
  void add(PassRun run) {
    if constexpr (only_plain) return;
    for (PassRun& p : passes_)
      if (p.id == run.id) {
        p.cpu_ms += run.cpu_ms, p.bytes = std::max(p.bytes, run.bytes), p.kept = p.kept && run.kept;
        return;
      }
    passes_.push_back(std::move(run));
  }
  CpuClock clock_;
  std::vector<PassRun> passes_;
};

}  // namespace cg
