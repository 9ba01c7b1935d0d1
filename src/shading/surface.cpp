#include "shading/surface.h"

#include <cmath>

#include "scene/cpu_clock.h"
#include "scene/numbering.h"
#include "shading/corner_normals.h"

namespace cg {

namespace {

// Centre and radius as Surface describes them.
void choose_frame(const Mesh& mesh, Surface& surface) {
  const double radius = length_and_unit(mesh.high() * 0.5 - mesh.low() * 0.5).length;
  const glm::dvec3 centre = mesh.centre();
  if (length_and_unit(centre).length > 16 * radius) surface.centre = centre;
  if (radius > 0 && (radius < 0x1p-10 || radius > 0x1p10)) surface.radius = std::ldexp(1.0, std::ilogb(radius));
}

// In float, without leaving its range: a normal of 1e±40 keeps its direction.
glm::vec3 in_float(const glm::dvec3& n) {
  const double length = length_and_unit(n).length;
  return glm::vec3(length > 1e30 || length < 1e-30 ? unit(n) : n);
}

glm::vec3 within_range(const glm::vec3& v) { return glm::clamp(v, glm::vec3(-1e30f), glm::vec3(1e30f)); }
glm::vec2 within_range(const glm::dvec2& v) { return glm::vec2(glm::clamp(v, glm::dvec2(-1e30), glm::dvec2(1e30))); }

}  // namespace

SurfaceHandle make_surface(const Mesh& mesh, NormalRule rule, double crease_angle,
                           const std::vector<glm::vec3>* radiosity, std::span<const CornerUv> uv) {
  const double begin = thread_cpu_ms();
  const auto surface = std::make_shared<Surface>();
  choose_frame(mesh, *surface);
  const std::vector<std::uint32_t> point = weld_positions(mesh);
  const std::vector<glm::dvec3> normals = corner_normals(mesh, point, rule, crease_angle);

  const MeshData& data = mesh.data();
  Numbering vertices(point.size()), lit_vertices(radiosity ? point.size() : 0);
  std::vector<Numbering> mapped_vertices(uv.size(), Numbering(point.size()));
  surface->uv.resize(uv.size());
  std::vector<std::uint32_t> vertex(data.corners.size(), no_index);
  const auto vertex_of = [&](std::uint32_t c) {
    if (vertex[c] != no_index) return vertex[c];
    const glm::vec3 normal = in_float(normals[c]);
    const std::uint32_t next = std::uint32_t(surface->positions.size());
    vertex[c] = rule == NormalRule::face ? next : vertices(BitsAndIndex(normal, point[data.corners[c].position]));
    if (radiosity && rule != NormalRule::face) vertex[c] = lit_vertices(BitsAndIndex((*radiosity)[c], vertex[c]));
    for (std::size_t s = 0; s < uv.size() && rule != NormalRule::face; ++s)
      vertex[c] = mapped_vertices[s](BitsAndIndex(glm::dvec3(uv[s][c], 0), vertex[c]));
    if (vertex[c] == next) {
      for (std::size_t s = 0; s < uv.size(); ++s) surface->uv[s].push_back(within_range(uv[s][c]));
      if (radiosity) surface->radiosity.push_back(within_range((*radiosity)[c]));
      surface->positions.emplace_back((data.positions[data.corners[c].position] - surface->centre) / surface->radius);
      surface->normals.push_back(normal);
      surface->bad_normals += normal == glm::vec3(0);
    }
    return vertex[c];
  };
  surface->indices.reserve(3 * mesh.triangles().size());
  surface->triangle.reserve(mesh.triangles().size());
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    for (const std::uint32_t c : mesh.triangles()[t].corner) surface->indices.push_back(vertex_of(c));
    surface->triangle.push_back(std::uint32_t(t));
  }
  surface->positions.shrink_to_fit(), surface->normals.shrink_to_fit(), surface->radiosity.shrink_to_fit();
  for (auto& set : surface->uv) set.shrink_to_fit();
  surface->made_ms = thread_cpu_ms() - begin;
  return surface;
}

}  // namespace cg
