#include "scene/shape_builder.h"

#include <algorithm>

#include "math/transform.h"

namespace cg {

Corner ShapeBuilder::corner(const ShapeCorner& c) {
  const auto index = [](Numbering& number, const BitsAndIndex& key, const auto& value, auto& list) {
    const std::uint32_t i = number(key);
    if (i == list.size()) list.push_back(value);
    return i;
  };
  return {index(positions_, BitsAndIndex(c.position, part_), c.position, data_.positions),
          index(normals_, BitsAndIndex(c.normal), c.normal, data_.normals),
          index(uvs_, BitsAndIndex({c.uv, 0}), c.uv, data_.uvs)};
}

void ShapeBuilder::face(std::span<const Corner> corners) {
  const std::size_t begin = data_.corners.size();
  const auto size = [&] { return data_.corners.size() - begin; };
  for (const Corner& c : corners)
    if (size() == 0 || data_.corners.back().position != c.position) data_.corners.push_back(c);
  while (size() > 1 && data_.corners.back().position == data_.corners[begin].position) data_.corners.pop_back();
  if (size() >= 3)
    data_.first_corner.push_back(std::uint32_t(data_.corners.size()));
  else
    data_.corners.resize(begin);
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
