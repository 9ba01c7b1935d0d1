// Extreme scenes, each with what its picture must be: the list that every technique is drawn through.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace cg {

using Change = std::function<void(Scene&)>;  // of a scene whose one object is a sphere under one point light

struct ExtremeCase {
  std::string name;
  Change change;
  Change same_as = {};             // the ordinary scene with the same picture; none: compare with the reference
  std::string note = {};           // what the plan must say
  Change fixed_same_as = same_as;  // the fixed function's, where it is another
  std::string fixed_note = note;
  bool flat = true;       // false: flat shading does not use what is changed
  bool denormal = false;  // GLSL may take denormal numbers as 0 (GLSL 4.60, section 4.7.1): only finite there
};

std::vector<ExtremeCase> extreme_lights();
std::vector<ExtremeCase> extreme_cones();
std::vector<ExtremeCase> extreme_materials();
std::vector<ExtremeCase> extreme_surfaces();
std::vector<ExtremeCase> extreme_cameras();

// The scene without lights.
void unlit(Scene& scene);

}  // namespace cg
