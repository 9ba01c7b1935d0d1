#include "shading/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "math/transform.h"
#include "scene/numbering.h"
#include "scene/polygon.h"

namespace cg {

std::vector<std::uint32_t> weld_positions(const Mesh& mesh) {
  const auto& positions = mesh.data().positions;
  Numbering number(positions.size());
  std::vector<std::uint32_t> point(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) point[i] = number(BitsAndIndex(positions[i]));
  return point;
}

namespace {

using Index = std::uint32_t;

// What every rule but `file` starts from. Corners of degenerate faces have weight 0.
struct Facets {
  std::vector<glm::dvec3> normal;     // unit, one a face
  std::vector<double> corner_weight;  // of the corner's face at its vertex
};

// The inner angle at b, seen along the face's normal: more than pi where the polygon is concave.
double inner_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal) {
  const glm::dvec3 u = c - b, v = a - b, turn = glm::cross(u, v);
  const double angle = std::atan2(length_and_unit(turn).length, glm::dot(u, v));
  return glm::dot(turn, normal) < 0 ? 2 * pi - angle : angle;
}

// A power of two near the size of the mesh, so that products of its coordinates stay inside double's range.
double size_of(const Mesh& mesh) {
  const glm::dvec3 d = mesh.high() * 0.5 - mesh.low() * 0.5;
  const double size = std::max({d.x, d.y, d.z});
  return size > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(size), -1020, 1020)) : 1.0;
}

Facets facets(const Mesh& mesh, NormalRule rule) {
  const MeshData& data = mesh.data();
  const double size = size_of(mesh);
  Facets out{std::vector<glm::dvec3>(data.face_count(), glm::dvec3(0)), std::vector<double>(data.corners.size(), 0)};
  std::vector<glm::dvec3> polygon;
  Index done = no_index;
  for (const Triangle& t : mesh.triangles()) {
    if (t.face == done) continue;
    done = t.face;
    const Index begin = data.first_corner[t.face], n = data.first_corner[t.face + 1] - begin;
    polygon.resize(n);
    for (Index i = 0; i < n; ++i) polygon[i] = data.positions[data.corners[begin + i].position] / size;
    const auto [area, normal] = length_and_unit(vector_area(polygon));
    out.normal[t.face] = normal;
    for (Index i = 0; i < n; ++i)
      out.corner_weight[begin + i] = rule == NormalRule::mean   ? 1.0
                                     : rule == NormalRule::area ? area
                                                                : inner_angle(polygon[i ? i - 1 : n - 1], polygon[i],
                                                                              polygon[i + 1 < n ? i + 1 : 0], normal);
  }
  return out;
}

std::vector<Index> face_of_corners(const MeshData& data) {
  std::vector<Index> face(data.corners.size());
  for (Index f = 0; f < data.face_count(); ++f)
    std::fill(face.begin() + data.first_corner[f], face.begin() + data.first_corner[f + 1], f);
  return face;
}

// The corners at each point: those of point p are list[first[p]] .. list[first[p + 1]] - 1, ascending.
struct CornersOfPoints {
  std::vector<Index> first, list;
};

CornersOfPoints corners_of_points(const MeshData& data, const std::vector<Index>& point) {
  CornersOfPoints out{std::vector<Index>(point.size() + 1, 0), std::vector<Index>(data.corners.size())};
  for (const Corner& c : data.corners) ++out.first[point[c.position] + 1];
  std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
  std::vector<Index> next(out.first.begin(), out.first.end() - 1);
  for (Index c = 0; c < data.corners.size(); ++c) out.list[next[point[data.corners[c].position]]++] = c;
  return out;
}

// Disjoint sets of the corners around one point.
class Sets {
 public:
  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index i, Index j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<Index> parent_;
};

// Numbers the corners so that those that share an average have the same number.
class SmoothingGroups {
 public:
  SmoothingGroups(const MeshData& data, const std::vector<Index>& point, const Facets& facets, double crease_angle)
      : data_(data),
        point_(point),
        facets_(facets),
        face_(face_of_corners(data)),
        // An edge of exactly the crease angle is smooth, however its cosine was rounded.
        cosine_(std::cos(radians(crease_angle)) - 1e-12) {}

  std::vector<Index> groups() {
    const CornersOfPoints at = corners_of_points(data_, point_);
    std::vector<Index> group(data_.corners.size());
    for (std::size_t p = 0; p + 1 < at.first.size(); ++p) {
      const std::span<const Index> corners(at.list.data() + at.first[p], at.first[p + 1] - at.first[p]);
      join_over_smooth_edges(corners);
      for (Index i = 0; i < corners.size(); ++i) group[corners[i]] = corners[sets_.find(i)];
    }
    return group;
  }

