// The layers of a frame that are filled on demand: which triangle of which object each pixel shows, and its normal.
#pragma once
#include "raster/visibility.h"
#include "scene/scene.h"

namespace cg {

// Writes ids and normals where the frame has room for them; pixels that show nothing stay as they are.
void fill_ids_and_normals(const Scene& scene, const Drawing& drawing, const VisibilityBuffer& visibility,
                          Workers& workers, Frame& frame);

}  // namespace cg
