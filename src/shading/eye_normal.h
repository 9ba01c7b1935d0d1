// How the normals of a surface come to eye space: one definition for software and OpenGL.
// The OpenGL Graphics System 2.1, section 2.11.3: n' = M^-T n, then nothing, GL_RESCALE_NORMAL or GL_NORMALIZE.
#pragma once
#include <algorithm>

#include "math/transform.h"
#include "scene/shading.h"

namespace cg {

template <class Real>
struct NormalTransform {
  Mat3<Real> matrix;  // the rescaling factor is in it
  bool normalize;     // bring the result to unit length; so does a pixel with the normal it interpolated
};

// `object_to_eye` without Surface::to_mesh(): storing a mesh in other units does not change its normals.
template <class Real>
NormalTransform<Real> normals_to_eye(const glm::dmat4& object_to_eye, NormalLength length) {
  glm::dmat3 m = normal_matrix(object_to_eye);
  if (length == NormalLength::rescale) {
    // GL's factor 1/sqrt(m31^2 + m32^2 + m33^2) has the third row of M^-1, which is the third column of M^-T.
    if (const double third = length_and_unit(m[2]).length; third > 0) m = m * (1 / third);
  } else if (length == NormalLength::normalize) {
    // Only the direction counts: keep the numbers inside float's range whatever the object's scale.
    double largest = 0;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
    if (largest > 0) m = m * (1 / largest);
  }
  return {Mat3<Real>(m), length == NormalLength::normalize};
}

// The normal N of the light model at a vertex with the normal `n`. 0 where there is no direction.
template <class Real>
Vec3<Real> eye_normal(const NormalTransform<Real>& t, const Vec3<Real>& n) {
  const Vec3<Real> N = t.matrix * n;
  return t.normalize ? unit(N) : N;
}

}  // namespace cg
