#include "mapping/corner_uv.h"

#include "scene/numbering.h"

namespace cg {

CornerUv corner_uv(const MeshData& data) {
  CornerUv out(data.corners.size(), glm::dvec2(0));
  for (std::size_t c = 0; c < out.size(); ++c)
    if (data.corners[c].uv != no_index) out[c] = data.uvs[data.corners[c].uv];
  return out;
}

MeshData with_corner_uv(MeshData data, std::span<const glm::dvec2> uv) {
  data.uvs.clear();
  Numbering numbers(data.corners.size());
  for (std::size_t c = 0; c < data.corners.size(); ++c) {
    data.corners[c].uv = numbers(BitsAndIndex(glm::dvec3(uv[c], 0)));
    if (data.corners[c].uv == data.uvs.size()) data.uvs.push_back(uv[c]);
  }
  return data;
}

}  // namespace cg
