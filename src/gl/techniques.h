// OpenGL as techniques: gl-fixed, the fixed function, and gl, the light model in GLSL. Both draw off screen, each
// on a thread and in a context of its own.
#pragma once
#include <vector>

#include "scene/technique.h"

namespace cg {

// Cheap: thread and context are made at the first render. Whether there is a driver for it is known only then:
// render throws InputError with the reason, and from then on `unsupported` gives it for every scene. To know
// before there is something to draw, use find_availability.
std::vector<Technique> gl_techniques();

// Makes the context if there is none yet, and sets technique.unavailable to the reason where it cannot be made.
void find_availability(Technique& technique);

}  // namespace cg
