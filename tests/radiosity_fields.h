// Radiosity solutions with known light, for tests that draw them.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "math/transform.h"
#include "scene/scene.h"

namespace cg {

// The mesh with each face cut in as many quads as it has corners, `times` times over; positions are not shared.
inline MeshHandle cut_mesh(const Mesh& mesh, int times) {
  MeshData data = mesh.data();
  for (int t = 0; t < times; ++t) {
    MeshData next;
    for (std::size_t f = 0; f < data.face_count(); ++f) {
      const std::uint32_t first = data.first_corner[f], n = data.first_corner[f + 1] - first;
      const auto at = [&](std::uint32_t k) { return data.positions[data.corners[first + k % n].position]; };
      glm::dvec3 centre(0);
      for (std::uint32_t k = 0; k < n; ++k) centre += at(k) / double(n);
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t p = std::uint32_t(next.positions.size());
        for (const glm::dvec3& v : {at(k), 0.5 * (at(k) + at(k + 1)), centre, 0.5 * (at(k + n - 1) + at(k))})
          next.positions.push_back(v);
        const Corner quad[4] = {{p, no_index, no_index},
                                {p + 1, no_index, no_index},
                                {p + 2, no_index, no_index},
                                {p + 3, no_index, no_index}};
        next.add_face(quad, quad + 4);
      }
    }
    data = std::move(next);
  }
  return Mesh::make(std::move(data));
}

// Light at a point of an object's mesh, and its face's unit normal, both in the object's coordinates.
using LightAt = std::function<glm::vec3(const glm::dvec3& point, const glm::dvec3& normal)>;

inline glm::vec3 smooth_light(const glm::dvec3& p, const glm::dvec3& n) {
  return glm::vec3(0.3 + 0.2 * std::sin(3 * p.x + n.y), 0.3 + 0.2 * std::cos(2 * p.y + n.z), 0.25 + 0.2 * n.x * p.z);
}

// Of each of the scene's objects, or of those named alone.
inline RadiosityHandle cut_field(const Scene& scene, int times, const LightAt& light,
                                 const std::vector<std::size_t>& only = {}) {
  const auto field = std::make_shared<RadiosityField>();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    ObjectRadiosity& out = field->objects.emplace_back();
    const MeshHandle& mesh = scene.objects[i].mesh;
    if (!mesh || (!only.empty() && std::find(only.begin(), only.end(), i) == only.end())) continue;
    out.mesh = cut_mesh(*mesh, times), out.of = mesh;
    const MeshData& data = out.mesh->data();
    for (std::size_t f = 0; f < data.face_count(); ++f) {
      const auto at = [&](std::uint32_t c) { return data.positions[data.corners[c].position]; };
      const std::uint32_t first = data.first_corner[f], end = data.first_corner[f + 1];
      glm::dvec3 normal(0);  // Newell
      for (std::uint32_t c = first; c < end; ++c) normal += glm::cross(at(c), at(c + 1 < end ? c + 1 : first));
      for (std::uint32_t c = first; c < end; ++c) out.corners.push_back(light(at(c), unit(normal)));
    }
  }
  return field;
}

// The scene drawn with such light.
inline void take_radiosity(Scene& scene, const LightAt& light = smooth_light) {
  scene.radiosity_field = cut_field(scene, 1, light);
  scene.shading.ambient_source = AmbientSource::radiosity;
}

}  // namespace cg
