#include "ui/probe_jobs.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"

namespace cg {

glm::ivec2 pixel_at(const glm::dvec2& at, int width, int height) {
  const auto one = [](double t, int size) { return std::clamp(int(std::floor(t * size)), 0, std::max(size - 1, 0)); };
  return {one(at.x, width), one(at.y, height)};
}

void ProbeJobs::update(std::optional<glm::dvec2> at, const std::array<DrawingHandle, 2>& drawings,
                       const std::array<const Technique*, 2>& techniques) {
  Asked asked{at, drawings};
  for (DrawingHandle& drawing : asked.drawings)
    if (!at || (drawing && (drawing->coarseness > 1 || drawing->frame.colour.empty()))) drawing = nullptr;
  for (std::size_t side = 0; side < 2; ++side)
    if (at && at == asked_.at && !asked.drawings[side] && drawings[side]) asked.drawings[side] = asked_.drawings[side];
  if (asked == asked_) return;
  asked_ = asked;
  if (!at) {
    worker_.submit([](Progress&) {}, true);  // what runs is of no use any more
    const std::lock_guard lock(mutex_);
    results_ = {};
    return;
  }
  std::array<Technique, 2> copies{*techniques[0], *techniques[1]};
  worker_.submit([this, asked = std::move(asked), copies = std::move(copies)](Progress& progress) {
    answer(asked, copies, progress);
  });
}

void ProbeJobs::answer(const Asked& asked, const std::array<Technique, 2>& techniques, Progress& progress) {
  for (std::size_t side = 0; side < 2; ++side) {
    const DrawingHandle& drawing = asked.drawings[side];
    std::shared_ptr<Probed> probed;
    if (drawing) {
      const Frame& frame = drawing->frame;
      View view = drawing->view;
      view.width = frame.colour.width(), view.height = frame.colour.height();
      try {
        probed = std::make_shared<Probed>();
        probed->drawing = drawing;
        probed->probe = probe_with_numbers(drawing->scene, techniques[side], view, frame,
                                           pixel_at(*asked.at, view.width, view.height), progress);
      } catch (const InputError&) {
        probed.reset();  // the technique says by itself why it cannot draw
      }
    }
    const std::lock_guard lock(mutex_);
    if (progress.cancelled) return;
    results_[side] = std::move(probed);
  }
  if (wake_) wake_();
}

std::shared_ptr<const Probed> ProbeJobs::of(int side) const {
  const std::lock_guard lock(mutex_);
  return results_[std::size_t(side)];
}

}  // namespace cg
