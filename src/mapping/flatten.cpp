#include "mapping/flatten.h"

#include <cmath>

#include "mapping/flip_free.h"
#include "mapping/simple_border.h"

namespace cg {

namespace {

FlatPositions laid_flat(const ChartMesh& disk, UnwrapMethod method) {
  std::optional<FlatPositions> out;
  if (method == UnwrapMethod::lscm) out = least_squares_conformal(disk);
  if (method == UnwrapMethod::spectral) out = spectral_conformal(disk);
  if (method == UnwrapMethod::free_boundary) out = free_boundary_map(disk);
  return out ? *out : mean_value_map(disk);
}

}  // namespace

FlatChart flatten(const ChartMesh& disk, UnwrapMethod method) {
  FlatChart out;
  out.flat = laid_flat(disk, method);
  out.distortion = distortion_of(disk, out.flat);
  const double area = out.distortion.flat_area;
  if (area > 0) {
    const double scale = std::sqrt(out.distortion.surface_area / area);
    for (glm::dvec2& p : out.flat) p *= scale;
    out.distortion = distortion_of(disk, out.flat);
  }
  FlatPositions border;
  if (disk.loops.size() == 1)
    for (const std::uint32_t v : disk.loops.front()) border.push_back(out.flat[v]);
  out.simple_border = !border.empty() && is_simple_polygon(border);
  return out;
}

}  // namespace cg
