// Polygons moved and scaled in double so that they fit into -1..1: then float holds them, wherever they are.
#pragma once
#include <algorithm>
#include <limits>
#include <span>

#include "scene/item_drawer.h"

namespace cg {

struct UnitBox {
  glm::dvec3 centre{0};
  double scale = 1;

  explicit UnitBox(std::span<const ItemPolygon> polygons) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const ItemPolygon& p : polygons)
      for (const glm::dvec3& c : p) low = glm::min(low, c), high = glm::max(high, c);
    if (polygons.empty()) return;
    centre = low * 0.5 + high * 0.5;
    const glm::dvec3 half = high - centre;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) scale = 1 / largest;
  }
  glm::dvec3 operator()(const glm::dvec3& p) const { return (p - centre) * scale; }
  ItemPolygon operator()(const ItemPolygon& p) const {
    return {(*this)(p[0]), (*this)(p[1]), (*this)(p[2]), (*this)(p[3])};
  }
};

// Half the cross product of the diagonals: the area as a vector, also of a triangle that repeats its last corner.
inline glm::dvec3 area_vector(const ItemPolygon& p) { return 0.5 * glm::cross(p[2] - p[0], p[3] - p[1]); }

}  // namespace cg
