// A setting drawn and brought to the size in which it is compared, and the errors of colours.
#include <algorithm>
#include <cmath>

#include "measure/knob.h"
#include "measure/resample.h"
#include "scene/cpu_clock.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

Errors errors_over(const Frame& a, const Frame& b, bool everywhere) {
  Errors out;
  double squares = 0;
  const auto& pa = a.colour.pixels();
  const auto& pb = b.colour.pixels();
  for (std::size_t i = 0; i < std::min(pa.size(), pb.size()); ++i) {
    if (!everywhere && !(a.covered.pixels()[i] && b.covered.pixels()[i])) continue;
    const glm::dvec3 off = glm::abs(glm::dvec3(pa[i]) - glm::dvec3(pb[i]));
    squares += glm::dot(off, off);
    out.max = std::max({out.max, off.r, off.g, off.b});
    ++out.samples;
  }
  if (out.samples) out.rmse = std::sqrt(squares / (3 * double(out.samples)));
  return out;
}

}  // namespace

Frame draw_setting(const Setting& setting, std::span<const Technique> techniques, Progress& progress) {
  const Technique& technique = find_technique(techniques, setting.technique);
  require(technique, setting.scene);
  Frame frame = technique.render(setting.scene, technique.plan(setting.scene, setting.view), setting.view, progress);
  if (setting.resampling == Resampling::none) return frame;
  const double begin = process_cpu_ms();
  frame.colour = resampled(frame.colour, setting.resampling, setting.factor);
  frame.cpu_ms += process_cpu_ms() - begin;
  frame.covered = resampled_coverage(frame.covered, setting.resampling, setting.factor);
  return frame;
}

Errors colour_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  return errors_over(frame, reference, false);
}

Errors colour_errors_everywhere(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  return errors_over(frame, reference, true);
}

}  // namespace cg
