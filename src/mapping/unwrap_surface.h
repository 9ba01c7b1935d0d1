// A mesh as an unwrap sees it: which face lies across each edge, and the triangles of each face, in a frame in which
// the mesh is about one unit large.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "scene/mapping_parameters.h"
#include "scene/mesh.h"

namespace cg {

// An edge is named by the corner at which a face begins to run along it: corner c's edge leads to next(c). Faces
// without area are left out: they have no triangles, and nothing lies across their edges.
class UnwrapSurface {
 public:
  // Throws InputError, with `where` as the place, where an edge has three faces or more that are no pairs: there the
  // mesh is no surface. Where they are (two bodies touch along the edge: as many faces run along it one way as the
  // other), and where both of an edge's faces run along it the same way, nothing lies across it.
  UnwrapSurface(MeshHandle mesh, const std::string& where);

  const Mesh& mesh() const { return *mesh_; }
  std::size_t face_count() const { return mesh_->data().face_count(); }
  std::size_t corner_count() const { return face_of_.size(); }
  std::uint32_t first(std::uint32_t face) const { return mesh_->data().first_corner[face]; }
  std::uint32_t end(std::uint32_t face) const { return mesh_->data().first_corner[face + 1]; }

  std::uint32_t face_of(std::uint32_t corner) const { return face_of_[corner]; }
  std::uint32_t next(std::uint32_t corner) const {
    const std::uint32_t f = face_of_[corner];
    return corner + 1 == end(f) ? first(f) : corner + 1;
  }
  std::uint32_t last(std::uint32_t corner) const {
    const std::uint32_t f = face_of_[corner];
    return corner == first(f) ? end(f) - 1 : corner - 1;
  }
  // The corner of the face on the other side whose edge runs the opposite way, or no_index.
  std::uint32_t across(std::uint32_t corner) const { return across_[corner]; }
  std::size_t turned_edges() const { return turned_edges_; }

  std::uint32_t position_of(std::uint32_t corner) const { return mesh_->data().corners[corner].position; }
  // (p - centre)/extent.
  glm::dvec3 point(std::uint32_t corner) const {
    return (mesh_->data().positions[position_of(corner)] * 0.5 - half_centre_) * to_unit_;
  }

  // Those of the mesh, and triangles without area that reach the corners which the mesh's leave out; each is corners.
  const std::array<std::uint32_t, 3>& triangle(std::size_t t) const { return triangles_[t]; }
  std::size_t first_triangle(std::uint32_t face) const { return first_triangle_[face]; }
  bool has_area(std::uint32_t face) const { return first_triangle_[face] < first_triangle_[face + 1]; }

 private:
  void link(const std::string& where);
  void gather_triangles();

  MeshHandle mesh_;
  std::vector<std::uint32_t> face_of_, across_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::size_t> first_triangle_;
  std::size_t turned_edges_ = 0;
  glm::dvec3 half_centre_{0};
  double to_unit_ = 1;
};

// For each corner, whether its edge is cut: also where there is nothing across it.
using EdgeCuts = std::vector<char>;

// Borders only, and the marked edges; marks that are no edges of the mesh are left out.
EdgeCuts border_cuts(const UnwrapSurface& surface);
void cut_seams(const UnwrapSurface& surface, const std::vector<SeamEdge>& seams, EdgeCuts& cuts);

// The cut edges that have faces on both sides, each once, a < b, ascending.
std::vector<SeamEdge> seams_of(const UnwrapSurface& surface, const EdgeCuts& cuts);

// Faces that hang together without crossing a cut, numbered from 0 in the order of their first faces; no_index for a
// face without area.
struct ChartFaces {
  std::vector<std::uint32_t> chart_of;
  std::vector<std::vector<std::uint32_t>> faces;  // ascending
};
ChartFaces charts_between(const UnwrapSurface& surface, const EdgeCuts& cuts);

}  // namespace cg
