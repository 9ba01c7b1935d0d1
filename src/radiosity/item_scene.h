// The patches of a scene made ready to be drawn into hemicubes: which patch each pixel sees, by the software
// rasteriser. No polygon is ever clipped: the plane through the eye and an edge divides all directions, in front and
// behind, into those that may meet the polygon and those that do not, and the depth too is linear in the direction.
// Nearness needs no near plane, so patches may touch the eye's own. This work is based on: Marc Olano, Trey Greer,
// Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997.
#pragma once
#include <span>

#include "radiosity/hemicube_tiles.h"
#include "radiosity/unit_box.h"

namespace cg {

// Of a position's plane, the patches that rise above it: by groups of sixteen, a bit each.
struct Horizon {
  std::vector<std::uint16_t> above;
  // In the plane and facing it: such a patch takes all light of the positions that it lies on.
  std::vector<std::uint32_t> lying_on;
};

class ItemScene {
 public:
  // Polygons, convex and plane, one each patch; those without area are never seen. Lengths and offsets may be anything
  // that double holds. The polygons must outlive the scene.
  explicit ItemScene(std::span<const ItemPolygon> polygons);

  std::size_t size() const { return polygons_.size(); }
  std::size_t bytes() const { return groups_.capacity() * (sizeof(Group) + sizeof(Rests)); }

  // Patches in the plane itself (to 1e-10 of the scene's size) are not above it.
  void find_above(const glm::dvec3& point, const glm::dvec3& normal, Horizon& out) const;

  // Draws what rises above the horizon into `items`, which are cleared to its resolution: each pixel gets the nearest
  // patch that its centre sees. `fronts`, as Horizon::above: the drawn patches whose front the position sees are added.
  void draw(const HemicubeFrame& frame, const Horizon& horizon, int resolution, HemicubeItems& items,
            std::vector<std::uint16_t>& fronts) const;

  // Adds the patches above the horizon whose front the position sees.
  void find_fronts(const glm::dvec3& position, const Horizon& horizon, std::vector<std::uint16_t>& fronts) const;

  // Whether the patch, in whose plane the position is, contains it.
  bool lies_on(std::uint32_t patch, const glm::dvec3& position) const;

  // Nearer to a patch's plane than this the eye sees neither side of it. Scaled units.
  static constexpr double edge_on = 1e-13;

  // Sixteen patches; coordinates within -1..1.
  struct Group {
    WideFloats x[4], y[4], z[4];                        // corners
    Wide<double> normal_x, normal_y, normal_z, offset;  // of their planes: n . p = offset; all 0 without area
  };

  // What the corners, rounded to float, left.
  struct Rests {
    WideFloats x[4], y[4], z[4];
  };

 private:
  double height(std::uint32_t polygon, const glm::dvec3& point, const glm::dvec3& normal, bool& flat) const;

  std::span<const ItemPolygon> polygons_;
  UnitBox to_unit_;
  CacheAligned<Group> groups_;
  CacheAligned<Rests> rests_;
};

}  // namespace cg
