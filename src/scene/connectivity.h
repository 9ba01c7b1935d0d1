// Who is whose neighbour in a mesh: counts that say whether it is closed, orientable and manifold, and, through
// OpenMesh's half-edges, the faces around a vertex and the angle at an edge.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/mesh.h"

namespace cg {

// Counted over all faces but the degenerate ones. Vertices are the positions that faces name; equal positions with
// different indices are different vertices, as in the file.
struct Topology {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t boundary_edges = 0;  // of one face
  std::size_t flipped_edges = 0;   // of two faces that both run along it the same way: one of them is inside out
  std::size_t crowded_edges = 0;   // of three faces or more

  long euler_characteristic() const { return long(vertices) - long(edges) + long(faces); }
  bool closed() const { return boundary_edges == 0; }
  bool consistently_wound() const { return flipped_edges == 0 && crowded_edges == 0; }
  friend bool operator==(const Topology&, const Topology&) = default;
};

Topology topology(const Mesh& mesh);

// The half-edge structure. Faces that would make it non-manifold are refused and listed; the mesh still has them,
// they are drawn and lit like the others.
class Connectivity {
 public:
  explicit Connectivity(MeshHandle mesh);
  ~Connectivity();
  Connectivity(Connectivity&&) noexcept;
  Connectivity& operator=(Connectivity&&) noexcept;

  // Ascending: the faces that are degenerate, name a vertex twice, meet an edge from a side where there is a face
  // already, would close a second fan around a vertex, or are not among a vertex's first 16,384 faces (half-edges
  // are searched one by one).
  const std::vector<std::uint32_t>& refused_faces() const;

  std::size_t boundary_edges() const;
  // Closed chains of boundary edges: the rims of the holes.
  std::size_t boundary_loops() const;

  // The faces at a vertex, one after the other around it, clockwise seen from outside. `position` is an index into
  // the mesh's positions; empty where no face names it.
  std::vector<std::uint32_t> faces_around(std::uint32_t position) const;

  // The angle between the normals of the two faces at the edge from a to b: 0 where it is flat, towards pi where it
  // is sharp; radians. Nothing where the edge has not two faces.
  std::optional<double> bend(std::uint32_t a, std::uint32_t b) const;

 private:
  struct HalfEdges;
  std::unique_ptr<HalfEdges> half_edges_;
};

}  // namespace cg
