// One term of the light model alone, by editing the scene: so it works in every technique.
#pragma once
#include "scene/scene.h"

namespace cg {

inline constexpr int all_lights = -1;  // and the global ambient light
inline constexpr int no_light = -2;    // only the global ambient light

// The scene in which only `term` is left, of the light with that index, of all_lights, or of no_light. Quantity::none
// leaves every term: of one light, the sum of its terms. Emission belongs to no light: it is there for all_lights and
// no_light. Without clamping, the pictures of the terms sum to the picture of the scene (where nothing is, the
// background is in each).
// A radiosity solution that is drawn is the ambient term, of no light; without it its elements are drawn in place of
// the objects' meshes.
Scene isolated(Scene scene, Quantity term, int light = all_lights);

}  // namespace cg
