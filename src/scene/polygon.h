// Polygons in space: their area as a vector, and their triangles.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace cg {

// The vector area of a closed polygon, planar or not: its length is the area, its direction the normal from
// which the corners are seen counter-clockwise (Newell's method, as in Sutherland, Sproull and Schumacker, A
// Characterization of Ten Hidden-Surface Algorithms, 1974, taken relative to the first corner).
glm::dvec3 vector_area(std::span<const glm::dvec3> polygon);

// The direction of vector_area, of unit length, for a polygon of any size; 0 where it has no area to speak of (below
// 2^-48 of its extent squared).
glm::dvec3 polygon_normal(std::span<const glm::dvec3> polygon);

// Triangles of a polygon as indices into it, counter-clockwise as the polygon. A fan around the last corner
// where that lies inside the polygon (always, if it is convex); else ears are clipped. A triangle that has the
// last corner ends with it; any other ends with its highest index. Triangles without area are left out. Returns
// false, and no triangle, where the polygon's normal is 0.
bool triangulate(std::span<const glm::dvec3> polygon, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace cg
