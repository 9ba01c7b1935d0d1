// Scenes that tests build by hand.
#pragma once
#include <string>
#include <vector>

#include "radiosity/patches.h"
#include "scene/scene.h"
#include "scene/shape.h"

namespace cg::testing {

// An object of polygons, each with corners of its own.
inline Object object_of(const std::vector<std::vector<glm::dvec3>>& polygons, const std::string& name = "polygons") {
  MeshData data;
  for (const auto& polygon : polygons) {
    std::vector<Corner> face;
    for (const glm::dvec3& p : polygon) {
      face.push_back({.position = std::uint32_t(data.positions.size())});
      data.positions.push_back(p);
    }
    data.add_face(face.data(), face.data() + face.size());
  }
  Object object;
  object.name = name;
  object.mesh = Mesh::make(std::move(data));
  return object;
}

inline Object shape_object(const char* id, int level = 0) {
  Object object;
  object.name = object.model = id;
  object.mesh = make_shape(*find_shape(id), level);
  return object;
}

inline Scene scene_of(std::vector<Object> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

// The rectangle corner, corner + u, corner + u + v, corner + v; its front is where u x v points.
inline std::vector<glm::dvec3> rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  return {corner, corner + u, corner + u + v, corner + v};
}

// The six walls of the box 0..size, seen from inside.
inline std::vector<std::vector<glm::dvec3>> room(const glm::dvec3& s) {
  return {rectangle({0, 0, 0}, {0, 0, s.z}, {s.x, 0, 0}), rectangle({0, s.y, 0}, {s.x, 0, 0}, {0, 0, s.z}),
          rectangle({0, 0, 0}, {s.x, 0, 0}, {0, s.y, 0}), rectangle({0, 0, s.z}, {0, s.y, 0}, {s.x, 0, 0}),
          rectangle({0, 0, 0}, {0, s.y, 0}, {0, 0, s.z}), rectangle({s.x, 0, 0}, {0, 0, s.z}, {0, s.y, 0})};
}

inline Patches patches_of(const Scene& scene, double size) {
  Progress progress;
  return make_patches(scene, {.patch_size = size}, progress);
}

}  // namespace cg::testing
