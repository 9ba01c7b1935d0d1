#include "math/transform.h"

#include <algorithm>

#include "math/look_at_taken.h"

namespace cg {

glm::dmat4 translation(const glm::dvec3& t) {
  glm::dmat4 m(1);
  m[3] = glm::dvec4(t, 1);
  return m;
}

glm::dmat4 scaling(const glm::dvec3& s) {
  glm::dmat4 m(1);
  m[0][0] = s.x, m[1][1] = s.y, m[2][2] = s.z;
  return m;
}

glm::dmat4 rotation(double angle, const glm::dvec3& axis) {
  const glm::dvec3 a = unit(axis);
  if (a == glm::dvec3(0)) return glm::dmat4(1);
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  glm::dmat4 m(1);
  m[0] = {t * a.x * a.x + c, t * a.x * a.y + s * a.z, t * a.x * a.z - s * a.y, 0};
  m[1] = {t * a.x * a.y - s * a.z, t * a.y * a.y + c, t * a.y * a.z + s * a.x, 0};
  m[2] = {t * a.x * a.z + s * a.y, t * a.y * a.z - s * a.x, t * a.z * a.z + c, 0};
  return m;
}

namespace {

struct ViewAxes {
  glm::dvec3 forward, side;  // unit
};

// The axis least parallel to a view along `forward`.
glm::dvec3 other_up(const glm::dvec3& forward) {
  const glm::dvec3 a = glm::abs(forward);
  return a.y <= a.x && a.y <= a.z ? glm::dvec3(0, 1, 0) : a.z <= a.x ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
}

bool is_parallel(const glm::dvec3& side) { return glm::dot(side, side) < 1e-16; }

ViewAxes axes_of(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  glm::dvec3 forward = unit(target - eye);
  if (forward == glm::dvec3(0)) forward = {0, 0, -1};
  glm::dvec3 side = glm::cross(forward, unit(up));
  if (is_parallel(side)) side = glm::cross(forward, other_up(forward));
  return {forward, unit(side)};
}

}  // namespace

glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const auto [forward, side] = axes_of(eye, target, up);
  const glm::dvec3 above = glm::cross(side, forward);
  glm::dmat4 m(1);
  for (int i = 0; i < 3; ++i) m[i] = {side[i], above[i], -forward[i], 0};
  m[3] = {-glm::dot(side, eye), -glm::dot(above, eye), glm::dot(forward, eye), 1};
  return m;
}

LookAt look_at_taken(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const glm::dvec3 forward = axes_of(eye, target, up).forward;
  const bool no_view = unit(target - eye) == glm::dvec3(0), no_up = is_parallel(glm::cross(forward, unit(up)));
  return {no_view ? eye + forward : target, no_up ? other_up(forward) : up};
}

namespace {

struct Depths {
  double near_plane, far_plane;
};

Depths ordered(double near_plane, double far_plane, double smallest) {
  if (!(near_plane > smallest)) near_plane = smallest;
  if (!(far_plane > near_plane * (1 + 1e-6))) far_plane = near_plane * (1 + 1e-6) + 1e-300;
  return {near_plane, far_plane};
}

double limited(double v, double low, double high) { return v >= low ? std::min(v, high) : low; }

}  // namespace

glm::dmat4 perspective(double fov, double aspect, double near_plane, double far_plane) {
  const auto [n, f] = ordered(near_plane, far_plane, 1e-30);
  const double cotangent = 1 / std::tan(limited(fov, 1e-3, pi - 1e-3) / 2);
  glm::dmat4 m(0);
  m[0][0] = cotangent / limited(aspect, 1e-6, 1e6);
  m[1][1] = cotangent;
  m[2][2] = -(f + n) / (f - n);
  m[2][3] = -1;
  m[3][2] = -2 * f * n / (f - n);
  return m;
}

glm::dmat4 orthographic(double height, double aspect, double near_plane, double far_plane) {
  const double n = near_plane, f = far_plane > near_plane ? far_plane : near_plane + 1e-6;
  const double h = limited(height, 1e-30, 1e30);
  glm::dmat4 m(1);
  m[0][0] = 2 / (h * limited(aspect, 1e-6, 1e6));
  m[1][1] = 2 / h;
  m[2][2] = -2 / (f - n);
  m[3][2] = -(f + n) / (f - n);
  return m;
}

glm::dmat3 normal_matrix(const glm::dmat4& m) {
  const glm::dvec3 a(m[0]), b(m[1]), c(m[2]);
  const glm::dmat3 cofactors(glm::cross(b, c), glm::cross(c, a), glm::cross(a, b));
  const double determinant = glm::dot(a, cofactors[0]);
  if (std::isfinite(1 / determinant)) return cofactors * (1 / determinant);
  return determinant < 0 ? -cofactors : cofactors;
}

}  // namespace cg
