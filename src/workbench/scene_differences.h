// In which parameters two scenes differ: what a lecturer sees between presets A and B, and a grade lists.
#pragma once
#include <string>
#include <vector>

#include "params/field.h"
#include "params/tree.h"
#include "scene/scene.h"

namespace cg {

struct ParameterDifference {
  std::string path;              // "material.n", or of an item that only one scene has "lights.1"
  Tree a, b;                     // the values as JSON has them; null where the scene has no such item
  const About* about = nullptr;  // of the parameter; null for an item
  friend bool operator==(const ParameterDifference&, const ParameterDifference&) = default;
};

// In the order of slots(); items of a list that only one scene has stand behind those that both have, with their values
// that are not the defaults. 0 and -0 do not differ.
std::vector<ParameterDifference> scene_differences(const Scene& a, const Scene& b);

// "material.n 32 → 64", "lights.1 none → added".
Text text_of(const ParameterDifference& difference);

}  // namespace cg
