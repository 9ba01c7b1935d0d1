#include "workbench/import_matrices.h"

#include <algorithm>
#include <cmath>

namespace cg {

namespace {

glm::dvec3 vector(const MatrixCall& c, std::size_t from = 0) {
  return {c.numbers[from], c.numbers[from + 1], c.numbers[from + 2]};
}

glm::dmat4 matrix_of(const MatrixCall& c) {
  switch (c.kind) {
    case MatrixCall::look_at:
      return look_at(vector(c), vector(c, 3), vector(c, 6));
    case MatrixCall::translate:
      return translation(vector(c));
    case MatrixCall::rotate:
      return rotation(radians(c.numbers[0]), vector(c, 1));
    case MatrixCall::scale:
      return scaling(vector(c));
    case MatrixCall::matrix:
      break;
  }
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = c.numbers[std::size_t(i)];
  return m;
}

// Of a rotation about a coordinate axis: which, and the angle with the axis' sign.
struct AxisTurn {
  int axis = -1;
  double degrees = 0;
};
AxisTurn axis_turn(const MatrixCall& c) {
  const glm::dvec3 axis = vector(c, 1);
  for (int i = 0; i < 3; ++i)
    if (axis[i] != 0 && axis[(i + 1) % 3] == 0 && axis[(i + 2) % 3] == 0)
      return {i, axis[i] > 0 ? c.numbers[0] : -c.numbers[0]};
  return {};
}

// The place of a call in T Rz Ry Rx S.
int place_of(const MatrixCall& c) {
  if (c.kind == MatrixCall::translate) return 0;
  if (c.kind == MatrixCall::scale) return 4;
  const int axis = c.kind == MatrixCall::rotate ? axis_turn(c).axis : -1;
  return axis < 0 ? -1 : 3 - axis;
}

std::optional<Transform> as_written(std::span<const MatrixCall> calls) {
  Transform t;
  int last = -1;
  for (const MatrixCall& c : calls) {
    const int place = place_of(c);
    if (place <= last) return std::nullopt;
    last = place;
    if (c.kind == MatrixCall::translate) t.translate = vector(c);
    if (c.kind == MatrixCall::scale) t.scale = vector(c);
    if (c.kind == MatrixCall::rotate) t.rotate[axis_turn(c).axis] = axis_turn(c).degrees;
  }
  return t;
}

bool is_rigid(const glm::dmat3& m) {
  const glm::dmat3 square = glm::transpose(m) * m;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(square[c][r] - (c == r)) < 1e-9)) return false;
  return glm::determinant(m) > 0;
}

bool is_affine(const glm::dmat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

// v to 12 digits of the largest that it stands beside.
double rounded(double v, double beside) {
  if (v == 0 || !std::isfinite(v) || !(beside > 0) || !std::isfinite(beside)) return v + 0.0;  // no -0
  const int digits = 11 - int(std::floor(std::log10(beside)));
  if (digits < -200 || digits > 200) return v;
  // Divided by a power of ten or multiplied by it, whichever is exact: 0.3 is 3/10.
  const double power = std::pow(10.0, std::abs(digits));
  const double short_one = digits > 0 ? std::round(v * power) / power : std::round(v / power) * power;
  return short_one + 0.0;
}

}  // namespace

glm::dvec3 short_numbers(glm::dvec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  for (int i = 0; i < 3; ++i) v[i] = rounded(v[i], largest);
  return v;
}

glm::dmat4 product(std::span<const MatrixCall> calls) {
  glm::dmat4 m(1);
  for (const MatrixCall& c : calls) m = m * matrix_of(c);
  return m;
}

std::size_t view_length(std::span<const MatrixCall> calls) {
  for (std::size_t i = calls.size(); i > 0; --i)
    if (calls[i - 1].kind == MatrixCall::look_at) return i;
  return 0;
}

std::optional<Transform> transform_of(std::span<const MatrixCall> calls) {
  if (const auto t = as_written(calls)) return t;
  const glm::dmat4 m = product(calls);
  if (!is_affine(m)) return std::nullopt;
  Transform t;
  glm::dmat3 r(m);
  for (int i = 0; i < 3; ++i) {
    t.scale[i] = length_and_unit(r[i]).length;
    if (!(t.scale[i] > 0) || !std::isfinite(t.scale[i])) return std::nullopt;
    r[i] = unit(r[i]);
  }
  if (glm::determinant(r) < 0) t.scale.x = -t.scale.x, r[0] = -r[0];
  if (!is_rigid(r)) return std::nullopt;
  // R = Rz Ry Rx: its lowest row is (-sin y, cos y sin x, cos y cos x).
  const double cosine = std::hypot(r[0][0], r[0][1]);
  t.rotate.y = degrees(std::atan2(-r[0][2], cosine));
  if (cosine > 1e-12) {
    t.rotate.x = degrees(std::atan2(r[1][2], r[2][2]));
    t.rotate.z = degrees(std::atan2(r[0][1], r[0][0]));
  } else {
    t.rotate.x = degrees(std::atan2(-r[2][1], r[1][1]));
  }
  t.translate = short_numbers(glm::dvec3(m[3]));
  for (int i = 0; i < 3; ++i)
    t.rotate[i] = rounded(t.rotate[i], 180), t.scale[i] = rounded(t.scale[i], std::abs(t.scale[i]));
  return t;
}

bool set_view(Camera& camera, std::span<const MatrixCall> calls) {
  if (calls.size() == 1 && calls[0].kind == MatrixCall::look_at) {
    camera.position = vector(calls[0]), camera.target = vector(calls[0], 3), camera.up = vector(calls[0], 6);
    return true;
  }
  const glm::dmat4 v = product(calls);
  if (!is_affine(v) || !is_rigid(glm::dmat3(v))) return false;
  const glm::dmat4 world = glm::inverse(v);
  const glm::dvec3 eye(world[3]), forward(-world[2]);
  // The point of the line of sight that is nearest to the origin, where that lies ahead.
  const double ahead = -glm::dot(eye, forward);
  camera.position = short_numbers(eye);
  camera.target = short_numbers(eye + forward * (ahead > 1e-6 ? ahead : 1.0));
  camera.up = short_numbers(glm::dvec3(world[1]));
  return true;
}

}  // namespace cg
