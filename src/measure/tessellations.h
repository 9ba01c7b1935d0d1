// A scene at several finenesses of its shapes, for the knobs that turn the tessellation.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace cg {

struct Tessellation {
  int level;  // of the first shape of the scene
  double h;   // the edge of an average triangle, metres: sqrt(2 area / triangles) of all visible shapes; 0: not known
  Scene scene;
};

struct Tessellations {
  std::vector<Tessellation> ladder;  // h ascending
  Tessellation finest;               // h is not computed and the meshes are not loaded: they are large
};

// Every visible shape is cut at the same share of its finest level, from a quarter of it on down by sqrt(2) a step;
// objects from files stay as they are. Their meshes are loaded. Throws InputError where no
// visible object is a shape.
Tessellations tessellations_of(const Scene& scene);

}  // namespace cg
