// Whether a chart's border crosses itself in the plane. A disk without flipped triangles whose border does not covers
// each point once.
#pragma once
#include <glm/vec2.hpp>
#include <span>

namespace cg {

// The closed polygon has no two sides that cross or touch, neighbours' common corner aside.
bool is_simple_polygon(std::span<const glm::dvec2> corners);

}  // namespace cg
