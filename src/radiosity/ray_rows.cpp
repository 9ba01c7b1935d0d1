#include "radiosity/ray_rows.h"

#include "math/counter_random.h"
#include "math/transform.h"

namespace cg {

namespace {

// Evenly over the patch, for a point of the unit square: two triangles, each as often as it is large.
glm::dvec3 point_of(const Patch& patch, glm::dvec2 square) {
  const auto& c = patch.corner;
  std::size_t second = 1;
  if (patch.corners == 4) {
    const double a = glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
    const double b = glm::length(glm::cross(c[2] - c[0], c[3] - c[0]));
    const double first = a / (a + b);
    second = square.x < first ? 1 : 2;
    square.x = second == 1 ? square.x / first : (square.x - first) / (1 - first);
  }
  const double along = std::sqrt(square.x);
  return c[0] + along * (c[second] - c[0] + square.y * (c[second + 1] - c[second]));
}

// Distributed by the cosine, in a hemicube's frame.
glm::dvec3 cosine_direction(const glm::dvec2& square) {
  const double r = std::sqrt(square.y), angle = 2 * pi * square.x;
  return {r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - square.y)};
}

}  // namespace

RayRows::RayRows(std::span<const ItemPolygon> polygons, const Radiosity& options, bool normalise)
    : scene_(polygons), tree_(polygons), rays_(std::uint32_t(options.rays)), normalise_(normalise) {}

FormFactorRow RayRows::row(const Patch& part, std::uint32_t own, const Progress& progress) const {
  if (!(part.area > 0)) return {};
  RowSums& sums = rooms_.local();
  sums.begin(scene_, part, own);
  sums.fronts = sums.horizon.above;
  const HemicubeFrame frame = hemicube_frame(part.centre, part.normal);
  const std::uint64_t positions = random_key(own, 0), directions = random_key(own, 1);
  const double share = 1.0 / rays_;
  for (std::uint32_t r = 0; r < rays_; ++r) {
    if (r % 1024 == 0 && progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    const glm::dvec3 from = point_of(part, stratified_point(r, rays_, positions));
    std::uint32_t met = sums.lying_on(scene_, from);
    if (met == no_item) {
      const glm::dvec3 d = cosine_direction(stratified_point(r, rays_, directions));
      met = tree_.first_met(from, d.x * frame.x + d.y * frame.y + d.z * frame.z, sums.horizon.above);
    }
    (met < from_behind ? sums.of_patch[met] : met == no_item ? sums.rest.nothing : sums.rest.behind) += share;
  }
  return sums.finish(normalise_);
}

}  // namespace cg
