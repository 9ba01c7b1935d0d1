// This work is based on: Ivan Sutherland and Gary Hodgman, Reentrant Polygon Clipping, 1974.
#include "radiosity/face_box.h"

#include <algorithm>

namespace cg {

namespace {

struct Polygon {
  std::array<glm::vec3, 8> corner;  // four, and one more for each plane
  int count = 0;
  void add(const glm::vec3& p) { corner[std::size_t(count++)] = p; }
};

// Inwards, of the planes through the eye and the four sides of each face.
using Planes = std::array<glm::vec3, 4>;
constexpr std::array<Planes, 5> planes_of{{
    {{{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}},
    {{{1, -1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, -1}}},
    {{{-1, -1, 0}, {-1, 1, 0}, {0, 0, 1}, {-1, 0, -1}}},
    {{{-1, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 1, -1}}},
    {{{-1, -1, 0}, {1, -1, 0}, {0, 0, 1}, {0, -1, -1}}},
}};

Polygon clipped_by(const glm::vec3& plane, const Polygon& in) {
  Polygon out;
  for (int i = 0; i < in.count; ++i) {
    const glm::vec3 &a = in.corner[std::size_t(i)], &b = in.corner[std::size_t((i + 1) % in.count)];
    const float at_a = glm::dot(plane, a), at_b = glm::dot(plane, b);
    if (at_a >= 0) out.add(a);
    if ((at_a >= 0) != (at_b >= 0)) out.add(a + at_a / (at_a - at_b) * (b - a));
  }
  return out;
}

}  // namespace

std::optional<FaceBox> face_box(HemicubeFace face, const std::array<glm::vec3, 4>& corners) {
  Polygon polygon;
  for (const glm::vec3& c : corners) polygon.add(c);
  for (const glm::vec3& plane : planes_of[std::size_t(face)]) {
    polygon = clipped_by(plane, polygon);
    if (polygon.count == 0) return std::nullopt;
  }
  FaceBox box{2, 2, -2, -2};
  for (int i = 0; i < polygon.count; ++i) {
    const glm::vec3& c = polygon.corner[std::size_t(i)];
    FacePoint<float> p{0, 0};
    float w = 0;
    project_to_face(face, c.x, c.y, c.z, p.s, p.t, w);
    // The eye itself: all of the face.
    if (!std::isfinite(p.s) || !std::isfinite(p.t)) return FaceBox{-1, -1, 1, 1};
    box = {std::min(box.low_s, p.s), std::min(box.low_t, p.t), std::max(box.high_s, p.s), std::max(box.high_t, p.t)};
  }
  return box;
}

}  // namespace cg
