// The software reference: the pipeline of the lecture, one pass after the other, on the processor.
#pragma once
#include "scene/technique.h"

namespace cg {

// id "software". Draws every scene whose meshes are loaded. Shading::precision is the type that lights and
// interpolates; where a triangle falls in the picture is float in both, as it is in OpenGL. Refuses pictures of more
// than 2^28 pixels.
Technique software_technique();

}  // namespace cg
