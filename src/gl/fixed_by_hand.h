// The colours of a student's own light model (shading/own_light_model.h), for the mistakes that the fixed function
// cannot make.
#pragma once
#include "gl/fixed_player.h"
#include "shading/surface.h"

namespace cg {

// One colour for each vertex, from the lights, the material, and the modelview matrix that OpenGL has now. Without
// either of the two mistakes it is OpenGL's own lighting of one side.
std::vector<glm::vec3> colours_by_hand(const Surface& surface, MeshBody::Normals normals, const Mistakes& mistakes);

}  // namespace cg
