// Where a vertex stands in clip space, in float: one definition for software and OpenGL, so that both snap the
// same vertices to the same sub-pixel and the same triangle wins each pixel.
//
// The rule: view, object and Surface::to_mesh() are multiplied in double and rounded once (object_to_eye); so is
// the projection. Their product is then made in float, column by column, in the order of glMultMatrix (Mesa's
// _math_matrix_mul_matrix does the same with GL_PROJECTION and GL_MODELVIEW), and a position is transformed as
// ((m0 x + m1 y) + m2 z) + m3, without fused multiply-adds. A shader that says
//   gl_Position = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3]
// with this matrix as its uniform gets the same bits.
#pragma once
#include <cmath>

#include "math/transform.h"
#include "scene/scene.h"
#include "shading/surface.h"

namespace cg {

// Surface to eye coordinates, in double: round it once where it is used (lighting) or sent to OpenGL.
inline glm::dmat4 surface_to_eye(const Scene& scene, const Object& object, const Surface& surface) {
  return view_matrix(scene.camera) * matrix(object.transform) * surface.to_mesh();
}

// Eye to clip coordinates of a picture of width x height pixels, rounded once.
inline glm::mat4 eye_to_clip(const Scene& scene, int width, int height) {
  return glm::mat4(projection_matrix(scene.camera, double(width) / double(height > 0 ? height : 1)));
}

// Surface to clip coordinates.
inline glm::mat4 surface_to_clip(const glm::mat4& eye_to_clip, const glm::mat4& surface_to_eye) {
  glm::mat4 m;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      m[column][row] = ((eye_to_clip[0][row] * surface_to_eye[column][0] +  //
                         eye_to_clip[1][row] * surface_to_eye[column][1]) +
                        eye_to_clip[2][row] * surface_to_eye[column][2]) +
                       eye_to_clip[3][row] * surface_to_eye[column][3];
  return m;
}

// Whether an object with these two matrices can be drawn at all: all of their numbers are finite.
inline bool can_be_placed(const glm::mat4& surface_to_eye, const glm::mat4& surface_to_clip) {
  for (const glm::mat4& m : {surface_to_eye, surface_to_clip})
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!std::isfinite(m[c][r])) return false;
  return true;
}

// A position of Surface::positions in clip space.
inline glm::vec4 clip_position(const glm::mat4& surface_to_clip, const glm::vec3& p) {
  const glm::mat4& m = surface_to_clip;
  return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
}

}  // namespace cg
