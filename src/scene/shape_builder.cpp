#include "scene/shape_builder.h"

#include <algorithm>

#include "math/transform.h"

namespace cg {

void ShapeBuilder::face(std::span<const ShapeCorner> corners) {
  const auto index = [](Numbering& number, const auto& value, auto& list) {
    const std::uint32_t i = number(BitsAndIndex(glm::dvec3(value)));
    if (i == list.size()) list.push_back(value);
    return i;
  };
  std::vector<Corner> face;
  for (const ShapeCorner& c : corners) {
    const std::uint32_t position = index(positions_, c.position, data_.positions);
    if (!face.empty() && face.back().position == position) continue;
    const std::uint32_t uv = uvs_(BitsAndIndex(glm::dvec3(c.uv, 0)));
    if (uv == data_.uvs.size()) data_.uvs.push_back(c.uv);
    face.push_back({position, index(normals_, c.normal, data_.normals), uv});
  }
  while (face.size() > 1 && face.back().position == face.front().position) face.pop_back();
  if (face.size() >= 3) data_.add_face(face.data(), face.data() + face.size());
}

void ShapeBuilder::fit() {
  glm::dvec3 low = data_.positions.front(), high = low;
  for (const glm::dvec3& p : data_.positions) low = glm::min(low, p), high = glm::max(high, p);
  const glm::dvec3 centre = 0.5 * (low + high);
  double radius = 0;
  for (const glm::dvec3& p : data_.positions) radius = std::max(radius, glm::length(p - centre));
  for (glm::dvec3& p : data_.positions) p = (p - centre) / radius;
}

Turn turn(long i, long n) {
  const long k = ((i % n) + n) % n;
  const long quarter = 4 * k / n, rest = 4 * k - quarter * n;  // the angle is (quarter + rest/n) pi/2
  const auto sine_to_45_degrees = [n](long r) { return std::sin(pi / 2 * double(r) / double(n)); };
  const auto cosine_to_45_degrees = [n](long r) { return std::cos(pi / 2 * double(r) / double(n)); };
  const bool steep = 2 * rest > n;
  const double c = steep ? sine_to_45_degrees(n - rest) : cosine_to_45_degrees(rest);
  const double s = steep ? cosine_to_45_degrees(n - rest) : sine_to_45_degrees(rest);
  switch (quarter) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace cg
