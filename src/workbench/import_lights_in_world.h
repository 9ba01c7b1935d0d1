// OpenGL keeps lights in eye coordinates: brought back into the world, with the numbers as they were written.
#pragma once
#include "scene/scene.h"
#include "workbench/import_machine.h"

namespace cg {

// The calls that are the viewing transform: those of the first thing that is drawn, up to gluLookAt; without one, what
// moves the first light, if it moves the things alike.
MatrixCalls view_of(const GlState& state);

// The scene's lights, and the mistakes and complaints about where they are given.
void place_lights(Scene& scene, const GlState& state, const MatrixCalls& view, Complaints& complaints);

}  // namespace cg
