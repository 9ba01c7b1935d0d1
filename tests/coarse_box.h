// The Cornell box, so coarse that its radiosity is solved in a moment.
#pragma once
#include "workbench/open.h"

namespace cg {

inline Scene coarse_box() {
  Scene s = open_scene("models/cornell-box.json");
  s.radiosity.patch_size = 0.5, s.radiosity.resolution = 16, s.radiosity.samples = 1;
  return s;
}

}  // namespace cg
