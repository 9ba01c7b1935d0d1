// This work is based on: Adriaan van Oosterom and Jan Strackee, The Solid Angle of a Plane Triangle, 1983.
#include "math/transform.h"
#include "radiosity/faces.h"

namespace cg {

namespace {

constexpr std::size_t most_solid_angles = 4000000;

// In the plane of a triangle's points the solid angle jumps by 4 pi: what lies there within rounding is not asked.
constexpr double in_plane = 1e-12;

// Of the triangle a, b, c from the origin, positive where they are counter-clockwise. Sets `inside` where the origin
// lies on the triangle.
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool& inside) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double volume = glm::dot(a, glm::cross(b, c)), lengths = la * lb * lc;
  const double rest = lengths + glm::dot(a, b) * lc + glm::dot(a, c) * lb + glm::dot(b, c) * la;
  if (std::abs(volume) <= in_plane * lengths) {
    inside = inside || rest <= in_plane * lengths;
    return 0;
  }
  return 2 * std::atan2(volume, rest);
}

// Whether all faces together have 4 pi just in front of face i; true too where another face lies upon it there.
bool surrounded(const std::vector<SurfaceFace>& faces, std::size_t i) {
  glm::dvec3 middle(0);
  for (int k = 0; k < faces[i].corners; ++k) middle += faces[i].corner[std::size_t(k)].position;
  middle /= double(faces[i].corners);
  double sum = 2 * pi;  // its own
  bool on_another = false;
  for (std::size_t j = 0; j < faces.size(); ++j) {
    if (j == i) continue;
    const auto p = positions_of(faces[j]);
    for (int k = 1; k + 1 < faces[j].corners; ++k)
      sum -= solid_angle(p[0] - middle, p[std::size_t(k)] - middle, p[std::size_t(k + 1)] - middle, on_another);
  }
  return on_another || std::abs(sum - 4 * pi) < 1e-6;
}

}  // namespace

bool enclosed(const std::vector<SurfaceFace>& faces, const Progress& progress) {
  if (faces.empty()) return false;
  const std::size_t asked = std::max<std::size_t>(most_solid_angles / faces.size(), 16);
  const std::size_t step = std::max<std::size_t>((faces.size() + asked - 1) / asked, 1);
  for (std::size_t i = 0; i < faces.size(); i += step) {
    if (progress.cancelled) throw Cancelled{};
    if (!surrounded(faces, i)) return false;
  }
  return true;
}

}  // namespace cg
