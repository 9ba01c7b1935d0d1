// Which patch a ray meets first: a tree of boxes, eight in a node, with eight patches in a leaf.
// This work is based on: Ingo Wald, Carsten Benthin, Solomon Boulos, Getting Rid of Packets: Efficient SIMD
// Single-Ray Traversal using Multi-branching BVHs, 2008.
#pragma once
#include <span>
#include <vector>

#include "radiosity/unit_box.h"
#include "raster/lanes.h"

namespace cg {

class PatchTree {
 public:
  // Convex, plane polygons; those without area are never met.
  explicit PatchTree(std::span<const ItemPolygon> polygons);

  // The item that a ray meets, as scene/item_drawer.h numbers it. Only patches whose bit is set in `wanted` (sixteen a
  // word, as Horizon::above) are there. `direction` is unit.
  std::uint32_t first_met(const glm::dvec3& origin, const glm::dvec3& direction,
                          const std::vector<std::uint16_t>& wanted) const;

 private:
  static constexpr std::uint32_t leaf_bit = 0x80000000u, no_child = 0xffffffffu;
  struct alignas(64) Node {
    Lanes<float> low[3], high[3];
    std::array<std::uint32_t, lanes> child;  // a node, or leaf_bit and a leaf
  };
  struct alignas(64) Leaf {
    Lanes<float> corner[4][3], normal[3];
    std::array<std::uint32_t, lanes> patch;
  };
  struct Box {
    glm::vec3 low, high;
  };
  struct Hit {
    float distance;
    std::uint32_t item;
  };
  struct Ray {
    glm::vec3 origin, direction, inverse;
  };

  std::uint32_t build(std::uint32_t* begin, std::uint32_t* end, const std::vector<glm::vec3>& centres, Box& box);
  std::uint32_t make_leaf(const std::uint32_t* begin, const std::uint32_t* end, Box& box);
  void meet(const Leaf& leaf, const Ray& ray, const std::vector<std::uint16_t>& wanted, Hit& nearest) const;

  std::span<const ItemPolygon> polygons_;
  UnitBox to_unit_;
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::uint32_t root_ = no_child;
};

}  // namespace cg
