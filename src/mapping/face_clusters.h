// Faces gathered into charts that are nearly flat: where automatic seams begin.
#pragma once
#include "mapping/unwrap_surface.h"

namespace cg {

// Adds to `cuts` the borders between clusters. Neighbours are merged, the flattest pair first, while the mean normal of
// the two is longer than 1 - `bend` (0: only coplanar faces) and they look less than about 70 degrees apart. No cluster
// grows across what is cut already.
void cut_into_clusters(const UnwrapSurface& surface, double bend, EdgeCuts& cuts);

// Adds to `cuts` a border through the chart that parts it between two far faces; false where it has only one face.
bool cut_in_two(const UnwrapSurface& surface, const std::vector<std::uint32_t>& faces, EdgeCuts& cuts);

}  // namespace cg
