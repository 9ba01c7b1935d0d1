// Rooms and pairs of squares whose radiosity is known, or shows something.
#pragma once
#include <vector>

#include "scene/bundled_scene.h"

namespace cg {

// parallel-squares, perpendicular-squares, closed-cube, sphere-interior, furnished-room, corridor. Walls face into the
// room, furniture outwards; all but the squares are closed.
std::vector<BundledScene> radiosity_scenes();

}  // namespace cg
