// A technique that draws on a thread of its own, always the newest scene it was given. The window never waits
// for it: it submits what changed and takes the newest picture that is there. When the last full picture took
// long, a coarse one comes first and is refined.
#pragma once
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "image/difference.h"
#include "scene/technique.h"
#include "workbench/scene_change.h"
#include "workbench/worker.h"

namespace cg {

// What is to be drawn. Meshes may still be missing: they are loaded on the job's thread.
struct Request {
  Scene scene;
  View view;
  bool mark_clamped = false;  // paint the pixels that the display transform clamps
};

// A finished picture and what it is a picture of; never changed once it is published.
struct Drawing {
  std::uint64_t serial = 0;  // of the request, as submit() returned it
  Scene scene;               // what was drawn, meshes loaded
  View view;                 // as asked for; frame is smaller by `coarseness`
  int coarseness = 1;        // 4: a quarter of the width and of the height
  Frame frame;
  Picture shown;                     // frame.colour as a screen shows it
  Clamped clamped;                   // what was painted, if that was asked for
  std::shared_ptr<const Plan> plan;  // by which it was drawn
  SceneChange change;                // against the drawing before; all false in the first
  bool partly = false;               // something was taken from the drawing before: its times are not a whole picture's
  double wall_ms = 0;                // of the technique
  double cpu_ms = 0;                 // of the technique, all threads
};
using DrawingHandle = std::shared_ptr<const Drawing>;

class Job {
 public:
  struct Hooks {
    std::function<void(Scene&)> prepare;  // loads meshes, on the job's thread; may throw InputError
    std::function<void()> wake;           // called on the job's thread when there is something to poll
    double coarse_over_ms = 30;           // a full picture that takes longer is preceded by a coarse one
  };
  // All that the window needs to know, as of now.
  struct State {
    DrawingHandle drawing;             // the newest finished; null before the first
    std::optional<Text> message;       // why the newest request has no picture, if so
    std::shared_ptr<const Plan> plan;  // of the newest request that was planned; null before
    std::uint64_t answered = 0;        // newest serial with a full picture or a message
    bool busy = false;
    float fraction = 1;  // of the pass that runs
  };

  // `technique` is copied; its render is called on one thread only.
  Job(Technique technique, Hooks hooks);

  const Technique& technique() const { return technique_; }
  // Draws `request` as soon as it can. What is stale is cancelled, unless its picture is nearly there: so a
  // slider that moves all the time still shows pictures. Returns the request's serial: 1, 2, 3, ...
  std::uint64_t submit(Request request);
  // Never blocks for a technique. Call it now and then while busy: it also cancels a stale pass that takes
  // longer than it was expected to.
  State poll();
  // Until all that was submitted is answered. For programs without a window, and for tests.
  void wait() { worker_.wait(); }

 private:
  using Clock = std::chrono::steady_clock;

  void answer(const Request& request, std::uint64_t serial, Progress& progress);
  std::shared_ptr<Drawing> draw(const Request& request, std::shared_ptr<const Plan> plan, int coarseness,
                                Progress& progress);
  // The drawing before, where only its display transform is another than that of `request`; else null.
  DrawingHandle same_light(const Request& request) const;
  int first_coarseness(const View& view) const;
  void publish(std::shared_ptr<Drawing> drawing, std::uint64_t serial);
  void fail(std::uint64_t serial, Text message);
  bool worth_finishing() const;  // with mutex_ held

  const Technique technique_;
  const Hooks hooks_;
  mutable std::mutex mutex_;  // guards what follows
  State state_;
  std::uint64_t submitted_ = 0;
  double full_ms_ = 0;           // the last full picture took so long, or at least so long; 0: not known
  int pass_coarseness_ = 1;      // of the pass that runs
  std::vector<Object> drawing_;  // what the pass that runs shows
  Clock::time_point pass_start_;
  Worker worker_;  // last: its thread uses all of the above and ends first
};

// Threads for a technique that can use more, of this machine's: one is left to the window where there are more
// than two.
int drawing_threads();

}  // namespace cg
