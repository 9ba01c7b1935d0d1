// What the mouse does to a picture: turn, shift and zoom the camera, drag lights, the wipe's edge, magnify pixels.
#pragma once
#include <optional>

#include "ui/pane_place.h"
#include "workbench/picking.h"

namespace cg {

struct App;

// What is going on between a press and its release.
struct Gesture {
  enum Kind { none, orbit, pan, light, wipe, region } kind = none;
  int side = 0;  // of the picture where it began
  ImVec2 start{0, 0};
  Handle handle;  // of a light, as it was at the start
  Light before;
  bool along_view = false;
};

// What the mouse points at.
struct Pointing {
  int side = -1;  // -1: at no picture
  glm::dvec2 pixel{0};
  std::optional<Handle> handle;
  bool on_wipe = false;
};

// Takes the mouse over a picture at `place`; call once for each picture of a frame. Changes the scene's camera and
// lights, `region`, and the wipe; a click asks about the pixel. `wipe`: the picture has a wipe's edge in it. `shapes`:
// what the camera must not cut off (the scene as it was drawn).
void take_mouse(App& app, Gesture& gesture, Pointing& pointing, Region& region, const Place& place, int side, bool wipe,
                const Scene& shapes);

// Moves the scene's camera; planes that cut nothing of the shapes off before do not afterwards.
void move_camera(App& app, const Camera& moved, const Scene& shapes);

}  // namespace cg
