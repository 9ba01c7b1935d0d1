#include "scene/polygon.h"

#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "scene/ear_clipping.h"

namespace cg {

glm::dvec3 vector_area(std::span<const glm::dvec3> polygon) {
  glm::dvec3 twice(0);
  if (polygon.size() < 3) return twice;
  glm::dvec3 edge = polygon[1] - polygon[0];
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const glm::dvec3 next = polygon[i] - polygon[0];
    twice += glm::cross(edge, next);
    edge = next;
  }
  return 0.5 * twice;
}

namespace {

using Index = std::uint32_t;

double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double power_of_two_above(double v) {
  int exponent = 0;
  std::frexp(v, &exponent);
  return std::ldexp(1.0, std::clamp(exponent, -1020, 1020));
}

// The polygon relative to its first corner and scaled by powers of two to an extent of about 1, so that neither
// its squares nor its differences leave double's range.
std::vector<glm::dvec3> at_unit_size(std::span<const glm::dvec3> polygon) {
  double largest = 0, extent = 0;
  for (const glm::dvec3& p : polygon) largest = std::max(largest, largest_component(p));
  const double scale = power_of_two_above(largest);
  std::vector<glm::dvec3> out(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out[i] = polygon[i] / scale - polygon[0] / scale;
    extent = std::max(extent, largest_component(out[i]));
  }
  if (extent > 0)
    for (glm::dvec3& p : out) p /= power_of_two_above(extent);
  return out;
}

// Seen along the largest component of the normal, counter-clockwise; the coordinates stay as they are.
std::vector<glm::dvec2> project(std::span<const glm::dvec3> polygon, const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<glm::dvec2> out;
  out.reserve(polygon.size());
  for (const glm::dvec3& p : polygon) out.emplace_back(p[u], p[v]);
  return out;
}

// Whether each triangle of the fan around the last corner has an area on the polygon's side.
bool fan_fits(std::span<const glm::dvec3> polygon, const glm::dvec3& normal) {
  const glm::dvec3& last = polygon.back();
  for (std::size_t i = 0; i + 2 < polygon.size(); ++i) {
    const glm::dvec3 a = polygon[i] - last, b = polygon[i + 1] - last;
    const double larger = std::max(glm::dot(a, a), glm::dot(b, b));
    if (!(glm::dot(glm::cross(a, b), normal) > 1e-13 * larger)) return false;
  }
  return true;
}

// The normal of a polygon that at_unit_size gave.
glm::dvec3 normal_at_unit_size(std::span<const glm::dvec3> polygon) {
  const auto [area, normal] = length_and_unit(vector_area(polygon));
  return area > 0x1p-48 ? normal : glm::dvec3(0);
}

}  // namespace

glm::dvec3 polygon_normal(std::span<const glm::dvec3> polygon) {
  return polygon.size() < 3 ? glm::dvec3(0) : normal_at_unit_size(at_unit_size(polygon));
}

bool triangulate(std::span<const glm::dvec3> polygon, std::vector<std::array<Index, 3>>& triangles) {
  if (polygon.size() < 3) return false;
  const std::vector<glm::dvec3> points = at_unit_size(polygon);
  const glm::dvec3 normal = normal_at_unit_size(points);
  if (normal == glm::dvec3(0)) return false;
  const Index n = Index(polygon.size()), last = n - 1;
  if (n == 3 || fan_fits(points, normal)) {
    for (Index i = 0; i + 1 < last; ++i) triangles.push_back({i, i + 1, last});
    return true;
  }
  const std::size_t first = triangles.size();
  clip_ears(project(points, normal), triangles);
  for (std::size_t i = first; i < triangles.size(); ++i)
    std::rotate(triangles[i].begin(), std::max_element(triangles[i].begin(), triangles[i].end()) + 1,
                triangles[i].end());
  return true;
}

}  // namespace cg
