// The scene from outside: the camera, the lights and the mesh.
#include "ui/layout.h"

namespace cg {

void draw_world_panel(App&) {}

}  // namespace cg
