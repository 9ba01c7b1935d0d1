// "Match this picture": a target is hidden, the student turns the parameters until the pictures are alike.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace cg {

struct Challenge {
  Scene start, target;               // alike but for the parameters below; meshes are those of the scene it came from
  std::vector<std::string> offered;  // the paths of the parameters to turn, in the order of slots()
};

// The target is `scene`; the student begins with its models, camera and display, one light and the defaults for the
// rest.
Challenge challenge_of(const Scene& scene);

// A target that the program makes up for the models and the camera of `scene`: its own for each seed, and the same on
// every machine. `level` 1: the material's diffuse colour and exponent; 2: also its highlight and the ambient light;
// 3: also where the light stands and its colour. The numbers are short, so that they can be hit exactly.
Challenge made_up_challenge(const Scene& scene, std::uint64_t seed, int level);

}  // namespace cg
