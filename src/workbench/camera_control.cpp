#include "workbench/camera_control.h"

#include <algorithm>
#include <limits>

namespace cg {

namespace {

constexpr double nearest = 1e-15, farthest = 1e25;  // of eye and target, metres
constexpr double nearest_of_place = 1e-13;  // of their distance from the origin: nearer, rounding turns the view
constexpr double pole = radians(1);
constexpr double margin = 1.05;
constexpr double near_of_radius = 1e-4, far_of_near = 1e6;

glm::dvec3 finite_or(const glm::dvec3& v, const glm::dvec3& otherwise) { return is_finite(v) ? v : otherwise; }

// How near the eye may come to the target where it is.
double nearest_at(const glm::dvec3& target) {
  return std::clamp(nearest_of_place * length_and_unit(target).length, nearest, farthest);
}

// A camera with a direction to look in.
Camera looking(Camera c) {
  c.position = finite_or(c.position, {0, 0, 0}), c.target = finite_or(c.target, {0, 0, 0});
  if (unit(finite_or(c.up, {0, 0, 0})) == glm::dvec3(0)) c.up = {0, 1, 0};
  const double least = nearest_at(c.target);
  if (length_and_unit(c.target - c.position).length < least / 2)
    c.position = c.target + glm::dvec3(0, 0, std::max(1.0, least));
  return c;
}

double half_tangent(const Camera& c) { return std::tan(radians(std::clamp(c.fov, 1.0, 170.0)) / 2); }

double positive_aspect(double aspect) { return aspect > 1e-6 ? std::min(aspect, 1e6) : 1; }

struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

template <class Visit>
void visit_box(const Object& object, const glm::dmat4& to_world, Visit&& visit) {
  const glm::dvec3 &low = object.mesh->low(), &high = object.mesh->high();
  for (int i = 0; i < 8; ++i)
    visit(glm::dvec3(to_world * glm::dvec4(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z, 1)));
}

template <class Visit>
void visit_objects(const Scene& scene, bool exact, Visit&& visit) {
  for (const Object& object : scene.objects) {
    if (!object.visible || !object.mesh || object.mesh->triangles().empty()) continue;
    const glm::dmat4 to_world = matrix(object.transform);
    if (!exact) {
      visit_box(object, to_world, visit);
      continue;
    }
    const MeshData& data = object.mesh->data();
    for (const Triangle& t : object.mesh->triangles())
      for (const std::uint32_t corner : t.corner)
        visit(glm::dvec3(to_world * glm::dvec4(data.positions[data.corners[corner].position], 1)));
  }
}

}  // namespace

Sphere bounding_sphere(const Scene& scene, bool exact) {
  Bounds b;
  visit_objects(scene, exact, [&](const glm::dvec3& p) { b.low = glm::min(b.low, p), b.high = glm::max(b.high, p); });
  if (!is_finite(b.low) || !is_finite(b.high)) return {};
  Sphere sphere{b.low * 0.5 + b.high * 0.5, 0};
  visit_objects(scene, exact, [&](const glm::dvec3& p) {
    sphere.radius = std::max(sphere.radius, length_and_unit(p - sphere.centre).length);
  });
  if (!(sphere.radius > 1e-25)) sphere.radius = 1;
  return sphere;
}

CameraAxes axes_of(const Camera& camera) {
  const Camera c = looking(camera);
  const glm::dmat4 m = view_matrix(c);
  CameraAxes a{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {-m[0][2], -m[1][2], -m[2][2]}, 0, 0};
  a.distance = length_and_unit(c.target - c.position).length;
  a.height = c.projection == Projection::perspective ? 2 * a.distance * half_tangent(c) : c.height;
  return a;
}

Camera orbit(Camera camera, double azimuth, double elevation) {
  if (!std::isfinite(azimuth) || !std::isfinite(elevation)) return camera;
  camera = looking(camera);
  const CameraAxes a = axes_of(camera);
  const glm::dvec3 up = unit(camera.up);
  // The eye in spherical coordinates about the target: `back` is where it stands on the horizon. The camera's
  // own right-hand axis gives it, so it exists at the poles too.
  const glm::dvec3 back = unit(glm::cross(a.right, up));
  const double theta = std::atan2(-glm::dot(a.forward, back), -glm::dot(a.forward, up));  // from the pole
  const double turned = std::clamp(std::abs(theta) - elevation, pole, pi - pole);
  const glm::dvec3 turned_back = glm::dvec3(rotation(azimuth, up) * glm::dvec4(back, 0));
  camera.position = camera.target + a.distance * (std::sin(turned) * turned_back + std::cos(turned) * up);
  return camera;
}

Camera pan(const Camera& camera, double right, double down) {
  if (!std::isfinite(right) || !std::isfinite(down)) return camera;
  Camera c = looking(camera);
  const CameraAxes a = axes_of(c);
  const glm::dvec3 step = a.height * (down * a.up - right * a.right);
  if (!is_finite(c.position + step) || !is_finite(c.target + step)) return camera;
  c.position += step, c.target += step;
  return c;
}

Camera zoom(const Camera& camera, double factor, const glm::dvec2& at, double aspect) {
  if (!(factor > 0) || !std::isfinite(factor) || !std::isfinite(at.x + at.y)) return camera;
  Camera c = looking(camera);
  const CameraAxes a = axes_of(c);
  const bool perspective = c.projection == Projection::perspective;
  const double size = perspective ? a.distance : a.height;
  factor = std::clamp(size * factor, nearest_at(c.target), farthest) / size;
  const glm::dvec3 kept = c.target + a.height / 2 * (at.x * positive_aspect(aspect) * a.right + at.y * a.up);
  const glm::dvec3 target = kept + factor * (c.target - kept);
  if (perspective) {
    c.position = kept + factor * (c.position - kept);
  } else {
    c.position += target - c.target;
    c.height *= factor;
  }
  c.target = target;
  return c;
}

Camera with_planes(Camera camera, const Sphere& sphere) {
  const CameraAxes a = axes_of(camera);
  const double depth = glm::dot(sphere.centre - looking(camera).position, a.forward);
  const double smallest = near_of_radius * sphere.radius;
  camera.near_plane = std::clamp(depth - margin * sphere.radius, smallest, std::max(smallest, camera.near_plane));
  camera.far_plane = std::max({camera.far_plane, depth + margin * sphere.radius, 2 * camera.near_plane});
  if (camera.far_plane > far_of_near * camera.near_plane) {
    // The far plane comes back to what is needed before the near plane gives way.
    camera.far_plane = std::max({depth + margin * sphere.radius, 2 * camera.near_plane});
    camera.near_plane = std::max(camera.near_plane, camera.far_plane / far_of_near);
  }
  return camera;
}

bool planes_hold(const Camera& camera, const Sphere& sphere) {
  const double depth = glm::dot(sphere.centre - looking(camera).position, axes_of(camera).forward);
  const double needed = std::max(depth - sphere.radius, near_of_radius * sphere.radius);
  return camera.near_plane <= needed * (1 + 1e-9) && camera.far_plane >= depth + sphere.radius;
}

Camera fit(const Camera& camera, const Sphere& sphere, double aspect) {
  Camera c = looking(camera);
  const CameraAxes a = axes_of(c);
  aspect = positive_aspect(aspect);
  const double tangent = half_tangent(c) * std::min(1.0, aspect);  // of half the narrower angle
  const double radius = margin * sphere.radius;
  const double distance = radius * std::sqrt(1 + 1 / (tangent * tangent));  // radius / sin
  c.target = sphere.centre;
  c.position = sphere.centre - distance * a.forward;
  c.height = 2 * radius / std::min(1.0, aspect);
  c.near_plane = std::max(distance - radius, near_of_radius * sphere.radius);
  c.far_plane = distance + radius;
  return with_planes(c, sphere);
}

Camera with_projection(Camera camera, Projection projection) {
  if (camera.projection == projection) return camera;
  camera = looking(camera);
  const CameraAxes a = axes_of(camera);
  camera.projection = projection;
  if (projection == Projection::orthographic) {
    camera.height = a.height;
  } else {
    const double distance = std::clamp(a.height / (2 * half_tangent(camera)), nearest_at(camera.target), farthest);
    camera.position = camera.target - distance * a.forward;
  }
  return camera;
}

Camera turntable(const Camera& camera, double degrees_per_second, double seconds) {
  const double t = seconds > 0 ? std::min(seconds, 0.25) : 0;
  return orbit(camera, radians(degrees_per_second) * t, 0);
}

}  // namespace cg
