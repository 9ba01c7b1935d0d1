// Scenes for the tests of OpenGL.
#pragma once
#include <cmath>
#include <string>

#include "gl/techniques.h"
#include "measure/extreme_reference.h"
#include "params/input_error.h"
#include "shading/clip_position.h"
#include "shading/eye_normal.h"
#include "shading/light_model.h"
#include "shading/surface_cache.h"
#include "tests/square_mesh.h"

namespace cg {

inline MeshHandle sphere_mesh(int slices = 24, int stacks = 12, double radius = 1, glm::dvec3 centre = {0, 0, 0}) {
  MeshData d;
  for (int j = 0; j <= stacks; ++j)
    for (int i = 0; i < slices; ++i) {
      const double t = pi * j / stacks, p = 2 * pi * i / slices;
      d.positions.push_back(centre +
                            radius * glm::dvec3(std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)));
    }
  auto corner = [&](int i, int j) { return Corner{std::uint32_t(j * slices + i % slices), no_index, no_index}; };
  for (int j = 0; j < stacks; ++j)
    for (int i = 0; i < slices; ++i) {
      const Corner quad[4] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      if (j == 0) {
        const Corner tip[3] = {quad[0], quad[2], quad[3]};
        d.add_face(tip, tip + 3);
      } else if (j == stacks - 1) {
        const Corner tip[3] = {quad[0], quad[1], quad[2]};
        d.add_face(tip, tip + 3);
      } else {
        d.add_face(quad, quad + 4);
      }
    }
  return Mesh::make(std::move(d));
}

inline Scene scene_with(MeshHandle mesh) {
  Scene s;
  s.objects.emplace_back();
  s.objects[0].mesh = std::move(mesh);
  return s;
}

inline Frame draw(const Technique& t, const Scene& scene, const View& view) {
  Progress progress;
  return t.render(scene, t.plan(scene, view), view, progress);
}

inline View view_of(int width, int height, bool all = false) {
  View v;
  v.width = width, v.height = height, v.ids = v.normals = all;
  return v;
}

inline const Technique& find(const std::vector<Technique>& all, const std::string& id) {
  for (const Technique& t : all)
    if (t.id == id) return t;
  throw std::out_of_range(id);
}

}  // namespace cg
