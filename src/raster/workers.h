// Shares the parts of a pass among threads, and asks between them whether the work was cancelled.
#pragma once
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "scene/frame.h"

namespace cg {

class Workers {
 public:
  // `threads` as in View; less than 1 counts as 1.
  Workers(int threads, Progress& progress) : threads_(threads > 1 ? threads : 1), progress_(progress) {
    // More than the machine has would only make oneTBB complain.
    if (threads_ > 1) arena_.initialize(std::min(threads_, tbb::info::default_concurrency()));
  }

  int threads() const { return threads_; }

  // Throws Cancelled where the work was cancelled. Long parts ask themselves every millisecond or so.
  void check() const {
    if (progress_.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
  }

  void done(float fraction) const { progress_.fraction.store(fraction, std::memory_order_relaxed); }

  // part(i) for 0 <= i < count. Parts must not depend on each other: then the result does not depend on the
  // number of threads.
  template <class Part>
  void for_each(int count, const Part& part) {
    auto one = [&](int i) {
      check();
      part(i);
    };
    if (threads_ == 1 || count < 2) {
      for (int i = 0; i < count; ++i) one(i);
    } else {
      arena_.execute([&] { tbb::parallel_for(0, count, one, tbb::simple_partitioner{}); });
    }
  }

 private:
  int threads_;
  Progress& progress_;
  tbb::task_arena arena_;
};

// [begin, end) of a list, in parts of at most `part_size`.
struct Part {
  std::size_t begin, end;
};
inline int part_count(std::size_t size, std::size_t part_size) { return int((size + part_size - 1) / part_size); }
inline Part part_of(std::size_t size, std::size_t part_size, int i) {
  const std::size_t begin = std::size_t(i) * part_size;
  return {begin, begin + part_size < size ? begin + part_size : size};
}

}  // namespace cg
