#include "radiosity/faces.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "math/transform.h"
#include "scene/numbering.h"
#include "scene/polygon.h"

namespace cg {

namespace {

using Index = std::uint32_t;

// An object's mesh as faces, the corners as they are in the file.
class FacesOfObject {
 public:
  FacesOfObject(const Object& object, std::uint32_t index, SurfaceFaces& out)
      : data_(object.mesh->data()), index_(index), matrix_(matrix(object.transform)), out_(out) {
    mirrors_ = mirrors(object.transform);
  }

  void add(const std::vector<Triangle>& triangles) {
    for (std::size_t begin = 0, end; begin < triangles.size(); begin = end) {
      const Index f = triangles[begin].face;
      for (end = begin + 1; end < triangles.size() && triangles[end].face == f;) ++end;
      const Index first = data_.first_corner[f], corners = data_.first_corner[f + 1] - first;
      const std::size_t before = out_.faces.size();
      const std::array<Index, 4> quad{first, first + 1, first + 2, first + 3};
      if (corners != 4 || end - begin != 2 || !add_quad(quad, f))
        for (std::size_t t = begin; t < end; ++t) add_face(triangles[t].corner, f);
      out_.degenerate += out_.faces.size() == before;
    }
  }

 private:
  ElementVertex corner(Index c) const {
    const Corner& corner = data_.corners[c];
    const glm::dvec3& p = data_.positions[corner.position];
    ElementVertex v{.position = glm::dvec3(matrix_ * glm::dvec4(p, 1)), .local = p};
    if (corner.normal != no_index && is_finite(data_.normals[corner.normal])) v.normal = data_.normals[corner.normal];
    return v;
  }

  SurfaceFace face_of(std::span<const Index> corners, Index f) const {
    SurfaceFace face{.corners = int(corners.size()), .object = index_, .face = f};
    for (std::size_t i = 0; i < corners.size(); ++i) face.corner[i] = corner(corners[i]);
    // Seen in a mirror the corners run the other way round.
    if (mirrors_) std::reverse(face.corner.begin(), face.corner.begin() + face.corners);
    const auto positions = positions_of(face);
    face.normal = polygon_normal(std::span(positions).first(corners.size()));
    return face;
  }

  void add_face(std::span<const Index> corners, Index f) {
    const SurfaceFace face = face_of(corners, f);
    if (face.normal != glm::dvec3(0)) out_.faces.push_back(face);
  }

  // False where the quad is not plane or not convex.
  bool add_quad(std::span<const Index> corners, Index f) {
    const SurfaceFace face = face_of(corners, f);
    if (face.normal == glm::dvec3(0)) return true;
    const auto p = positions_of(face);
    const double size = std::max(glm::distance(p[0], p[2]), glm::distance(p[1], p[3]));
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 in = p[(i + 1) % 4] - p[i], out = p[(i + 2) % 4] - p[(i + 1) % 4];
      if (std::abs(glm::dot(face.normal, in)) > 1e-9 * size) return false;
      if (glm::dot(face.normal, glm::cross(in, out)) <= 1e-12 * size * size) return false;
    }
    out_.faces.push_back(face);
    return true;
  }

  const MeshData& data_;
  std::uint32_t index_;
  glm::dmat4 matrix_;
  bool mirrors_ = false;
  SurfaceFaces& out_;
};

// Joins the faces of an object that make one surface.
class Surfaces {
 public:
  explicit Surfaces(std::span<SurfaceFace> faces) : faces_(faces), parent_(faces.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    Numbering number(faces.size());
    for (Index f = 0; f < faces.size(); ++f)
      for (int i = 0; i < faces[f].corners; ++i)
        meetings_.push_back({number(BitsAndIndex(faces[f].corner[std::size_t(i)].local)), f, i});
  }

  // Numbers them from `first` on; returns the number behind the last.
  std::uint32_t join(std::uint32_t first) {
    join_planes();
    join_smooth_edges();
    std::vector<Index> name(faces_.size(), no_index);
    for (Index f = 0; f < faces_.size(); ++f) {
      Index& n = name[find(f)];
      if (n == no_index) n = first++;
      for (ElementVertex& v : faces_[f].corner) v.surface = n;
    }
    return first;
  }

 private:
  struct Meeting {
    Index point, face;
    int corner;
  };

  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(Index i, Index j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  // Faces that share a corner and their normal lie in one plane.
  void join_planes() {
    std::vector<Meeting> sorted = meetings_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
    std::vector<Index> different;  // a face for each normal at this point
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i == 0 || sorted[i].point != sorted[i - 1].point) different.clear();
      const Index f = sorted[i].face;
      const auto parallel = [&](Index g) {
        return glm::dot(faces_[f].normal, faces_[g].normal) > 0 &&
               glm::length(glm::cross(faces_[f].normal, faces_[g].normal)) < 1e-7;
      };
      const auto found = std::find_if(different.begin(), different.end(), parallel);
      if (found == different.end())
        different.push_back(f);
      else
        unite(f, *found);
    }
  }

  struct Side {
    Index low, high, face;  // the edge's points
    int at_low, at_high;    // corners of the face
  };

  // Faces that share an edge and, at both of its ends, the file's normal.
  void join_smooth_edges() {
    std::vector<Side> sides;
    for (std::size_t m = 0, end; m < meetings_.size(); m = end) {
      end = m + std::size_t(faces_[meetings_[m].face].corners);
      for (std::size_t i = m; i < end; ++i) {
        const Meeting &a = meetings_[i], &b = meetings_[i + 1 < end ? i + 1 : m];
        const bool up = a.point < b.point;
        sides.push_back({std::min(a.point, b.point), std::max(a.point, b.point), a.face, up ? a.corner : b.corner,
                         up ? b.corner : a.corner});
      }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
    for (std::size_t s = 1; s < sides.size(); ++s) {
      const Side &a = sides[s - 1], &b = sides[s];
      if (a.low != b.low || a.high != b.high) continue;
      const auto normal = [&](const Side& side, int corner) {
        return faces_[side.face].corner[std::size_t(corner)].normal;
      };
      const bool smooth = normal(a, a.at_low) == normal(b, b.at_low) && normal(a, a.at_high) == normal(b, b.at_high);
      if (smooth && normal(a, a.at_low) != glm::dvec3(0) && normal(a, a.at_high) != glm::dvec3(0))
        unite(a.face, b.face);
    }
  }

  std::span<SurfaceFace> faces_;
  std::vector<Index> parent_;
  std::vector<Meeting> meetings_;  // by face
};

}  // namespace

// Rotations do not mirror.
bool mirrors(const Transform& t) { return (t.scale.x < 0) != ((t.scale.y < 0) != (t.scale.z < 0)); }

std::array<glm::dvec3, 4> positions_of(const SurfaceFace& face) {
  std::array<glm::dvec3, 4> p{};
  for (std::size_t i = 0; i < std::size_t(face.corners); ++i) p[i] = face.corner[i].position;
  return p;
}

SurfaceFaces faces_of(const Scene& scene, const Progress& progress) {
  SurfaceFaces out;
  std::uint32_t surface = 0;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    const Object& object = scene.objects[o];
    if (!object.visible || !object.mesh) continue;
    if (progress.cancelled) throw Cancelled{};
    const std::size_t first = out.faces.size();
    FacesOfObject(object, o, out).add(object.mesh->triangles());
    out.degenerate += object.mesh->report().degenerate_faces;
    surface = Surfaces(std::span(out.faces).subspan(first)).join(surface);
  }
  return out;
}

}  // namespace cg
