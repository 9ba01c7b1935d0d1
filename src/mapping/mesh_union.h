// Several meshes as one, so that they share one texture.
#pragma once
#include <span>

#include "mapping/corner_uv.h"

namespace cg {

// All faces of the meshes, one after the other, with their positions only. None of the meshes is null.
MeshHandle joined_meshes(std::span<const MeshHandle> meshes);

// Each mesh with its share of the uv of the joined one's corners.
std::vector<MeshData> parted_uv(std::span<const MeshHandle> meshes, std::span<const glm::dvec2> uv);

}  // namespace cg
