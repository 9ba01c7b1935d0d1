#include "workbench/overlay.h"

#include <algorithm>
#include <array>

#include "shading/surface_cache.h"
#include "workbench/camera_control.h"

namespace cg {

namespace {

constexpr int circle_steps = 48;

void add(Lines& lines, const glm::dvec3& a, const glm::dvec3& b) {
  if (!is_finite(a) || !is_finite(b)) return;
  lines.points.push_back(glm::vec3(a - lines.origin));
  lines.points.push_back(glm::vec3(b - lines.origin));
}

glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& p) { return glm::dvec3(m * glm::dvec4(p, 1)); }

// Every edge once, as a pair of position indices.
std::vector<std::array<std::uint32_t, 2>> edges_of(const MeshData& data) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(data.corners.size());
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    const std::uint32_t first = data.first_corner[f], end = data.first_corner[f + 1];
    for (std::uint32_t c = first; c < end; ++c) {
      const std::uint32_t a = data.corners[c].position, b = data.corners[c + 1 < end ? c + 1 : first].position;
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Which of `count` things are drawn so that no more than most_lines are.
std::size_t stride_for(std::size_t count, bool& thinned) {
  if (count <= most_lines) return 1;
  thinned = true;
  return (count + most_lines - 1) / most_lines;
}

Lines edge_lines(const Object& object, const glm::dmat4& to_world, const glm::dvec3& origin, bool& thinned) {
  Lines lines{Mark::edge, origin, {}};
  const MeshData& data = object.mesh->data();
  const auto edges = edges_of(data);
  const std::size_t stride = stride_for(edges.size(), thinned);
  lines.points.reserve(2 * (edges.size() / stride + 1));
  for (std::size_t i = 0; i < edges.size(); i += stride)
    add(lines, transformed(to_world, data.positions[edges[i][0]]), transformed(to_world, data.positions[edges[i][1]]));
  return lines;
}

struct Facing {
  glm::dvec3 centre, normal;  // of a face, in mesh coordinates; by Newell's method, so that concave faces are right
};

Facing facing(const MeshData& data, std::size_t face) {
  const std::uint32_t first = data.first_corner[face], end = data.first_corner[face + 1];
  Facing f{glm::dvec3(0), glm::dvec3(0)};
  const glm::dvec3& base = data.positions[data.corners[first].position];
  for (std::uint32_t c = first; c < end; ++c) {
    const glm::dvec3 a = data.positions[data.corners[c].position] - base;
    const glm::dvec3 b = data.positions[data.corners[c + 1 < end ? c + 1 : first].position] - base;
    f.centre += a;
    f.normal += glm::cross(a, b);
  }
  f.centre = base + f.centre / double(end - first);
  return f;
}

Lines face_normal_lines(const Object& object, const glm::dmat4& to_world, const glm::dvec3& origin, double length,
                        bool& thinned) {
  Lines lines{Mark::face_normal, origin, {}};
  const MeshData& data = object.mesh->data();
  const glm::dmat3 normals = normal_matrix(to_world);
  const std::size_t stride = stride_for(data.face_count(), thinned);
  for (std::size_t i = 0; i < data.face_count(); i += stride) {
    const Facing f = facing(data, i);
    const glm::dvec3 foot = transformed(to_world, f.centre), n = unit(normals * unit(f.normal));
    if (n != glm::dvec3(0)) add(lines, foot, foot + length * n);
  }
  return lines;
}

Lines vertex_normal_lines(const Object& object, const Shading& shading, const glm::dmat4& to_world,
                          const glm::dvec3& origin, double length, bool& thinned) {
  Lines lines{Mark::vertex_normal, origin, {}};
  const SurfaceHandle surface = surface_cache().get(object.mesh, normal_rule(shading), shading.crease_angle);
  const glm::dmat4 place = to_world * surface->to_mesh();
  const glm::dmat3 normals = normal_matrix(to_world);
  const std::size_t stride = stride_for(surface->positions.size(), thinned);
  for (std::size_t i = 0; i < surface->positions.size(); i += stride) {
    const glm::dvec3 foot = transformed(place, glm::dvec3(surface->positions[i]));
    const glm::dvec3 n = unit(normals * glm::dvec3(surface->normals[i]));
    if (n != glm::dvec3(0)) add(lines, foot, foot + length * n);
  }
  return lines;
}

struct Basis {
  glm::dvec3 u, v;  // unit, perpendicular to each other and to the axis
};

Basis basis_about(const glm::dvec3& axis) {
  const glm::dvec3 a = glm::abs(axis);
  const glm::dvec3 other = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                           : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                    : glm::dvec3(0, 0, 1);
  const glm::dvec3 u = unit(glm::cross(axis, other));
  return {u, glm::cross(axis, u)};
}

void add_circle(Lines& lines, const glm::dvec3& centre, const Basis& b, double radius) {
  const auto at = [&](int i) {
    const double angle = 2 * pi * i / circle_steps;
    return centre + radius * (std::cos(angle) * b.u + std::sin(angle) * b.v);
  };
  for (int i = 0; i < circle_steps; ++i) add(lines, at(i), at(i + 1));
}

void add_cone(Lines& lines, const Light& light, const glm::dvec3& apex, double size) {
  const glm::dvec3 axis = unit(light.direction);
  if (axis == glm::dvec3(0)) return;
  add(lines, apex, apex + size * axis);
  if (light.cutoff == 180) return;
  const double angle = radians(light.cutoff), radius = size * std::sin(angle);
  const glm::dvec3 rim = apex + size * std::cos(angle) * axis;
  const Basis b = basis_about(axis);
  add_circle(lines, rim, b, radius);
  for (const glm::dvec3& side : {b.u, -b.u, b.v, -b.v}) add(lines, apex, rim + radius * side);
}

// Parallel rays that end at the target, on a disc across the light's direction.
void add_rays(Lines& lines, const glm::dvec3& direction, const Camera& camera, double size) {
  const glm::dvec3 d = unit(direction);
  if (d == glm::dvec3(0)) return;
  const Basis b = basis_about(d);
  for (const glm::dvec3& aside : {glm::dvec3(0), b.u, -b.u, b.v, -b.v}) {
    const glm::dvec3 from = camera.target + size * d + 0.12 * size * aside;
    add(lines, from, from - 0.35 * size * d);
  }
}

}  // namespace

MeshOverlay mesh_overlay(const Scene& scene, const OverlayChoice& choice) {
  MeshOverlay out;
  for (const Object& object : scene.objects) {
    if (!object.visible || !object.mesh || object.mesh->triangles().empty()) continue;
    const glm::dmat4 to_world = matrix(object.transform);
    const glm::dvec3 origin = transformed(to_world, object.mesh->centre());
    if (choice.edges) out.lines.push_back(edge_lines(object, to_world, origin, out.thinned));
    if (choice.face_normals)
      out.lines.push_back(face_normal_lines(object, to_world, origin, choice.normal_length, out.thinned));
    if (choice.vertex_normals)
      out.lines.push_back(
          vertex_normal_lines(object, scene.shading, to_world, origin, choice.normal_length, out.thinned));
  }
  return out;
}

std::optional<double> half_distance(const Light& light) {
  if (light.kind == LightKind::directional) return std::nullopt;
  // k_2 r^2 + k_1 r - c = 0 in the form that does not cancel.
  const double c = light.k_0 > 0 ? light.k_0 : 2, b = light.k_1, a = light.k_2;
  const double root = b + std::sqrt(b * b + 4 * a * c);
  const double r = root > 0 ? 2 * c / root : 0;
  if (!(r > 0) || !std::isfinite(r)) return std::nullopt;
  return r;
}

Lines light_lines(const Light& light, bool selected, const Camera& camera, double size) {
  Lines lines{selected ? Mark::selected_light : Mark::light, camera.target, {}};
  if (light.kind == LightKind::directional || std::abs(light.w) < 1e-6) {
    add_rays(lines, light.position, camera, size);
    return lines;
  }
  const glm::dvec3 place = light.position / light.w;
  if (light.kind == LightKind::spot) add_cone(lines, light, place, 0.4 * size);
  if (const auto r = half_distance(light)) {
    const CameraAxes axes = axes_of(camera);
    add_circle(lines, place, {axes.right, axes.up}, *r);
  }
  return lines;
}

std::vector<Lines> axis_lines(double length) {
  std::vector<Lines> out;
  constexpr Mark marks[3] = {Mark::axis_x, Mark::axis_y, Mark::axis_z};
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 end(0);
    end[i] = length;
    Lines lines{marks[i], glm::dvec3(0), {}};
    add(lines, glm::dvec3(0), end);
    out.push_back(std::move(lines));
  }
  return out;
}

}  // namespace cg
