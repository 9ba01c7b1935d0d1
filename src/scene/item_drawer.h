// Drawing which patch each pixel of a hemicube sees, as a callable: by the software rasteriser or by OpenGL.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "math/vec.h"

namespace cg {

// What a pixel sees: the number of a patch; that of a patch and `from_behind`, whose back takes the light and gives
// none; or nothing.
inline constexpr std::uint32_t no_item = 0xffffffffu, from_behind = 0x80000000u;

// Where a hemicube stands: z is the normal of the surface under it; x, y, z are unit and right-handed.
struct HemicubeFrame {
  glm::dvec3 position{0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  // Where in its pixel a sample stands, from the middle of the unfolded face's pixel: -1/2..1/2.
  double beside_s = 0, beside_t = 0;
  // The samples of the side faces' rows stand aside in turn, by row_stagger.
  bool staggered = false;
};

// Of a side face's rows of pixels one above the other, counted from pixel 0: how far their samples stand aside, in
// pixels along the row.
inline constexpr std::array<double, 4> row_stagger{-0.375, 0.125, -0.125, 0.375};

// A convex polygon, counter-clockwise seen from the front; a triangle repeats its last corner.
using ItemPolygon = std::array<glm::dvec3, 4>;

// The five faces, in the order top, right, left, upper, lower (radiosity/hemicube.h), each row by row from the bottom
// of the unfolded cross.
using ItemFaces = std::array<std::vector<std::uint32_t>, 5>;

// Draws the polygons `drawn` (a bit each; item numbers are indices of polygons) as seen from the frame.
// Called from several threads at once.
using DrawItems =
    std::function<void(const HemicubeFrame& frame, int resolution, const std::vector<bool>& drawn, ItemFaces& out)>;
// Takes the polygons of a scene, which must outlive what it returns.
using MakeDrawItems = std::function<DrawItems(std::span<const ItemPolygon> polygons)>;

}  // namespace cg
