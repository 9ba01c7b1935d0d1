#include "workbench/measurement.h"

#include "params/input_error.h"
#include "workbench/measurement_picture.h"

namespace cg {

namespace {

std::vector<Measurement> all_measurements() {
  std::vector<Measurement> all;
  for (const auto part : {picture_measurements(), point_measurements(), radiosity_measurements()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

Scene with_radiosity(const Scene& scene, SolvedScenes& solved, Progress& progress) {
  Scene out = scene;
  if (wants_radiosity(scene)) out.radiosity_field = solved.of(scene, progress).field;
  return out;
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
               std::span<const Technique> techniques, Progress& progress, SolvedScenes& solved) {
  const Scene lit = with_radiosity(scene, solved, progress), other = with_radiosity(against, solved, progress);
  return measuring.what->measure({lit, other, measuring.options, techniques, progress, solved});
}

}  // namespace cg
