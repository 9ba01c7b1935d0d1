// Alpha test: a pixel of a textured triangle is there where its alpha is above a threshold, and a hole elsewhere.
// This work is based on: The OpenGL Graphics System 2.1, section 4.1.4.
#pragma once
#include "raster/deferred_shading.h"

namespace cg {

// Adds the triangles of the objects that are `tested` to what find_visible() left, as if all had been drawn in order.
template <class Real>
void test_alpha(const Drawing& drawing, const DeferredShading<Real>& shading, double threshold, Workers& workers,
                VisibilityBuffer& out);

}  // namespace cg
