#include "radiosity/row_sums.h"

#include <algorithm>
#include <bit>

namespace cg {

void RowSums::begin(const ItemScene& scene, const Patch& part, std::uint32_t own) {
  of_patch.assign(scene.size(), 0);
  rest = {};
  scene.find_above(part.centre, part.normal, horizon);
  horizon.above[own / wide] &= std::uint16_t(~(1u << own % wide));
  std::erase(horizon.lying_on, own);
  fronts.assign(horizon.above.size(), 0);
}

std::uint32_t RowSums::lying_on(const ItemScene& scene, const glm::dvec3& position) {
  for (const std::uint32_t patch : horizon.lying_on)
    if (scene.lies_on(patch, position)) {
      fronts[patch / wide] |= std::uint16_t(1u << patch % wide);
      return patch;
    }
  return no_item;
}

FormFactorRow RowSums::finish(bool normalise) const {
  FormFactorRow row;
  row.factors.reserve(std::size_t(std::count_if(of_patch.begin(), of_patch.end(), [](double f) { return f > 0; })));
  for (std::size_t p = 0; p < of_patch.size(); ++p)
    if (of_patch[p] > 0) {
      row.sum += of_patch[p];
      row.factors.push_back({std::uint32_t(p), float(of_patch[p])});
    }
  std::size_t seen = 0;
  for (const std::uint16_t f : fronts) seen += std::size_t(std::popcount(f));
  row.missed = std::uint32_t(seen > row.factors.size() ? seen - row.factors.size() : 0);
  const double met = row.sum + rest.behind;
  if (normalise && met > 0)
    for (FormFactor& f : row.factors) f.value = float(of_patch[f.patch] / met);
  return row;
}

}  // namespace cg
