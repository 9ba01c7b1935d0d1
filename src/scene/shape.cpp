#include "scene/shape.h"

#include <algorithm>
#include <array>

#include "scene/shape_makers.h"

namespace cg {

namespace {

struct Maker {
  Shape shape;
  MeshData (*make)(int level);
};

// Ordinary levels are fine enough to look smooth; the highest have a million triangles or so.
constexpr std::array<Maker, 9> makers{{
    {{"teapot", {"Teapot", "ティーポット"}, 10, 2, 128}, make_teapot},
    {{"uv-sphere", {"Sphere (uv)", "球（経線と緯線）"}, 64, 4, 1024}, make_uv_sphere},
    {{"icosphere", {"Sphere (icosahedron)", "球（正二十面体）"}, 3, 1, 8}, make_icosphere},
    {{"torus", {"Torus", "トーラス"}, 64, 6, 1000}, make_torus},
    {{"torus-knot", {"Torus knot", "トーラス結び目"}, 16, 3, 256}, make_torus_knot},
    {{"cube", {"Cube", "立方体"}, 1, 1, 256}, make_cube},
    {{"cylinder", {"Cylinder", "円柱"}, 48, 3, 1024}, make_cylinder},
    {{"cone", {"Cone", "円錐"}, 48, 3, 1024}, make_cone},
    {{"plane", {"Plane", "平面"}, 16, 1, 512}, make_plane},
}};

constexpr auto table = [] {
  std::array<Shape, makers.size()> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = makers[i].shape;
  return out;
}();

}  // namespace

std::span<const Shape> shapes() { return table; }

const Shape* find_shape(std::string_view id) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Shape& s) { return s.id == id; });
  return found == table.end() ? nullptr : &*found;
}

MeshHandle make_shape(const Shape& shape, int level) {
  const auto maker = std::find_if(makers.begin(), makers.end(), [&](const Maker& m) { return m.shape.id == shape.id; });
  return Mesh::make(maker->make(level == 0 ? shape.level : std::clamp(level, shape.min_level, shape.max_level)));
}

}  // namespace cg
