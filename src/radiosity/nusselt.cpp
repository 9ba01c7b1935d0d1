#include "radiosity/nusselt.h"

#include <algorithm>

#include "math/transform.h"
#include "radiosity/closed_form.h"

namespace cg {

namespace {

// Two axes that make a right-handed frame with the unit vector z. Source: Tom Duff and others, Building an Orthonormal
// Basis, Revisited, 2017.
void make_axes(const glm::dvec3& z, glm::dvec3& x, glm::dvec3& y) {
  const double sign = std::copysign(1.0, z.z), a = -1 / (sign + z.z), b = z.x * z.y * a;
  x = {1 + sign * z.x * z.x * a, sign * b, -sign * z.x};
  y = {b, sign + z.y * z.y * a, -z.y};
}

// The points of the arc from the unit vector p up to, and without, q, by the angle between them.
void add_arc(const glm::dvec3& p, const glm::dvec3& q, double angle, double step, std::vector<glm::dvec3>& out) {
  const int n = std::max(1, int(std::ceil(angle / step)));
  const glm::dvec3 ahead = unit(q - glm::dot(p, q) * p);
  for (int i = 0; i < n; ++i) {
    const double t = angle * i / n;
    out.push_back(std::cos(t) * p + std::sin(t) * ahead);
  }
}

}  // namespace

NusseltProjection nusselt_projection(const glm::dvec3& point, const glm::dvec3& normal,
                                     std::span<const glm::dvec3> polygon, double step) {
  NusseltProjection out;
  make_axes(normal, out.x, out.y);
  out.form_factor = point_form_factor(point, normal, polygon);
  if (out.form_factor == 0) return out;
  std::vector<glm::dvec3> direction;
  for (const glm::dvec3& p : clipped_to_front(polygon, point, normal)) {
    const glm::dvec3 v = p - point;
    const glm::dvec3 d = unit(glm::dvec3(glm::dot(out.x, v), glm::dot(out.y, v), glm::dot(normal, v)));
    if (d != glm::dvec3(0)) direction.push_back(d);
  }
  // Counter-clockwise seen from the polygon's front is clockwise seen from above the hemisphere.
  std::reverse(direction.begin(), direction.end());
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const glm::dvec3 &p = direction[i], &q = direction[i + 1 < direction.size() ? i + 1 : 0];
    const auto [sine, axis] = length_and_unit(glm::cross(p, q));
    const double angle = std::atan2(sine, glm::dot(p, q));
    // A circle seen at a slant is an ellipse, whose sectors keep their share of the area.
    out.sectors.push_back(0.5 * angle * axis.z);
    add_arc(p, q, angle, step, out.outline);
  }
  return out;
}

}  // namespace cg
