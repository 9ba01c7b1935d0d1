// The layers of a frame that are filled on demand: which triangle of which object each pixel shows, and its normal.
#pragma once
#include "raster/visibility.h"
#include "scene/scene.h"

namespace cg {

// Frame::object and Frame::triangle; pixels that show nothing stay as they are.
void fill_ids(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers, Frame& frame);
// Frame::normal.
void fill_normals(const Scene& scene, const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                  Frame& frame);

}  // namespace cg
