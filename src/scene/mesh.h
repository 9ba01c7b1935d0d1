// A polygon mesh as its file has it, never changed after it is made: positions, and, per corner, the normal and
// uv where there are some. OpenMesh answers questions about neighbours (scene/connectivity.h).
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace cg {

inline constexpr std::uint32_t no_index = 0xffffffffu;

// One corner of a face: indices into the mesh's lists; no_index where the file has none.
struct Corner {
  std::uint32_t position = no_index, normal = no_index, uv = no_index;
  friend bool operator==(const Corner&, const Corner&) = default;
};

// What a reader or a shape hands over. Faces are polygons: face f has the corners
// first_corner[f] .. first_corner[f+1]-1, counter-clockwise seen from outside.
struct MeshData {
  std::vector<glm::dvec3> positions;  // finite
  std::vector<glm::dvec3> normals;    // any length (as the file has them)
  std::vector<glm::dvec2> uvs;
  std::vector<Corner> corners;
  std::vector<std::uint32_t> first_corner{0};

  std::size_t face_count() const { return first_corner.size() - 1; }
  void add_face(const Corner* begin, const Corner* end) {
    corners.insert(corners.end(), begin, end);
    first_corner.push_back(std::uint32_t(corners.size()));
  }
};

// What is odd about a mesh: counted and shown, never silently mended.
struct MeshReport {
  std::size_t repeated_corners = 0;  // a face named a vertex twice in a row: dropped from the face
  std::size_t degenerate_faces = 0;  // fewer than three different corners, or no area: kept, not drawn
  std::size_t bad_normals = 0;       // zero length, or not finite
  friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

struct Triangle {
  // Indices into corners, counter-clockwise. The last is the face's last corner, so that OpenGL's provoking vertex
  // is the polygon's own; those triangles of a concave face that do not reach it end with their highest corner.
  std::array<std::uint32_t, 3> corner;
  std::uint32_t face;
};

class Mesh {
 public:
  // Validates (indices in range, positions finite, or std::invalid_argument: the readers have checked already),
  // drops repeated corners, ear-clips concave polygons.
  static std::shared_ptr<const Mesh> make(MeshData data);

  const MeshData& data() const { return data_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const MeshReport& report() const { return report_; }
  // Of the positions that faces use; the box of an empty mesh is the point 0.
  const glm::dvec3& low() const { return low_; }
  const glm::dvec3& high() const { return high_; }
  glm::dvec3 centre() const { return low_ * 0.5 + high_ * 0.5; }
  bool has_normals() const { return !data_.normals.empty(); }
  bool has_uvs() const { return !data_.uvs.empty(); }

 private:
  Mesh() = default;
  MeshData data_;
  std::vector<Triangle> triangles_;
  MeshReport report_;
  glm::dvec3 low_{0}, high_{0};
};

using MeshHandle = std::shared_ptr<const Mesh>;

}  // namespace cg
