// Form factors of polygons with nothing between them, to the digits of double.
// This work is based on: Johann Heinrich Lambert, Photometria, 1760 (a surface element and a polygon); Peter Schroeder
// and Pat Hanrahan, On the Form Factor between Two Polygons, 1993 (two polygons by a double contour integral).
#pragma once
#include <span>
#include <vector>

#include "math/vec.h"

namespace cg {

// The share of the light leaving the surface element at `point` to the side of `normal` (unit) that falls on the front
// of `polygon`: plane and convex, counter-clockwise seen from its front, any size and distance. 0..1; 0 where the point
// is in its plane or behind it. Near 1e-15 relative also for a polygon that is tiny seen from the point.
double point_form_factor(const glm::dvec3& point, const glm::dvec3& normal, std::span<const glm::dvec3> polygon);

// The share of the light leaving the front of `from` that falls on the front of `to`, both as above. They may touch,
// share an edge or lie partly behind each other's plane, where what lies behind counts nothing. Off by 1e-12 at most,
// and by 1e-12 of itself where neither is much smaller than the gap between them.
double polygon_form_factor(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to);

// The part of a convex polygon where dot(normal, p - origin) >= 0, corners in the same order; empty where there is
// none. Corners within `tolerance` of the plane count as on it.
std::vector<glm::dvec3> clipped_to_front(std::span<const glm::dvec3> polygon, const glm::dvec3& origin,
                                         const glm::dvec3& normal, double tolerance = 0);

}  // namespace cg
