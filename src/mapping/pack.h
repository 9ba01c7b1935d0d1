// Charts laid out in the unit square.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace cg {

struct FlatPiece {
  std::vector<glm::dvec2> flat;
  std::vector<std::array<std::uint32_t, 3>> triangle;  // indices into it
};

// Turns and moves the pieces, and enlarges all alike, as much as fits: inside the unit square, `margin` (a share of its
// side) apart and half of it from its edge. A margin that leaves no room is made smaller. None is mirrored.
void pack(std::vector<FlatPiece>& pieces, double margin);

// Turns the points so that their bounding box is the smallest.
void turn_to_smallest_box(std::vector<glm::dvec2>& points);

}  // namespace cg
