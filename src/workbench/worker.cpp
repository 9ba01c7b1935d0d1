#include "workbench/worker.h"

#include <exception>
#include <utility>

namespace cg {

Worker::Worker() : thread_([this] { run(); }) {}

Worker::~Worker() {
  Task dropped;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    std::swap(dropped, waiting_);
    if (running_) running_->cancelled = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Worker::submit(Task task, bool cancel_running) {
  {
    const std::lock_guard lock(mutex_);
    if (cancel_running && running_) running_->cancelled = true;
    std::swap(task, waiting_);  // the replaced task is freed after the lock
  }
  wake_.notify_one();
}

void Worker::cancel_stale() {
  const std::lock_guard lock(mutex_);
  if (running_ && waiting_) running_->cancelled = true;
}

bool Worker::waiting() const {
  const std::lock_guard lock(mutex_);
  return bool(waiting_);
}

bool Worker::busy() const {
  const std::lock_guard lock(mutex_);
  return running_ || waiting_;
}

float Worker::fraction() const {
  const std::lock_guard lock(mutex_);
  return running_ ? running_->fraction.load() : 1.0f;
}

void Worker::wait() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return !running_ && !waiting_; });
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopping_ || waiting_; });
    if (stopping_) return;
    Task task = std::exchange(waiting_, nullptr);
    const auto progress = running_ = std::make_shared<Progress>();
    lock.unlock();
    try {
      task(*progress);
    } catch (const Cancelled&) {
    } catch (const std::exception&) {
      // Keeping its error is the task's affair; the thread must live on.
    }
    task = nullptr;
    lock.lock();
    running_ = nullptr;
    if (!waiting_) idle_.notify_all();
  }
}

}  // namespace cg
