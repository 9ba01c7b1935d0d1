// Colours for the pixels that the visibility buffer found: each visible pixel is shaded once.
// This work is based on: Henri Gouraud, Continuous Shading of Curved Surfaces, 1971; Bui Tuong Phong, Illumination
// for Computer Generated Pictures, 1975; Christopher Burns and Warren Hunt, The Visibility Buffer, 2013.
#pragma once
#include "raster/deferred_shading.h"

namespace cg {

// Writes the frame's colour, depth and coverage at every pixel, each once. Colours that are not finite become 0 and
// are counted in Frame::nan_pixels.
template <class Real>
void shade_pixels(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                  const glm::vec3& background, Workers& workers, Frame& frame);

}  // namespace cg
