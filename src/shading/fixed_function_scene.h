// The scene as OpenGL's fixed function computes it: within its limits, and with the mistakes that were put in on
// purpose. The list of calls (gl_calls.h) says the same to OpenGL; this is for whoever computes it after OpenGL.
#pragma once
#include "scene/scene.h"

namespace cg {

inline constexpr double gl_shininess_limit = 128;

// Lights beyond the eighth are off, no exponent is over 128, and of the mistakes those with normal lengths and
// reflectances are made: GL_NORMALIZE that is missing, and reflectances that OpenGL has by itself where glColor was
// meant to set them. Lights stand where they were meant to; see below.
Scene as_fixed_function(Scene scene);

// The mistakes that move lights, as a scene with other lights or another camera: its lights in eye coordinates are
// those that OpenGL has.
Scene with_mistaken_lights(Scene scene);

}  // namespace cg
