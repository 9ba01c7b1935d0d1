#include "scene/mesh.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "math/vec.h"
#include "scene/polygon.h"

namespace cg {

namespace {

void check(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

void check(const MeshData& data) {
  check(!data.first_corner.empty() && data.first_corner.front() == 0, "the first face must begin at corner 0");
  check(std::is_sorted(data.first_corner.begin(), data.first_corner.end()), "faces must follow one another");
  check(data.corners.size() < no_index && data.first_corner.back() == data.corners.size(),
        "the last face must end at the last corner");
  for (const Corner& c : data.corners) {
    check(c.position < data.positions.size(), "a corner's position is out of range");
    check(c.normal == no_index || c.normal < data.normals.size(), "a corner's normal is out of range");
    check(c.uv == no_index || c.uv < data.uvs.size(), "a corner's uv is out of range");
  }
  for (const glm::dvec3& p : data.positions) check(is_finite(p), "a position is not finite");
}

// Takes out the corners whose position is that of the corner before them (before the first: the last).
std::size_t drop_repeated_corners(MeshData& data) {
  std::size_t kept = 0;
  for (std::size_t f = 0, begin = 0; f < data.face_count(); ++f) {
    const std::size_t end = data.first_corner[f + 1], start = kept;
    for (std::size_t c = begin; c < end; ++c)
      if (kept == start || data.corners[kept - 1].position != data.corners[c].position)
        data.corners[kept++] = data.corners[c];
    while (kept > start + 1 && data.corners[kept - 1].position == data.corners[start].position) --kept;
    begin = end;
    data.first_corner[f + 1] = std::uint32_t(kept);
  }
  const std::size_t dropped = data.corners.size() - kept;
  data.corners.resize(kept);
  return dropped;
}

// The triangles of all faces, and how many faces have none.
std::size_t triangulate_faces(const MeshData& data, std::vector<Triangle>& triangles) {
  std::size_t degenerate = 0;
  std::vector<glm::dvec3> polygon;
  std::vector<std::array<std::uint32_t, 3>> pieces;
  triangles.reserve(data.corners.size() - std::min(data.corners.size(), 2 * data.face_count()));
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    const std::uint32_t begin = data.first_corner[f], end = data.first_corner[f + 1];
    polygon.clear(), pieces.clear();
    for (std::uint32_t c = begin; c < end; ++c) polygon.push_back(data.positions[data.corners[c].position]);
    degenerate += !triangulate(polygon, pieces);
    for (const auto& [a, b, c] : pieces) triangles.push_back({{begin + a, begin + b, begin + c}, std::uint32_t(f)});
  }
  return degenerate;
}

}  // namespace

std::shared_ptr<const Mesh> Mesh::make(MeshData data) {
  check(data);
  std::shared_ptr<Mesh> mesh(new Mesh);
  mesh->report_.repeated_corners = drop_repeated_corners(data);
  mesh->report_.degenerate_faces = triangulate_faces(data, mesh->triangles_);
  mesh->report_.bad_normals =
      std::size_t(std::count_if(data.normals.begin(), data.normals.end(),
                                [](const glm::dvec3& n) { return n == glm::dvec3(0) || !is_finite(n); }));
  if (!data.corners.empty()) {
    mesh->low_ = glm::dvec3(std::numeric_limits<double>::infinity());
    mesh->high_ = -mesh->low_;
    for (const Corner& c : data.corners) {
      mesh->low_ = glm::min(mesh->low_, data.positions[c.position]);
      mesh->high_ = glm::max(mesh->high_, data.positions[c.position]);
    }
  }
  mesh->data_ = std::move(data);
  return mesh;
}

}  // namespace cg
