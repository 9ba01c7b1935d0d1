// Where the light model departs from what a scene says, so that no picture comes out NaN: for the plan's notes.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace cg {

// One note for each light that is on and whose w is next to 0, or whose attenuation is a division by zero.
std::vector<Text> light_notes(const Scene& scene);

}  // namespace cg
