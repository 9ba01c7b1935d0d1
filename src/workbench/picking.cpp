#include "workbench/picking.h"

#include <algorithm>

#include "workbench/camera_control.h"

namespace cg {

namespace {

constexpr double sphere_of_height = 0.42;  // of the smaller side of what is seen at the target
constexpr double smallest_w = 1e-6;        // below it a light is directional, as in the light model
constexpr double push_per_height = 3;      // e-foldings of depth for a drag over the picture's height

bool is_directional(const Light& light) {
  return light.kind == LightKind::directional || std::abs(light.w) < smallest_w;
}

glm::dvec3 place_of(const Light& light) { return light.position / light.w; }

bool inside(const glm::dvec2& pixel, const glm::dvec2& size) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x <= size.x && pixel.y <= size.y;
}

double aim_length(const Light& light, const Camera& camera) {
  return 0.4 * std::max(length_and_unit(camera.target - place_of(light)).length, 1e-3 * axes_of(camera).height);
}

// The point of the sphere under `pixel`, on the half that `behind` says; where the ray misses, the point of its
// outline on that side.
glm::dvec3 on_sphere(const PictureProjection& p, const glm::dvec2& pixel, double radius, bool behind) {
  const auto [origin, direction] = p.ray(pixel);
  const glm::dvec3 to_centre = p.camera.target - origin;
  const double along = glm::dot(to_centre, direction);
  const glm::dvec3 closest = direction * along - to_centre;  // from the centre
  const double square = radius * radius - glm::dot(closest, closest);
  if (square > 0 && along > 0)
    return p.camera.target + closest + direction * (behind ? std::sqrt(square) : -std::sqrt(square));
  const bool perspective = p.camera.projection == Projection::perspective;
  const auto [distance, towards] = length_and_unit(perspective ? to_centre : direction);
  const double sine = perspective ? radius / distance : 0;  // of the angle under which the outline is seen
  const glm::dvec3 aside = unit(closest - towards * glm::dot(closest, towards));
  return p.camera.target + radius * (aside * std::sqrt(1 - sine * sine) - towards * sine);
}

std::optional<Handle> sphere_handle(const PictureProjection& p, int index, const glm::dvec3& direction) {
  const glm::dvec3 d = unit(direction);
  if (d == glm::dvec3(0)) return std::nullopt;
  Handle h{index, Grip::sphere, p.camera.target + handle_sphere_radius(p.camera, p.size) * d, {}, 0, false};
  const auto seen = p.project(h.world);
  if (!seen) return std::nullopt;
  h.pixel = seen->pixel, h.depth = seen->depth;
  h.behind = glm::dot(p.ray(seen->pixel).direction, d) > 0;
  return h;
}

}  // namespace

PictureProjection::PictureProjection(const Camera& c, const glm::dvec2& s)
    : camera(c), size(s), to_eye(view_matrix(c)), to_world(glm::inverse(to_eye)) {
  const glm::dmat4 m = projection_matrix(c, s.x / s.y);
  scale = {m[0][0] * s.x / 2, m[1][1] * s.y / 2};
}

std::optional<PictureProjection::Seen> PictureProjection::project(const glm::dvec3& point) const {
  const glm::dvec3 eye(to_eye * glm::dvec4(point, 1));
  const double depth = -eye.z;
  const bool perspective = camera.projection == Projection::perspective;
  if (!is_finite(eye) || (perspective && !(depth > 0))) return std::nullopt;
  const double shrink = perspective ? 1 / depth : 1;
  const Seen seen{{size.x / 2 + eye.x * scale.x * shrink, size.y / 2 - eye.y * scale.y * shrink}, depth};
  if (!std::isfinite(seen.pixel.x + seen.pixel.y)) return std::nullopt;
  return seen;
}

glm::dvec3 PictureProjection::unproject(const glm::dvec2& pixel, double depth) const {
  const double grow = camera.projection == Projection::perspective ? depth : 1;
  const glm::dvec3 eye((pixel.x - size.x / 2) / scale.x * grow, (size.y / 2 - pixel.y) / scale.y * grow, -depth);
  return glm::dvec3(to_world * glm::dvec4(eye, 1));
}

PictureProjection::Ray PictureProjection::ray(const glm::dvec2& pixel) const {
  const glm::dvec3 origin = unproject(pixel, 0), through = unproject(pixel, 1);
  return {origin, unit(through - origin)};
}

double handle_sphere_radius(const Camera& camera, const glm::dvec2& size) {
  const CameraAxes a = axes_of(camera);
  const double radius = sphere_of_height * a.height * std::min(1.0, size.x / size.y);
  return camera.projection == Projection::perspective ? std::min(radius, 0.8 * a.distance) : radius;
}

std::vector<Handle> light_handles(const Scene& scene, const glm::dvec2& size) {
  std::vector<Handle> out;
  if (!(size.x > 0 && size.y > 0)) return out;
  const PictureProjection p(scene.camera, size);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (!light.enabled) continue;
    if (is_directional(light)) {
      if (const auto h = sphere_handle(p, int(i), light.position)) out.push_back(*h);
      continue;
    }
    const glm::dvec3 place = place_of(light);
    const auto seen = p.project(place);
    const bool visible = seen && inside(seen->pixel, size);
    if (visible) {
      out.push_back({int(i), Grip::place, place, seen->pixel, seen->depth, false});
    } else if (const auto h = sphere_handle(p, int(i), place - scene.camera.target)) {
      out.push_back(*h);
    }
    if (light.kind != LightKind::spot || !visible) continue;
    const glm::dvec3 end = place + aim_length(light, scene.camera) * unit(light.direction);
    if (const auto tip = p.project(end); tip && unit(light.direction) != glm::dvec3(0))
      out.push_back({int(i), Grip::aim, end, tip->pixel, tip->depth, false});
  }
  return out;
}

std::optional<Handle> handle_at(const std::vector<Handle>& handles, const glm::dvec2& pixel, double radius) {
  std::optional<Handle> best;
  double nearest = radius;
  for (const Handle& h : handles) {
    const double d = glm::length(h.pixel - pixel);
    if (d < nearest || (best && d == nearest && h.depth < best->depth)) best = h, nearest = d;
  }
  return best;
}

Light dragged(const Light& before, const Handle& handle, const Camera& camera, const glm::dvec2& size,
              const glm::dvec2& moved, bool along_view) {
  const PictureProjection p(camera, size);
  const glm::dvec2 pixel = handle.pixel + moved;
  const double push = std::exp(std::clamp(-moved.y / size.y * push_per_height, -20.0, 20.0));
  const glm::dvec3 plane =
      along_view ? p.unproject(handle.pixel, handle.depth * push) : p.unproject(pixel, handle.depth);
  Light light = before;
  switch (handle.grip) {
    case Grip::place:
      light.position = plane * before.w;
      break;
    case Grip::aim:
      light.direction = unit(plane - place_of(before)) * length_and_unit(before.direction).length;
      break;
    case Grip::sphere: {
      const glm::dvec3 direction =
          along_view ? unit(handle.world - camera.target)
                     : unit(on_sphere(p, pixel, handle_sphere_radius(camera, size), handle.behind) - camera.target);
      if (is_directional(before)) {
        light.position = direction * length_and_unit(before.position).length;
      } else {
        const double distance = length_and_unit(place_of(before) - camera.target).length * (along_view ? push : 1);
        light.position = (camera.target + distance * direction) * before.w;
      }
    }
  }
  const bool usable = is_finite(light.position) && is_finite(light.direction) && light.direction != glm::dvec3(0);
  return usable ? light : before;
}

}  // namespace cg
