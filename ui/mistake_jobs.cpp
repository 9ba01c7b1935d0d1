#include "ui/mistake_jobs.h"

namespace cg {

void MistakeJobs::want(const Scene& scene, const std::vector<std::string>& mistakes, const View& view,
                       std::function<void()> wake) {
  if (mistakes == mistakes_ && view == view_ && scene == scene_) return;
  scene_ = scene, mistakes_ = mistakes, view_ = view;
  worker_.submit(
      [this, scene, mistakes, view, wake = std::move(wake)](Progress& progress) {
        std::map<std::string, MistakeEffect> effects;
        for (const std::string& mistake : mistakes) {
          if (progress.cancelled) return;
          if (auto effect = mistake_effect(scene, mistake, view)) effects[mistake] = std::move(*effect);
        }
        {
          const std::lock_guard lock(mutex_);
          effects_ = std::move(effects);
        }
        if (wake) wake();
      },
      false);
}

std::optional<MistakeEffect> MistakeJobs::of(const std::string& mistake) const {
  const std::lock_guard lock(mutex_);
  const auto found = effects_.find(mistake);
  return found == effects_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace cg
