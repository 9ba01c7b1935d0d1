// What a camera's gluLookAt has to be told where the given directions are none.
#pragma once
#include <glm/vec3.hpp>

namespace cg {

struct LookAt {
  glm::dvec3 target, up;
};

// The target and the up that look_at (math/transform.h) takes: the given ones, or what stands for them where the eye is
// at its target or the up is parallel to the view. gluLookAt itself has no such care.
LookAt look_at_taken(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

}  // namespace cg
