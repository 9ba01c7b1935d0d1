// The probe of the pixel that a person clicked, for both pictures, worked out on a thread of its own.
#pragma once
#include <array>
#include <memory>
#include <mutex>
#include <optional>

#include "workbench/job.h"
#include "workbench/probe.h"

namespace cg {

// A probed pixel and the picture that it is of.
struct Probed {
  Probe probe;
  DrawingHandle drawing;
};

class ProbeJobs {
 public:
  // `wake` is called on another thread when there is something new.
  explicit ProbeJobs(std::function<void()> wake) : wake_(std::move(wake)) {}

  // `at`: the pixel, as a part of the picture's width and height; nothing: no pixel is asked about. `drawings`: the
  // pictures as they are shown; those that are coarse or null keep what was known before.
  void update(std::optional<glm::dvec2> at, const std::array<DrawingHandle, 2>& drawings,
              const std::array<const Technique*, 2>& techniques);
  // The newest of a side; null: none.
  std::shared_ptr<const Probed> of(int side) const;
  bool busy() const { return worker_.busy(); }

 private:
  struct Asked {
    std::optional<glm::dvec2> at;
    std::array<DrawingHandle, 2> drawings;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  void answer(const Asked& asked, const std::array<Technique, 2>& techniques, Progress& progress);

  std::function<void()> wake_;
  Asked asked_;
  mutable std::mutex mutex_;
  std::array<std::shared_ptr<const Probed>, 2> results_;
  Worker worker_;  // last: it uses what stands above
};

// The pixel of a picture that `at` (0..1) falls into.
glm::ivec2 pixel_at(const glm::dvec2& at, int width, int height);

}  // namespace cg
