#include "gl/gl_thread.h"

#include <utility>

namespace cg {

GlThread::~GlThread() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::optional<Text> GlThread::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

void GlThread::run(const std::function<void()>& work) {
  const std::lock_guard turn(one_caller_);
  std::unique_lock lock(mutex_);
  if (failure_) throw NoContext(*failure_);
  if (!thread_.joinable()) thread_ = std::thread([this] { loop(); });
  work_ = &work;
  error_ = nullptr;
  done_ = false;
  changed_.notify_all();
  changed_.wait(lock, [this] { return done_; });
  if (failure_) throw NoContext(*failure_);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void GlThread::loop() {
  std::optional<OffscreenContext> context;
  std::optional<Text> failure;
  try {
    context.emplace(profile_);
  } catch (const NoContext& e) {
    failure = e.reason;
  }
  std::unique_lock lock(mutex_);
  failure_ = failure;
  for (;;) {
    changed_.wait(lock, [this] { return quit_ || work_; });
    if (quit_) break;
    const std::function<void()>& work = *work_;
    std::exception_ptr error;
    if (context) {
      lock.unlock();
      try {
        work();
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
    }
    work_ = nullptr;
    error_ = error;
    done_ = true;
    changed_.notify_all();
  }
  lock.unlock();
  if (context && last_) last_();
}

}  // namespace cg
