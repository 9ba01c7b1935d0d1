// Where the light model departs from what a scene says, so that no picture comes out NaN: for the plan's notes.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace cg {

// Where a material has k_r or k_t.
inline constexpr Words needs_rays_note = {"k_r I_r and k_t I_t need ray tracing: left out",
                                          "k_r I_r と k_t I_t はレイトレーシングが必要なので省く"};

// One note for each light that is on and whose w is next to 0, or whose attenuation is a division by zero.
std::vector<Text> light_notes(const Scene& scene);

}  // namespace cg
