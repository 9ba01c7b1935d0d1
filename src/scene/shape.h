// The shapes that the program makes itself, each at the fineness one asks for.
#pragma once
#include <span>
#include <string_view>

#include "params/words.h"
#include "scene/mesh.h"

namespace cg {

struct Shape {
  std::string_view id;  // "torus": what a scene calls it
  Words label;
  int level;  // its own choice of fineness; what a level counts is told beside the shape's maker
  int min_level, max_level;
};

std::span<const Shape> shapes();

// The shape of that id, or null.
const Shape* find_shape(std::string_view id);

// The shape with its box centred on the origin and all of it inside the unit ball, y up, faces counter-clockwise
// seen from outside, with the exact unit normal of the curved surface and a uv in 0..1 at each corner. Level 0 is
// the shape's own; any other is limited to its range.
MeshHandle make_shape(const Shape& shape, int level = 0);

}  // namespace cg
