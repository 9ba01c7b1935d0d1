// The Nusselt projection: a polygon seen from a surface element, on the hemisphere above it and straight down on the
// hemisphere's base. The area of that shadow over pi is the form factor.
// This work is based on: Wilhelm Nusselt, Graphische Bestimmung des Winkelverhaeltnisses bei der Waermestrahlung, 1928.
#pragma once
#include <span>
#include <vector>

#include "math/vec.h"

namespace cg {

// Everything in a frame of the surface element: x and y in its plane, z along its normal; the hemisphere has radius 1.
struct NusseltProjection {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0};  // the frame's axes in world coordinates; z is the normal
  // The outline on the hemisphere: arcs of great circles as points, counter-clockwise seen from above, the last beside
  // the first. Its shadow on the base has the same x and y. Empty where nothing of the polygon's front is above.
  std::vector<glm::dvec3> outline;
  // For each arc the area between its shadow and the middle of the base, an ellipse's sector: negative where the arc
  // turns clockwise. Their sum is the shadow's area, without any error of a polygon for an arc.
  std::vector<double> sectors;
  double form_factor = 0;  // the shadow's area over pi, 0..1
};

// The polygon is plane, convex and counter-clockwise seen from its front; `normal` is unit. An arc's points are at most
// `step` radians apart.
NusseltProjection nusselt_projection(const glm::dvec3& point, const glm::dvec3& normal,
                                     std::span<const glm::dvec3> polygon, double step = 0.05);

}  // namespace cg
