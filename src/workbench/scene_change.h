// Which kinds of things two scenes differ in: what must be computed again depends on that alone.
#pragma once
#include "scene/scene.h"

namespace cg {

struct SceneChange {
  bool geometry = false;  // objects, where they stand, which normals they have
  bool camera = false;
  bool light = false;      // lights and the light model's choices
  bool radiosity = false;  // the solution that is drawn
  bool material = false;
  bool background = false;
  bool display = false;  // how light becomes what a screen shows

  bool any() const { return geometry || camera || light || radiosity || material || background || display; }
  bool display_alone() const {
    return display && !(geometry || camera || light || radiosity || material || background);
  }
};

SceneChange scene_change(const Scene& a, const Scene& b);

// "the camera, the light"; empty where nothing changed.
Text text_of(const SceneChange& change);

}  // namespace cg
