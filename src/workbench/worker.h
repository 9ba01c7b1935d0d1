// A thread of its own that does the newest task it was given: the window gives work away here and never waits.
// At most one task runs and one waits; a newer one replaces the one that waits, so no queue can grow.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "scene/frame.h"

namespace cg {

class Worker {
 public:
  // Runs on the worker's thread. Ends early, or throws Cancelled, when progress.cancelled is set; what else it
  // throws is lost, so a task that can fail catches and keeps its error.
  using Task = std::function<void(Progress& progress)>;

  Worker();
  // Cancels what runs, drops what waits, and returns when the thread has ended.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Replaces the task that waits. The one that runs goes on, or is asked to stop.
  void submit(Task task, bool cancel_running = false);
  // Asks the running task to stop if another waits for it.
  void cancel_stale();
  // Whether a task waits: the one that runs is stale.
  bool waiting() const;
  bool busy() const;       // a task runs or waits
  float fraction() const;  // of the running task, 0..1; 1 if there is none
  // Returns when nothing runs and nothing waits. For programs without a window, and for tests.
  void wait();

 private:
  void run();

  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  Task waiting_;
  std::shared_ptr<Progress> running_;  // null: nothing runs
  bool stopping_ = false;
  std::thread thread_;  // last: starts when all else is there
};

}  // namespace cg
