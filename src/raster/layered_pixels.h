// Pixels of objects that have layers of textures: what the light model is given, and what is made of its colour.
#pragma once
#include "raster/deferred_shading.h"

namespace cg {

// As shade_pixels(), where some object has layers.
template <class Real>
void shade_layered_pixels(const Drawing& drawing, const VisibilityBuffer& visibility,
                          const DeferredShading<Real>& shading, const glm::vec3& background, Workers& workers,
                          Frame& frame);

}  // namespace cg
