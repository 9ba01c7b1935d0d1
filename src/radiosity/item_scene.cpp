#include "radiosity/item_scene.h"

#include <bit>

namespace cg {

namespace {

constexpr double in_plane = 1e-10;  // of the scene's size: what double leaves of coordinates that were computed

}  // namespace

ItemScene::ItemScene(std::span<const ItemPolygon> polygons) : polygons_(polygons), to_unit_(polygons) {
  groups_.assign((polygons.size() + wide - 1) / wide, Group{});
  rests_.assign(groups_.size(), Rests{});
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    Group& g = groups_[i / wide];
    Rests& r = rests_[i / wide];
    const int lane = int(i % wide);
    const ItemPolygon p = to_unit_(polygons[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::vec3 rounded(p[k]), rest(p[k] - glm::dvec3(rounded));
      g.x[k][lane] = rounded.x, g.y[k][lane] = rounded.y, g.z[k][lane] = rounded.z;
      r.x[k][lane] = rest.x, r.y[k][lane] = rest.y, r.z[k][lane] = rest.z;
    }
    const glm::dvec3 n = unit(area_vector(p));
    g.normal_x[lane] = n.x, g.normal_y[lane] = n.y, g.normal_z[lane] = n.z;
    g.offset[lane] = glm::dot(n, (p[0] + p[1] + p[2] + p[3]) * 0.25);
  }
}

// Of its highest corner over the plane; `flat` where all of them lie in it. Scaled units.
double ItemScene::height(std::uint32_t polygon, const glm::dvec3& point, const glm::dvec3& normal, bool& flat) const {
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const glm::dvec3& c : polygons_[polygon]) {
    const double h = glm::dot(to_unit_(c) - point, normal);
    low = std::min(low, h), high = std::max(high, h);
  }
  flat = high <= in_plane && low >= -in_plane;
  return high;
}

void ItemScene::find_above(const glm::dvec3& point, const glm::dvec3& normal, Horizon& out) const {
  constexpr float rounding = 4e-6f;  // of a height in float
  const glm::dvec3 c = to_unit_(point);
  const glm::vec3 n(normal);
  const float offset = float(glm::dot(c, normal));
  out.above.assign(groups_.size(), 0);
  out.lying_on.clear();
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& g = groups_[i];
    WideFloats highest = WideFloats{} - 10.0f;
    for (std::size_t k = 0; k < 4; ++k) {
      const WideFloats h = g.x[k] * n.x + g.y[k] * n.y + g.z[k] * n.z - offset;
      highest = h > highest ? h : highest;
    }
    const std::size_t count = std::min<std::size_t>(wide, polygons_.size() - i * wide);
    std::uint32_t above = 0, doubtful = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
      above |= std::uint32_t(highest[lane] > rounding) << lane;
      doubtful |= std::uint32_t(highest[lane] >= -rounding && highest[lane] <= rounding) << lane;
    }
    for (; doubtful != 0; doubtful &= doubtful - 1) {
      const int lane = std::countr_zero(doubtful);
      const auto polygon = std::uint32_t(i * wide + std::size_t(lane));
      bool flat = false;
      if (height(polygon, c, normal, flat) > in_plane) above |= 1u << lane;
      const glm::dvec3 its_normal(g.normal_x[lane], g.normal_y[lane], g.normal_z[lane]);
      if (flat && glm::dot(its_normal, normal) < -0.5) out.lying_on.push_back(polygon);
    }
    out.above[i] = std::uint16_t(above);
  }
}

void ItemScene::find_fronts(const glm::dvec3& position, const Horizon& horizon,
                            std::vector<std::uint16_t>& fronts) const {
  const glm::dvec3 eye = to_unit_(position);
  fronts.resize(groups_.size());
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& g = groups_[i];
    const Wide<double> height = g.normal_x * eye.x + g.normal_y * eye.y + g.normal_z * eye.z - g.offset;
    std::uint32_t in_front = 0;
    for (int lane = 0; lane < wide; ++lane) in_front |= std::uint32_t(height[lane] > edge_on) << lane;
    fronts[i] = std::uint16_t(fronts[i] | (in_front & horizon.above[i]));
  }
}

bool ItemScene::lies_on(std::uint32_t patch, const glm::dvec3& position) const {
  const ItemPolygon& p = polygons_[patch];
  const glm::dvec3 normal = area_vector(p);
  for (std::size_t k = 0; k < 4; ++k)
    if (glm::dot(glm::cross(p[(k + 1) % 4] - p[k], position - p[k]), normal) < 0) return false;
  return true;
}

}  // namespace cg
