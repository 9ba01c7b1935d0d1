// An open square, so that its back can be seen.
#pragma once
#include "scene/mesh.h"

namespace cg {

// In the plane z = 0 from -1 to 1, facing +z.
inline MeshHandle square_mesh() {
  MeshData d;
  d.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const Corner quad[4] = {
      {0, no_index, no_index}, {1, no_index, no_index}, {2, no_index, no_index}, {3, no_index, no_index}};
  d.add_face(quad, quad + 4);
  return Mesh::make(std::move(d));
}

}  // namespace cg