 private:
  struct Spoke {
    Index other;   // the point at the edge's other end
    Index corner;  // among the corners at this point
    friend auto operator<=>(const Spoke&, const Spoke&) = default;
  };

  void join_over_smooth_edges(std::span<const Index> corners) {
    sets_.reset(corners.size());
    spokes_.clear();
    for (Index i = 0; i < corners.size(); ++i) {
      const Index c = corners[i], f = face_[c];
      if (facets_.normal[f] == glm::dvec3(0)) continue;
      const Index begin = data_.first_corner[f], end = data_.first_corner[f + 1];
      const Index before = c == begin ? end - 1 : c - 1, after = c + 1 == end ? begin : c + 1;
      for (const Index other : {before, after}) spokes_.push_back({point_[data_.corners[other].position], i});
    }
    std::sort(spokes_.begin(), spokes_.end());
    for (std::size_t s = 0; s < spokes_.size(); ++s) {
      // Two faces meet at an ordinary edge; where very many do, each looks at a few of them only.
      const std::size_t end = std::min(spokes_.size(), s + 16);
      for (std::size_t t = s + 1; t < end && spokes_[t].other == spokes_[s].other; ++t)
        if (glm::dot(normal(corners[spokes_[s].corner]), normal(corners[spokes_[t].corner])) >= cosine_)
          sets_.join(spokes_[s].corner, spokes_[t].corner);
    }
  }
  const glm::dvec3& normal(Index corner) const { return facets_.normal[face_[corner]]; }

  const MeshData& data_;
  const std::vector<Index>& point_;
  const Facets& facets_;
  std::vector<Index> face_;
  double cosine_;
  Sets sets_;
  std::vector<Spoke> spokes_;
};

std::vector<glm::dvec3> face_normals(const MeshData& data, const Facets& facets) {
  std::vector<glm::dvec3> out(data.corners.size());
  for (Index f = 0; f < data.face_count(); ++f)
    std::fill(out.begin() + data.first_corner[f], out.begin() + data.first_corner[f + 1], facets.normal[f]);
  return out;
}

std::vector<glm::dvec3> average_normals(const MeshData& data, const std::vector<Index>& point, const Facets& facets,
                                        double crease_angle) {
  std::vector<glm::dvec3> out = face_normals(data, facets);
  std::vector<Index> group;
  if (crease_angle < 180) group = SmoothingGroups(data, point, facets, crease_angle).groups();
  const auto group_of = [&](Index c) { return group.empty() ? point[data.corners[c].position] : group[c]; };

  struct Sum {
    glm::dvec3 normal{0};
    double weight = 0;
  };
  std::vector<Sum> sums(group.empty() ? point.size() : data.corners.size());
  for (Index c = 0; c < data.corners.size(); ++c) {
    Sum& s = sums[group_of(c)];
    s.normal += facets.corner_weight[c] * out[c];
    s.weight += facets.corner_weight[c];
  }
  for (Sum& s : sums) {
    const auto [length, unit] = length_and_unit(s.normal);
    s.normal = length > 1e-9 * s.weight ? unit : glm::dvec3(0);
  }
  for (Index c = 0; c < data.corners.size(); ++c) {
    const glm::dvec3& average = sums[group_of(c)].normal;
    if (out[c] != glm::dvec3(0) && average != glm::dvec3(0)) out[c] = average;
  }
  return out;
}

}  // namespace

std::vector<glm::dvec3> corner_normals(const Mesh& mesh, const std::vector<Index>& point, NormalRule rule,
                                       double crease_angle) {
  const MeshData& data = mesh.data();
  const auto from_file = [](const Corner& c) { return c.normal != no_index; };
  const bool all_from_file = std::all_of(data.corners.begin(), data.corners.end(), from_file);
  std::vector<glm::dvec3> out;
  if (rule == NormalRule::face)
    out = face_normals(data, facets(mesh, rule));
  else if (rule != NormalRule::file || !all_from_file)
    out = average_normals(data, point, facets(mesh, rule), crease_angle);
  if (rule != NormalRule::file) return out;
  out.resize(data.corners.size());
  for (std::size_t c = 0; c < data.corners.size(); ++c)
    if (from_file(data.corners[c])) {
      const glm::dvec3& n = data.normals[data.corners[c].normal];
      out[c] = is_finite(n) ? n : glm::dvec3(0);
    }
  return out;
}

}  // namespace cg
