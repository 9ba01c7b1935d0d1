#include "radiosity/unoccluded_rows.h"

#include "radiosity/closed_form.h"
#include "radiosity/nusselt.h"
#include "radiosity/sample_positions.h"

namespace cg {

bool nothing_hides(const Patches& patches) {
  for (const Patch& p : patches.patches)
    for (const ElementVertex& v : patches.vertices)
      if (glm::dot(v.position - p.centre, p.normal) < -1e-9 * glm::length(v.position - p.centre)) return false;
  return !patches.patches.empty();
}

UnoccludedRows::UnoccludedRows(const Patches& patches, const Radiosity& options, bool normalise)
    : patches_(patches),
      nusselt_(options.form_factors == FormFactors::nusselt),
      samples_(options.samples),
      placement_(options.placement),
      normalise_(normalise) {}

double UnoccludedRows::factor(const Patch& from, const Patch& to) const {
  const auto corners = [](const Patch& p) { return std::span(p.corner.data(), std::size_t(p.corners)); };
  if (!nusselt_) return polygon_form_factor(corners(from), corners(to));
  double sum = 0;
  for (const SamplePosition& p : sample_positions(from, samples_, placement_))
    sum += p.weight * nusselt_projection(p.position, from.normal, corners(to)).form_factor;
  return sum;
}

FormFactorRow UnoccludedRows::row(const Patch& part, std::uint32_t own, const Progress& progress) const {
  FormFactorRow row;
  if (!(part.area > 0)) return row;
  for (std::uint32_t j = 0; j < patches_.patches.size(); ++j) {
    if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    if (j == own || !(patches_.patches[j].area > 0)) continue;
    const double f = factor(part, patches_.patches[j]);
    if (!(float(f) > 0)) continue;
    row.factors.push_back({j, float(f)});
    row.sum += f;
  }
  if (normalise_ && row.sum > 0)
    for (FormFactor& f : row.factors) f.value = float(double(f.value) / row.sum);
  return row;
}

}  // namespace cg
