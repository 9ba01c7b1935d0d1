#include "measure/tessellations.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"
#include "scene/shape.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

constexpr int steps = 8;

const Shape* turned_shape(const Object& object) { return object.visible ? find_shape(object.model) : nullptr; }

// `step` 0 is a quarter of the finest, and each further one sqrt(2) coarser. An icosphere's level counts halvings.
int level_at(const Shape& shape, double step) {
  const double halvings = 2 + step / 2;
  const double level = shape.id == "icosphere" ? shape.max_level - halvings : shape.max_level * std::exp2(-halvings);
  return int(std::lround(level));
}

bool in_range(const Shape& shape, int level) { return level >= shape.min_level && level <= shape.max_level; }

double edge_of(const Scene& scene) {
  double area = 0;
  std::size_t triangles = 0;
  for (const Object& object : scene.objects) {
    if (!turned_shape(object)) continue;
    const glm::dmat4 to_world = matrix(object.transform);
    const MeshData& data = object.mesh->data();
    const auto place = [&](std::uint32_t corner) {
      return glm::dvec3(to_world * glm::dvec4(data.positions[data.corners[corner].position], 1));
    };
    for (const Triangle& t : object.mesh->triangles()) {
      const glm::dvec3 a = place(t.corner[0]);
      area += 0.5 * length_and_unit(glm::cross(place(t.corner[1]) - a, place(t.corner[2]) - a)).length;
    }
    triangles += object.mesh->triangles().size();
  }
  return triangles ? std::sqrt(2 * area / double(triangles)) : 0;
}

Tessellation cut(const Scene& scene, int level) {
  Tessellation out{level, 0, scene};
  load_meshes(out.scene);
  out.h = edge_of(out.scene);
  return out;
}

}  // namespace

Tessellations tessellations_of(const Scene& scene) {
  const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), turned_shape);
  if (first == scene.objects.end())
    throw InputError("SCENE", {"no visible object has a tessellation", "細分割できる物体が見えていない"},
                     {"a shape works: teapot, uv-sphere, icosphere, torus, torus-knot",
                      "teapot、uv-sphere、icosphere、torus、torus-knot などの形が必要"});
  const std::size_t at = std::size_t(first - scene.objects.begin());
  Tessellations out;
  for (int step = 0; step < steps; ++step) {
    Scene coarser = scene;
    bool possible = true;
    for (Object& object : coarser.objects)
      if (const Shape* shape = turned_shape(object)) {
        object.tessellation = level_at(*shape, step);
        possible = possible && in_range(*shape, object.tessellation);
      }
    if (!possible) continue;
    const int level = coarser.objects[at].tessellation;
    if (out.ladder.empty() || level != out.ladder.back().level) out.ladder.push_back(cut(coarser, level));
  }
  Scene finest = scene;
  for (Object& object : finest.objects)
    if (const Shape* shape = turned_shape(object)) object.tessellation = shape->max_level;
  out.finest = {finest.objects[at].tessellation, 0, std::move(finest)};
  return out;
}

}  // namespace cg
