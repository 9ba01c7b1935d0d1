// Scenes and a slow, independent reference for the tests of OpenGL.
#pragma once
#include <cmath>
#include <string>

#include "gl/techniques.h"
#include "params/input_error.h"
#include "shading/clip_position.h"
#include "shading/eye_normal.h"
#include "shading/light_model.h"
#include "shading/surface_cache.h"

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

// An open square in the plane z = 0, facing +z, so that its back can be seen.
inline MeshHandle square_mesh() {
  MeshData d;
  d.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const Corner quad[4] = {
      {0, no_index, no_index}, {1, no_index, no_index}, {2, no_index, no_index}, {3, no_index, no_index}};
  d.add_face(quad, quad + 4);
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

// The colour at the centre of pixel (x, y) of the triangle that `frame` says is there, in double: its corners are
// lit (or its point is), and weighted by where the ray through the pixel meets the triangle's plane.
inline glm::dvec3 reference_colour(const Scene& scene, const Frame& frame, int x, int y) {
  const Object& object = scene.objects[std::size_t(frame.object.at(x, y))];
  const SurfaceHandle surface =
      surface_cache().get(object.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
  std::size_t t = 0;
  while (surface->triangle[t] != std::uint32_t(frame.triangle.at(x, y))) ++t;
  const glm::dmat4 view = view_matrix(scene.camera);
  const glm::dmat4 to_eye = surface_to_eye(scene, object, *surface);
  const auto normals = normals_to_eye<double>(view * matrix(object.transform), scene.shading.normal_length);
  glm::dvec3 P[3], N[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = surface->indices[3 * t + k];
    P[k] = glm::dvec3(to_eye * glm::dvec4(glm::dvec3(surface->positions[i]), 1));
    N[k] = eye_normal(normals, glm::dvec3(surface->normals[i]));
  }
  const int w = frame.colour.width(), h = frame.colour.height();
  const glm::dmat4 from_clip = glm::inverse(projection_matrix(scene.camera, double(w) / h));
  const double u = 2 * (x + 0.5) / w - 1, v = 1 - 2 * (y + 0.5) / h;
  const glm::dvec4 near_point = from_clip * glm::dvec4(u, v, -1, 1), far_point = from_clip * glm::dvec4(u, v, 1, 1);
  const glm::dvec3 a = glm::dvec3(near_point) / near_point.w, d = glm::dvec3(far_point) / far_point.w - a;
  const glm::dvec3 e1 = P[1] - P[0], e2 = P[2] - P[0], n = glm::cross(e1, e2);
  const glm::dvec3 hit = a + d * (glm::dot(P[0] - a, n) / glm::dot(d, n)) - P[0];
  const double b1 = glm::dot(glm::cross(hit, e2), n) / glm::dot(n, n),
               b2 = glm::dot(glm::cross(e1, hit), n) / glm::dot(n, n);
  const double side = scene.shading.two_sided && glm::dot(d, n) > 0 ? -1 : 1;
  const auto lighting = lighting_in_eye_space<double>(scene, view);
  const auto material = eye_material<double>(material_of(scene, object), scene.shading.color_material);
  if (scene.shading.mode == ShadingMode::phong) {
    glm::dvec3 M = N[0] * (1 - b1 - b2) + N[1] * b1 + N[2] * b2;
    if (normals.normalize) M = unit(M);
    return light_point(lighting, material, P[0] + hit, M * side);
  }
  glm::dvec3 c[3];
  for (int k = 0; k < 3; ++k) c[k] = light_point(lighting, material, P[k], N[k] * side);
  return scene.shading.mode == ShadingMode::flat ? c[2] : c[0] * (1 - b1 - b2) + c[1] * b1 + c[2] * b2;
}

struct Errors {
  double largest = 0;  // relative where the colour is over 1
  int pixels = 0;
};

// Over every `step`-th covered pixel. The frame needs ids.
inline Errors against_reference(const Scene& scene, const Frame& frame, int step = 7) {
  Errors e;
  int n = 0;
  for (int y = 0; y < frame.colour.height(); ++y)
    for (int x = 0; x < frame.colour.width(); ++x) {
      if (!frame.covered.at(x, y) || n++ % step != 0) continue;
      const glm::dvec3 right = reference_colour(scene, frame, x, y);
      for (int k = 0; k < 3; ++k) {
        const double off = std::abs(double(frame.colour.at(x, y)[k]) - right[k]) / std::max(1.0, std::abs(right[k]));
        e.largest = std::max(e.largest, off);
      }
      ++e.pixels;
    }
  return e;
}

}  // namespace cg
