#include "workbench/measurement.h"

#include "params/input_error.h"
#include "workbench/measurement_picture.h"

namespace cg {

namespace {

std::vector<Measurement> all_measurements() {
  const auto pictures = picture_measurements(), points = point_measurements();
  std::vector<Measurement> all(pictures.begin(), pictures.end());
  all.insert(all.end(), points.begin(), points.end());
  return all;
}

}  // namespace

std::span<const Measurement> measurements() {
  static const std::vector<Measurement> all = all_measurements();
  return all;
}

const Measurement& find_measurement(std::string_view id) {
  std::string ids;
  for (const Measurement& m : measurements()) {
    if (m.id == id) return m;
    ids += (ids.empty() ? "" : ", ") + std::string(m.id);
  }
  throw InputError(std::string(id), {"there is no such measurement", "そのような測定はない"},
                   {"known are: " + ids, "あるのは " + ids});
}

double measure(const Measuring& measuring, const Scene& scene, const Scene& against,
               std::span<const Technique> techniques, Progress& progress) {
  return measuring.what->measure({scene, against, measuring.options, techniques, progress});
}

}  // namespace cg
