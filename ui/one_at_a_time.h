// A technique draws one picture at a time (scene/technique.h). In the window several threads ask for pictures: those of
// the panes, of a lesson's numbers, of the challenge. So each technique gets a lock that its copies share.
#pragma once
#include <memory>
#include <mutex>
#include <utility>

#include "scene/technique.h"

namespace cg {

inline Technique one_at_a_time(Technique technique) {
  technique.render = [lock = std::make_shared<std::mutex>(), render = std::move(technique.render)](
                         const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
    const std::lock_guard held(*lock);
    if (progress.cancelled) throw Cancelled{};
    return render(scene, plan, view, progress);
  };
  return technique;
}

}  // namespace cg
