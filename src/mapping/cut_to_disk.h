// Opens a chart with holes or handles, or a closed one, so that it can be laid flat.
#pragma once
#include "mapping/chart_mesh.h"

namespace cg {

// Adds cuts within the chart until it is a disk: the shortest ways between its borders, then, where it has handles, a
// cut graph; a closed surface without handles is opened between two far vertices. `vertex_of` as for make_chart_mesh.
void cut_to_disk(const UnwrapSurface& surface, const std::vector<std::uint32_t>& faces, EdgeCuts& cuts,
                 std::vector<std::uint32_t>& vertex_of);

}  // namespace cg
