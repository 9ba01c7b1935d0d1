// Ear clipping of a polygon in the plane (Meisters, Polygons Have Ears, 1975), with the reflex corners in a k-d
// tree, so that each of the O(n) tests for an ear asks only the corners near it.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace cg {

// Appends the triangles of a simple counter-clockwise polygon, as indices into it. Corners may touch (a hole
// joined by a bridge). Where edges cross it still ends, with triangles that overlap.
void clip_ears(std::span<const glm::dvec2> polygon, std::vector<std::array<std::uint32_t, 3>>& triangles);

// Twice the signed area of a triangle, positive when counter-clockwise, with the right sign for coordinates
// whose differences are exact (Kahan's difference of products).
double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

}  // namespace cg
