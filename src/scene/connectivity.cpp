// The half-edge structure is OpenMesh's (Botsch, Steinberg, Bischoff and Kobbelt, OpenMesh: A Generic and Efficient
// Polygon Mesh Data Structure, 2002). It ends the program on some malformed faces and complains on the terminal about
// others, so it is handed only such faces as it takes.
#include "scene/connectivity.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <span>

#include "math/vec.h"
#include "scene/polygon.h"

namespace cg {

namespace {

using Index = std::uint32_t;

std::span<const Corner> corners_of(const MeshData& data, Index face) {
  return {data.corners.data() + data.first_corner[face], data.first_corner[face + 1] - data.first_corner[face]};
}

// Faces with triangles: all but the degenerate ones, ascending.
std::vector<Index> drawn_faces(const Mesh& mesh) {
  std::vector<Index> out;
  for (const Triangle& t : mesh.triangles())
    if (out.empty() || out.back() != t.face) out.push_back(t.face);
  return out;
}

// An edge as one face runs along it.
struct DirectedEdge {
  Index low, high;  // the ends, whatever the direction
  bool upwards;     // from low to high
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

std::vector<DirectedEdge> directed_edges(const MeshData& data, std::span<const Index> faces) {
  std::vector<DirectedEdge> out;
  out.reserve(data.corners.size());
  for (const Index f : faces) {
    const auto corners = corners_of(data, f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index a = corners[i].position, b = corners[(i + 1) % corners.size()].position;
      out.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

Topology topology(const Mesh& mesh) {
  const MeshData& data = mesh.data();
  const std::vector<Index> faces = drawn_faces(mesh);
  const std::vector<DirectedEdge> edges = directed_edges(data, faces);
  Topology out;
  out.faces = faces.size();
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    const auto same = [&](const DirectedEdge& e) { return e.low == edges[begin].low && e.high == edges[begin].high; };
    for (end = begin + 1; end < edges.size() && same(edges[end]);) ++end;
    ++out.edges;
    out.boundary_edges += end - begin == 1;
    out.flipped_edges += end - begin == 2 && edges[begin].upwards == edges[begin + 1].upwards;
    out.crowded_edges += end - begin > 2;
  }
  std::vector<bool> used(data.positions.size());
  for (const DirectedEdge& e : edges) used[e.low] = used[e.high] = true;
  out.vertices = std::size_t(std::count(used.begin(), used.end(), true));
  return out;
}

struct Connectivity::HalfEdges {
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  using Vertex = OpenMesh::VertexHandle;

  MeshHandle source;
  Mesh mesh;
  std::vector<Index> face;  // of the source, for each of OpenMesh's faces
  std::vector<Index> refused;

  explicit HalfEdges(MeshHandle m) : source(std::move(m)) {
    static std::once_flag quiet;
    std::call_once(quiet, [] { omerr().disable(); });
    const MeshData& data = source->data();
    mesh.reserve(data.positions.size(), data.corners.size(), data.face_count());
    for (const glm::dvec3& p : data.positions) mesh.add_vertex({p.x, p.y, p.z});
    std::vector<Index> valence(data.positions.size(), 0);
    std::vector<Vertex> vertices;
    Index next = 0;
    for (const Index f : drawn_faces(*source)) {
      while (next < f) refused.push_back(next++);
      ++next;
      vertices.clear();
      for (const Corner& c : corners_of(data, f)) vertices.emplace_back(int(c.position));
      if (can_take(vertices, valence) && mesh.add_face(vertices).is_valid()) {
        face.push_back(f);
        for (const Vertex v : vertices) ++valence[std::size_t(v.idx())];
      } else {
        refused.push_back(f);
      }
    }
    while (next < data.face_count()) refused.push_back(next++);
  }

  // What add_face demands: different vertices, each with a gap in its fan, and half-edges that no face has.
  bool can_take(const std::vector<Vertex>& vertices, const std::vector<Index>& valence) const {
    std::vector<Vertex> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex a = vertices[i], b = vertices[(i + 1) % vertices.size()];
      if (!mesh.is_boundary(a) || valence[std::size_t(a.idx())] >= 16384) return false;
      const auto h = mesh.find_halfedge(a, b);
      if (h.is_valid() && !mesh.is_boundary(h)) return false;
    }
    return true;
  }

  glm::dvec3 normal(OpenMesh::FaceHandle f) const {
    std::vector<glm::dvec3> polygon;
    for (const Corner& c : corners_of(source->data(), face[std::size_t(f.idx())]))
      polygon.push_back(source->data().positions[c.position]);
    return polygon_normal(polygon);
  }
};

Connectivity::Connectivity(MeshHandle mesh) : half_edges_(std::make_unique<HalfEdges>(std::move(mesh))) {}
Connectivity::~Connectivity() = default;
Connectivity::Connectivity(Connectivity&&) noexcept = default;
Connectivity& Connectivity::operator=(Connectivity&&) noexcept = default;

const std::vector<Index>& Connectivity::refused_faces() const { return half_edges_->refused; }

std::size_t Connectivity::boundary_edges() const {
  const auto& mesh = half_edges_->mesh;
  return std::size_t(std::count_if(mesh.edges_begin(), mesh.edges_end(), [&](auto e) { return mesh.is_boundary(e); }));
}

std::size_t Connectivity::boundary_loops() const {
  const auto& mesh = half_edges_->mesh;
  std::vector<bool> seen(mesh.n_halfedges());
  std::size_t loops = 0;
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[std::size_t(start.idx())]) continue;
    ++loops;
    for (OpenMesh::HalfedgeHandle h = start; !seen[std::size_t(h.idx())]; h = mesh.next_halfedge_handle(h))
      seen[std::size_t(h.idx())] = true;
  }
  return loops;
}

std::vector<Index> Connectivity::faces_around(Index position) const {
  std::vector<Index> out;
  const auto& mesh = half_edges_->mesh;
  if (position >= mesh.n_vertices()) return out;
  for (auto f = mesh.cvf_cwbegin(OpenMesh::VertexHandle(int(position))); f.is_valid(); ++f)
    out.push_back(half_edges_->face[std::size_t(f->idx())]);
  return out;
}

std::optional<double> Connectivity::bend(Index a, Index b) const {
  const auto& mesh = half_edges_->mesh;
  if (a >= mesh.n_vertices() || b >= mesh.n_vertices()) return std::nullopt;
  const auto h = mesh.find_halfedge(OpenMesh::VertexHandle(int(a)), OpenMesh::VertexHandle(int(b)));
  if (!h.is_valid()) return std::nullopt;
  const auto left = mesh.face_handle(h), right = mesh.face_handle(mesh.opposite_halfedge_handle(h));
  if (!left.is_valid() || !right.is_valid()) return std::nullopt;
  const glm::dvec3 m = half_edges_->normal(left), n = half_edges_->normal(right);
  return std::atan2(glm::length(glm::cross(m, n)), glm::dot(m, n));
}

}  // namespace cg
