// A thread with an OpenGL context of its own. Work may be handed to it from any thread; a slow driver then
// never stops the caller's other work, and no context ever changes its thread.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "gl/offscreen_context.h"

namespace cg {

class GlThread {
 public:
  // Cheap: thread and context are made when the first work comes.
  explicit GlThread(GlProfile profile) : profile_(profile) {}
  // Runs what `at_exit` was given on the context's thread, then ends it.
  ~GlThread();
  GlThread(const GlThread&) = delete;
  GlThread& operator=(const GlThread&) = delete;

  // Runs `work` on the context's thread and waits; what it throws is thrown here. Throws NoContext where there
  // is no context: found once, said every time.
  void run(const std::function<void()>& work);

  // Run on the context's thread before the context goes: frees what lives in it.
  void at_exit(std::function<void()> last) { last_ = std::move(last); }

  // Why there is no context, once that is known. Never waits for the driver.
  std::optional<Text> failure() const;

 private:
  void loop();

  const GlProfile profile_;
  mutable std::mutex mutex_;
  std::mutex one_caller_;
  std::condition_variable changed_;
  std::thread thread_;
  std::function<void()> last_;
  const std::function<void()>* work_ = nullptr;
  std::exception_ptr error_;
  std::optional<Text> failure_;
  bool done_ = false, quit_ = false;
};

}  // namespace cg
