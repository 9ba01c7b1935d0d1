// uv as one pair per corner, the form in which mappings are made and edited, to and from a mesh's indexed list.
#pragma once
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace cg {

// One for each of data.corners.
using CornerUv = std::vector<glm::dvec2>;

// (0, 0) where a corner has none.
CornerUv corner_uv(const MeshData& data);

// The same mesh with these uv, each pair of numbers once, in the order of their first use. `uv` has a pair for each
// corner.
MeshData with_corner_uv(MeshData data, std::span<const glm::dvec2> uv);

}  // namespace cg
