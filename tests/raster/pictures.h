// Small meshes and one call to draw them, for the tests of this room.
#pragma once
#include "raster/software.h"

namespace cg::testing {

inline Corner corner(std::uint32_t position) { return {position, no_index, no_index}; }

// One triangle.
inline MeshHandle triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  MeshData d;
  d.positions = {a, b, c};
  const std::array<Corner, 3> face{corner(0), corner(1), corner(2)};
  d.add_face(face.data(), face.data() + 3);
  return Mesh::make(std::move(d));
}

// A torus about the y axis, radii 1 and 0.4, of 2 n m triangles.
inline MeshHandle torus(std::uint32_t n, std::uint32_t m) {
  MeshData d;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, r = 1 + 0.4 * std::cos(v);
      d.positions.push_back({r * std::cos(u), 0.4 * std::sin(v), -r * std::sin(u)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return corner((i % n) * m + j % m); };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::array<Corner, 3> a{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
          b{at(i, j), at(i + 1, j + 1), at(i, j + 1)};
      d.add_face(a.data(), a.data() + 3);
      d.add_face(b.data(), b.data() + 3);
    }
  return Mesh::make(std::move(d));
}

inline Scene scene_of(MeshHandle mesh) {
  Scene scene;
  scene.objects.emplace_back().mesh = std::move(mesh);
  return scene;
}

inline Frame draw(const Scene& scene, const View& view) {
  static const Technique software = software_technique();
  Progress progress;
  return software.render(scene, software.plan(scene, view), view, progress);
}

inline std::size_t covered(const Frame& frame) {
  std::size_t n = 0;
  for (const std::uint8_t c : frame.covered.pixels()) n += c;
  return n;
}

}  // namespace cg::testing
