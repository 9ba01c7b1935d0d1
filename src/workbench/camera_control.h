// Moving the camera by hand: every gesture is a function from a camera to a camera. None leaves a camera that is
// not finite, and a camera that looks nowhere (eye at the target) first steps back.
#pragma once
#include "scene/scene.h"

namespace cg {

struct Sphere {
  glm::dvec3 centre{0};
  double radius = 1;  // > 0
};

// Of the visible objects, in world coordinates: about the centre of their box. `exact` visits every vertex and
// touches the farthest; otherwise the corners of each mesh's box stand for it. The unit ball where there is
// nothing to see.
Sphere bounding_sphere(const Scene& scene, bool exact);

// The camera's axes (unit, world), the distance to the target, and the height of what is seen at the target.
struct CameraAxes {
  glm::dvec3 right, up, forward;
  double distance, height;
};
CameraAxes axes_of(const Camera& camera);

// Turns the eye about the target: `azimuth` about `up`, to the right as seen from the eye; `elevation` upwards.
// Radians. It stops 1 degree before the poles.
Camera orbit(Camera camera, double azimuth, double elevation);

// Moves eye and target so that the picture moves by (right, down), in heights of the picture.
Camera pan(const Camera& camera, double right, double down);

// Brings the target nearer by `factor` (below 1) or farther (above). What is seen at `at` (-1..1 across the
// picture, y up) at the target's depth stays there.
Camera zoom(const Camera& camera, double factor, const glm::dvec2& at, double aspect);

// Looks at the sphere from the same side, so that it fills the picture but for a margin of 5 %; sets the planes.
Camera fit(const Camera& camera, const Sphere& sphere, double aspect);

// Moves the near and far planes apart until the sphere lies between them. near is at least 1e-4 radius and
// far/near at most 1e6.
Camera with_planes(Camera camera, const Sphere& sphere);
// Whether the planes cut nothing of the sphere off that lies before the eye.
bool planes_hold(const Camera& camera, const Sphere& sphere);

// The other projection, with the same picture at the target's depth.
Camera with_projection(Camera camera, Projection projection);

// An orbit by `degrees_per_second` for `seconds` since the last picture; a pause counts as a quarter of a second.
Camera turntable(const Camera& camera, double degrees_per_second, double seconds);

}  // namespace cg
