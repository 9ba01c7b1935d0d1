#include "measure/extreme_reference.h"

#include <cmath>

#include "measure/extreme.h"
#include "shading/clip_position.h"
#include "shading/eye_normal.h"
#include "shading/light_model.h"
#include "shading/surface_cache.h"

namespace cg {

namespace {

// A triangle of a surface in eye space.
struct EyeTriangle {
  glm::dvec3 P[3], N[3];
  bool normalize;
};

EyeTriangle eye_triangle(const Scene& scene, const Object& object, std::uint32_t triangle) {
  const SurfaceHandle surface =
      surface_cache().get(object.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
  std::size_t t = 0;
  while (surface->triangle[t] != triangle) ++t;
  const glm::dmat4 to_eye = surface_to_eye(scene, object, *surface);
  const auto normals =
      normals_to_eye<double>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
  EyeTriangle out{{}, {}, normals.normalize};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t i = surface->indices[3 * t + k];
    out.P[k] = glm::dvec3(to_eye * glm::dvec4(glm::dvec3(surface->positions[i]), 1));
    out.N[k] = eye_normal(normals, glm::dvec3(surface->normals[i]));
  }
  return out;
}

struct Ray {
  glm::dvec3 origin, direction;
};

Ray ray_through(const Scene& scene, const Frame& frame, int x, int y) {
  const int w = frame.colour.width(), h = frame.colour.height();
  const glm::dmat4 from_clip = glm::inverse(projection_matrix(scene.camera, double(w) / h));
  const double u = 2 * (x + 0.5) / w - 1, v = 1 - 2 * (y + 0.5) / h;
  const glm::dvec4 near_point = from_clip * glm::dvec4(u, v, -1, 1), far_point = from_clip * glm::dvec4(u, v, 1, 1);
  const glm::dvec3 a = glm::dvec3(near_point) / near_point.w;
  return {a, glm::dvec3(far_point) / far_point.w - a};
}

}  // namespace

glm::dvec3 reference_colour(const Scene& scene, const Frame& frame, int x, int y) {
  const Object& object = scene.objects[std::size_t(frame.object.at(x, y))];
  const EyeTriangle e = eye_triangle(scene, object, std::uint32_t(frame.triangle.at(x, y)));
  const auto [a, d] = ray_through(scene, frame, x, y);
  const glm::dvec3 e1 = e.P[1] - e.P[0], e2 = e.P[2] - e.P[0], n = glm::cross(e1, e2);
  const glm::dvec3 hit = a + d * (glm::dot(e.P[0] - a, n) / glm::dot(d, n)) - e.P[0];
  const double b1 = glm::dot(glm::cross(hit, e2), n) / glm::dot(n, n),
               b2 = glm::dot(glm::cross(e1, hit), n) / glm::dot(n, n);
  const double side = scene.shading.two_sided && glm::dot(d, n) > 0 ? -1 : 1;
  const auto lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  const auto material = eye_material<double>(material_of(scene, object), scene.shading.color_material);
  if (scene.shading.mode == ShadingMode::phong) {
    glm::dvec3 M = e.N[0] * (1 - b1 - b2) + e.N[1] * b1 + e.N[2] * b2;
    if (e.normalize) M = unit(M);
    return light_point(lighting, material, e.P[0] + hit, M * side);
  }
  glm::dvec3 c[3];
  for (int k = 0; k < 3; ++k) c[k] = light_point(lighting, material, e.P[k], e.N[k] * side);
  return scene.shading.mode == ShadingMode::flat ? c[2] : c[0] * (1 - b1 - b2) + c[1] * b1 + c[2] * b2;
}

double colour_error(const glm::dvec3& a, const glm::dvec3& b) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const double off = std::abs(a[c] - b[c]) / std::max(1.0, std::abs(b[c]));
    if (is_worse(off, largest)) largest = off;
  }
  return largest;
}

ReferenceError against_reference(const Scene& scene, const Frame& frame, int step) {
  ReferenceError e;
  int n = 0;
  for (int y = 0; y < frame.colour.height(); ++y)
    for (int x = 0; x < frame.colour.width(); ++x) {
      if (!frame.covered.at(x, y) || n++ % step != 0) continue;
      const double off = colour_error(glm::dvec3(frame.colour.at(x, y)), reference_colour(scene, frame, x, y));
      if (is_worse(off, e.largest)) e.largest = off, e.x = x, e.y = y;
      ++e.pixels;
    }
  return e;
}

}  // namespace cg
