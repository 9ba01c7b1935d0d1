// Every point inside the convex hull of two convex polygons lies between a point of one and a point of the other: so a
// third polygon hides some of one from the other exactly where a part of it is inside.
#include "radiosity/known_factor.h"

#include <algorithm>

#include "math/transform.h"
#include "radiosity/closed_form.h"

namespace cg {

namespace {

using Polygon = std::vector<glm::dvec3>;

// Relative to the hull's size: nearer to its boundary a patch only touches it.
constexpr double touching = 1e-9;

struct HalfSpace {
  glm::dvec3 origin, outward;  // unit
};

std::span<const glm::dvec3> corners_of(const Patch& p) { return {p.corner.data(), std::size_t(p.corners)}; }

// The planes through three of the points that have all of them on one side. Both sides of it where all lie in one.
std::vector<HalfSpace> hull_of(const Polygon& points, double size) {
  std::vector<HalfSpace> out;
  const auto add = [&](const glm::dvec3& origin, const glm::dvec3& n) {
    const auto beyond = [&](const glm::dvec3& p) { return glm::dot(n, p - origin) > touching * size; };
    if (std::none_of(points.begin(), points.end(), beyond)) out.push_back({origin, n});
  };
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        const glm::dvec3 n = glm::cross(points[b] - points[a], points[c] - points[a]);
        if (!(glm::length(n) > touching * size * size)) continue;
        add(points[a], unit(n));
        add(points[a], -unit(n));
      }
  return out;
}

// Whether a part of the patch, more than an edge, is inside.
bool reaches_inside(const Patch& patch, const std::vector<HalfSpace>& hull, double size) {
  const auto corners = corners_of(patch);
  for (const HalfSpace& h : hull) {
    const auto outside = [&](const glm::dvec3& p) { return glm::dot(h.outward, p - h.origin) >= -touching * size; };
    if (std::all_of(corners.begin(), corners.end(), outside)) return false;
  }
  Polygon rest(corners.begin(), corners.end());
  for (const HalfSpace& h : hull) {
    rest = clipped_to_front(rest, h.origin - touching * size * h.outward, -h.outward);
    if (rest.size() < 3) return false;
  }
  glm::dvec3 area(0);
  for (std::size_t k = 1; k + 1 < rest.size(); ++k) area += glm::cross(rest[k] - rest[0], rest[k + 1] - rest[0]);
  return glm::length(area) > touching * touching * size * size;
}

std::uint32_t first_between(const Patches& patches, std::uint32_t i, std::uint32_t j, const Polygon& points) {
  double size = 0;
  for (const glm::dvec3& p : points) size = std::max(size, glm::distance(p, points.front()));
  const std::vector<HalfSpace> hull = hull_of(points, size);
  if (hull.empty()) return no_item;
  for (std::uint32_t k = 0; k < patches.patches.size(); ++k)
    if (k != i && k != j && patches.patches[k].area > 0 && reaches_inside(patches.patches[k], hull, size)) return k;
  return no_item;
}

}  // namespace

KnownFactor known_factor(const Patches& patches, std::uint32_t i, std::uint32_t j) {
  const Patch &a = patches.patches[i], &b = patches.patches[j];
  KnownFactor out{polygon_form_factor(corners_of(a), corners_of(b))};
  if (!(out.value > 0)) return out;
  Polygon seen = clipped_to_front(corners_of(a), b.corner[0], b.normal);
  const Polygon other = clipped_to_front(corners_of(b), a.corner[0], a.normal);
  seen.insert(seen.end(), other.begin(), other.end());
  out.between = first_between(patches, i, j, seen);
  return out;
}

KnownFactor known_factor(const Patches& patches, std::uint32_t i, const glm::dvec3& point, std::uint32_t j) {
  const Patch &a = patches.patches[i], &b = patches.patches[j];
  KnownFactor out{point_form_factor(point, a.normal, corners_of(b))};
  if (!(out.value > 0)) return out;
  Polygon cone = clipped_to_front(corners_of(b), point, a.normal);
  cone.push_back(point);
  out.between = first_between(patches, i, j, cone);
  return out;
}

}  // namespace cg
