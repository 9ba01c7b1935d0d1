// From the world to the picture and back, and the lights that are seen and dragged in the picture. Pixels are
// counted from the top-left corner of the picture, x right, y down; pixel centres are at .5.
#pragma once
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace cg {

// How a world point is seen in a picture of `size` pixels (both > 0).
struct PictureProjection {
  PictureProjection(const Camera& camera, const glm::dvec2& size);

  struct Seen {
    glm::dvec2 pixel;
    double depth;  // distance before the eye's plane, metres, along the view
  };
  // Nothing for a point that is not before the eye (perspective) or is not finite.
  std::optional<Seen> project(const glm::dvec3& point) const;
  // The point that is seen at `pixel` at the depth.
  glm::dvec3 unproject(const glm::dvec2& pixel, double depth) const;
  // The straight line on which all lies that is seen at `pixel`; `direction` is unit and leads away from the eye.
  struct Ray {
    glm::dvec3 origin, direction;
  };
  Ray ray(const glm::dvec2& pixel) const;

  Camera camera;
  glm::dvec2 size;
  glm::dmat4 to_eye, to_world;
  glm::dvec2 scale;  // pixels for one metre at depth 1 (perspective) or at any depth (orthographic)
};

// What of a light is taken hold of.
enum class Grip {
  place,   // a point or spot light where it stands: dragged in the plane parallel to the screen
  sphere,  // its direction, as a point on a sphere about the camera's target: directional lights, and those
           // that stand outside the picture (they keep their distance from the target)
  aim      // the end of a spot's axis
};

struct Handle {
  int light = 0;  // index into Scene::lights
  Grip grip = Grip::place;
  glm::dvec3 world{0};
  glm::dvec2 pixel{0};
  double depth = 0;
  bool behind = false;  // of a sphere: on the half that looks away from the eye
};

// The handles of all enabled lights that can be taken hold of in the picture.
std::vector<Handle> light_handles(const Scene& scene, const glm::dvec2& size);

// The handle nearest to `pixel` within `radius` pixels; the nearest to the eye of those that are equally near.
std::optional<Handle> handle_at(const std::vector<Handle>& handles, const glm::dvec2& pixel, double radius);

// The light as it is after its handle was dragged from where it was (`handle` and `before`, both of the drag's
// start) by `moved` pixels. `along_view`: a place is pushed away (mouse up) or pulled nearer (mouse down)
// instead, a sphere's light changes its distance from the target.
Light dragged(const Light& before, const Handle& handle, const Camera& camera, const glm::dvec2& size,
              const glm::dvec2& moved, bool along_view);

// Radius of the sphere on which directions are shown, metres.
double handle_sphere_radius(const Camera& camera, const glm::dvec2& size);

}  // namespace cg
