// The state in which a program leaves OpenGL, as a scene.
#pragma once
#include "scene/scene.h"
#include "workbench/import_machine.h"

namespace cg {

// `whole`: the program has a main(), so that what it does not enable stays off. A mesh of the program's own is an
// object without a model and a name. Lights and transforms are those of the world.
Scene scene_of_state(const GlState& state, bool whole, Complaints& complaints);

}  // namespace cg
