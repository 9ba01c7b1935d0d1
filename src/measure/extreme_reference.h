// What a pixel's colour is, computed slowly and another way than any technique: the ray through the pixel meets the
// triangle's plane in double, and the light model is evaluated at its corners, or at the point itself.
#pragma once
#include "scene/frame.h"
#include "scene/scene.h"

namespace cg {

// At the centre of pixel (x, y) of the triangle that `frame` says is there; `frame` has ids, and the pixel is covered.
glm::dvec3 reference_colour(const Scene& scene, const Frame& frame, int x, int y);

struct ReferenceError {
  double largest = 0;  // of a channel; relative where the colour is over 1; NaN where a colour is
  int x = -1, y = -1;  // where
  int pixels = 0;      // compared
};

// Over every `step`-th covered pixel. The frame needs ids.
ReferenceError against_reference(const Scene& scene, const Frame& frame, int step = 7);

// |a - b|, relative to b where that is over 1; NaN where either is.
double colour_error(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace cg
