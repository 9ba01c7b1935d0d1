#include "mapping/mesh_union.h"

namespace cg {

MeshHandle joined_meshes(std::span<const MeshHandle> meshes) {
  MeshData out;
  std::vector<Corner> corners;
  for (const MeshHandle& mesh : meshes) {
    const MeshData& data = mesh->data();
    const std::uint32_t first = std::uint32_t(out.positions.size());
    out.positions.insert(out.positions.end(), data.positions.begin(), data.positions.end());
    for (std::size_t f = 0; f < data.face_count(); ++f) {
      corners.clear();
      for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c)
        corners.push_back({first + data.corners[c].position});
      out.add_face(corners.data(), corners.data() + corners.size());
    }
  }
  return Mesh::make(std::move(out));
}

std::vector<MeshData> parted_uv(std::span<const MeshHandle> meshes, std::span<const glm::dvec2> uv) {
  std::vector<MeshData> out;
  for (const MeshHandle& mesh : meshes) {
    const std::size_t n = mesh->data().corners.size();
    out.push_back(with_corner_uv(mesh->data(), uv.first(n)));
    uv = uv.subspan(n);
  }
  return out;
}

}  // namespace cg
