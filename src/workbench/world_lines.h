// The scene's camera as it is seen from outside.
#pragma once
#include <array>

#include "workbench/overlay.h"

namespace cg {

// The corners of what the camera sees, which the clip volume -w <= x, y, z <= w is in the world: 0..3 on the near
// plane, 4..7 on the far plane, each from the lower left one counter-clockwise as the camera sees them. `aspect` is the
// picture's width / height.
std::array<glm::dvec3, 8> view_volume(const Camera& camera, double aspect);

// The edges of that volume with its two planes, and the camera itself: a pyramid `size` metres high whose tip is the
// eye, with a mark on its upper side, and the line to the target.
std::vector<Lines> camera_lines(const Camera& camera, double aspect, double size);

// A world point as the camera's picture has it before it is spread over the window: divided by w, inside the clip
// volume where each coordinate is within -1..1. z is turned round, so that the near plane lies at +1, towards who
// looks along -z. Nothing where w is not positive.
std::optional<glm::dvec3> after_division(const Camera& camera, double aspect, const glm::dvec3& point);

// Lines of the world after the division by w, cut where they leave the volume by more than its own size. Straight lines
// stay straight.
Lines after_division(const Camera& camera, double aspect, const std::vector<Lines>& world);

// The edges of the clip volume after the division: a cube from -1 to 1.
Lines clip_cube();

// A camera from which the scene and the scene's own camera are seen: from the side and above, looking at the middle of
// both.
Camera outside_camera(const Scene& scene, double aspect);

}  // namespace cg
