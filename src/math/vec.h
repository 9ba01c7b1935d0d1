// Vectors in the two scalar types, and the operations that stay finite where the textbook's do not.
#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace cg {

template <class Real>
using Vec2 = glm::vec<2, Real>;
template <class Real>
using Vec3 = glm::vec<3, Real>;
template <class Real>
using Vec4 = glm::vec<4, Real>;
template <class Real>
using Mat3 = glm::mat<3, 3, Real>;
template <class Real>
using Mat4 = glm::mat<4, 4, Real>;

// max(x, 0), with NaN becoming 0.
template <class Real>
constexpr Real positive(Real x) {
  return x > Real(0) ? x : Real(0);
}

// x limited to 0..1, with NaN becoming 0.
template <class Real>
constexpr Real saturate(Real x) {
  const Real p = positive(x);  // two steps become two instructions, without a branch
  return p < Real(1) ? p : Real(1);
}

template <class Real>
constexpr Vec3<Real> saturate(const Vec3<Real>& v) {
  return {saturate(v.x), saturate(v.y), saturate(v.z)};
}

template <class Real>
bool is_finite(const Vec3<Real>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class Real>
struct LengthAndUnit {
  Real length;
  Vec3<Real> unit;
};

// |v| and v/|v|. The squares of 1e±20 leave float's range, so such vectors are scaled by their largest
// component first. A zero vector, or one with a NaN or an infinity, has length 0 and unit (0, 0, 0).
template <class Real>
LengthAndUnit<Real> length_and_unit(const Vec3<Real>& v) {
  const Real square = glm::dot(v, v);
  constexpr Real tiny = sizeof(Real) == 4 ? Real(1e-30) : Real(1e-280);
  constexpr Real huge = sizeof(Real) == 4 ? Real(1e30) : Real(1e280);
  if (square > tiny && square < huge) {
    const Real length = std::sqrt(square);
    return {length, v / length};
  }
  const Real largest = std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
  if (!(largest > Real(0)) || !is_finite(v)) return {Real(0), Vec3<Real>(Real(0))};
  const Vec3<Real> scaled = v / largest;
  const Real length = std::sqrt(glm::dot(scaled, scaled));
  return {length * largest, scaled / length};
}

// v/|v|, or (0, 0, 0) where there is no direction.
template <class Real>
Vec3<Real> unit(const Vec3<Real>& v) {
  return length_and_unit(v).unit;
}

}  // namespace cg
