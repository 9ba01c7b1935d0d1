#include "workbench/world_lines.h"

#include "workbench/camera_control.h"

namespace cg {

namespace {

void add(Lines& lines, const glm::dvec3& a, const glm::dvec3& b) {
  if (!is_finite(a) || !is_finite(b)) return;
  lines.points.push_back(glm::vec3(a - lines.origin));
  lines.points.push_back(glm::vec3(b - lines.origin));
}

}  // namespace

std::array<glm::dvec3, 8> view_volume(const Camera& camera, double aspect) {
  const glm::dmat4 from_clip = glm::inverse(projection_matrix(camera, aspect));
  const glm::dmat4 to_world = glm::inverse(view_matrix(camera));
  constexpr std::array<glm::dvec2, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::array<glm::dvec3, 8> out;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 eye = from_clip * glm::dvec4(corners[i % 4], i < 4 ? -1 : 1, 1);
    out[i] = glm::dvec3(to_world * glm::dvec4(glm::dvec3(eye) / eye.w, 1));
  }
  return out;
}

std::vector<Lines> camera_lines(const Camera& camera, double aspect, double size) {
  const CameraAxes axes = axes_of(camera);
  Lines volume{Mark::clip_volume, camera.position, {}}, body{Mark::camera, camera.position, {}};
  const std::array<glm::dvec3, 8> v = view_volume(camera, aspect);
  for (std::size_t i = 0; i < 4; ++i) {
    add(volume, v[i], v[(i + 1) % 4]);
    add(volume, v[4 + i], v[4 + (i + 1) % 4]);
    add(volume, v[i], v[4 + i]);
  }
  const glm::dvec3 eye = camera.position, middle = eye + size * axes.forward;
  const glm::dvec3 x = 0.5 * size * std::min(aspect, 2.0) * axes.right, y = 0.5 * size * axes.up;
  const std::array<glm::dvec3, 4> base{middle - x - y, middle + x - y, middle + x + y, middle - x + y};
  for (std::size_t i = 0; i < 4; ++i) add(body, eye, base[i]), add(body, base[i], base[(i + 1) % 4]);
  const glm::dvec3 top = middle + 1.6 * y;
  add(body, base[3] + 0.3 * x, top), add(body, top, base[2] - 0.3 * x);
  add(volume, eye, camera.target);
  return {std::move(volume), std::move(body)};
}

namespace {

constexpr double shown_part = 2;  // of the clip volume's size, from its middle

// Cuts the segment a, b in clip coordinates to the side of a plane where `distance` is not negative; false: nothing is
// left.
bool cut(glm::dvec4& a, glm::dvec4& b, double distance_a, double distance_b) {
  if (distance_a < 0 && distance_b < 0) return false;
  const glm::dvec4 crossing = distance_a == distance_b ? a : a + (b - a) * (distance_a / (distance_a - distance_b));
  if (distance_a < 0) a = crossing;
  if (distance_b < 0) b = crossing;
  return true;
}

bool cut_to_shown(glm::dvec4& a, glm::dvec4& b) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      if (!cut(a, b, shown_part * a.w - side * a[axis], shown_part * b.w - side * b[axis])) return false;
  return a.w > 0 && b.w > 0;
}

glm::dvec3 divided(const glm::dvec4& clip) { return glm::dvec3(clip.x, clip.y, -clip.z) / clip.w; }

}  // namespace

std::optional<glm::dvec3> after_division(const Camera& camera, double aspect, const glm::dvec3& point) {
  const glm::dvec4 clip = projection_matrix(camera, aspect) * view_matrix(camera) * glm::dvec4(point, 1);
  if (!(clip.w > 0) || !is_finite(divided(clip))) return std::nullopt;
  return divided(clip);
}

Lines after_division(const Camera& camera, double aspect, const std::vector<Lines>& world) {
  Lines out{Mark::edge, {}, {}};
  const glm::dmat4 to_clip = projection_matrix(camera, aspect) * view_matrix(camera);
  for (const Lines& lines : world) {
    const glm::dmat4 m = to_clip * translation(lines.origin);
    for (std::size_t i = 0; i + 1 < lines.points.size(); i += 2) {
      glm::dvec4 a = m * glm::dvec4(glm::dvec3(lines.points[i]), 1),
                 b = m * glm::dvec4(glm::dvec3(lines.points[i + 1]), 1);
      if (cut_to_shown(a, b)) add(out, divided(a), divided(b));
    }
  }
  return out;
}

Lines clip_cube() {
  Lines out{Mark::clip_volume, {}, {}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double u : {-1.0, 1.0})
      for (const double v : {-1.0, 1.0}) {
        glm::dvec3 a;
        a[axis] = -1, a[(axis + 1) % 3] = u, a[(axis + 2) % 3] = v;
        glm::dvec3 b = a;
        b[axis] = 1;
        add(out, a, b);
      }
  return out;
}

Camera outside_camera(const Scene& scene, double aspect) {
  const Sphere sphere = bounding_sphere(scene, false);
  const glm::dvec3 eye = scene.camera.position;
  const auto [distance, towards] = length_and_unit(eye - sphere.centre);
  Camera out;
  out.fov = 40;
  const double radius = std::max(sphere.radius, 0.5 * (distance + sphere.radius));
  const glm::dvec3 centre = sphere.centre + towards * (radius - sphere.radius);
  const CameraAxes axes = axes_of(scene.camera);
  out.target = centre;
  out.position = centre + axes.right * 2.0 + glm::dvec3(0, 1.3, 0) + towards * 0.8;
  return fit(out, {centre, radius * 1.15}, aspect);
}

}  // namespace cg
