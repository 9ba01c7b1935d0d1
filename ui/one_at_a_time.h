// A technique draws one picture at a time (scene/technique.h). In the window several threads ask for pictures: those of
// the panes, of a lesson's numbers, of the challenge, of a trade. So each technique gets a lock that its copies share,
// and that lets them in in the order in which they came: who asks again and again does not keep the others out.
#pragma once
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

#include "scene/technique.h"

namespace cg {

class TurnLock {
 public:
  void lock() {
    std::unique_lock held(mutex_);
    const std::uint64_t mine = next_++;
    turn_.wait(held, [&] { return serving_ == mine; });
  }
  void unlock() {
    {
      const std::lock_guard held(mutex_);
      ++serving_;
    }
    turn_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable turn_;
  std::uint64_t next_ = 0, serving_ = 0;  // tickets
};

inline Technique one_at_a_time(Technique technique) {
  technique.render = [lock = std::make_shared<TurnLock>(), render = std::move(technique.render)](
                         const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
    const std::lock_guard held(*lock);
    if (progress.cancelled) throw Cancelled{};
    return render(scene, plan, view, progress);
  };
  return technique;
}

}  // namespace cg
