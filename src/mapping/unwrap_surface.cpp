#include "mapping/unwrap_surface.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"

namespace cg {

namespace {

struct DirectedEdge {
  std::uint32_t low, high;  // positions
  std::uint32_t corner;
  bool upwards;  // the face runs from low to high
};

InputError too_many_faces(const std::string& where, std::size_t edges, const DirectedEdge& worst, std::size_t faces) {
  const std::string a = std::to_string(worst.low), b = std::to_string(worst.high), n = std::to_string(faces),
                    all = std::to_string(edges);
  return {where,
          {"the mesh is not a surface at " + all + (edges == 1 ? " edge" : " edges") + ": the one between vertices " +
               a + " and " + b + " (counted from 0) has " + n + " faces",
           "面のつながりが一意でない辺が " + all + " 本ある：頂点 " + a + " と " + b + "（0 から数える）の辺に面が " +
               n + " 枚ある"},
          {"an unwrap needs one or two faces at each edge: delete the inner faces, or give each sheet vertices of its "
           "own. A projection (planar, spherical, box) works as it is",
           "展開には辺ごとの面が 1 枚か 2 枚であることが必要。内側の面を消すか、頂点を面ごとに分けること。"
           "投影（平面、球、直方体）ならこのままで使える"}};
}

}  // namespace

UnwrapSurface::UnwrapSurface(MeshHandle mesh, const std::string& where) : mesh_(std::move(mesh)) {
  const MeshData& data = mesh_->data();
  face_of_.resize(data.corners.size());
  for (std::uint32_t f = 0; f < data.face_count(); ++f)
    std::fill(face_of_.begin() + data.first_corner[f], face_of_.begin() + data.first_corner[f + 1], f);
  const glm::dvec3 half = mesh_->high() * 0.5 - mesh_->low() * 0.5;
  const double extent = std::max({half.x, half.y, half.z});
  half_centre_ = mesh_->centre() * 0.5;
  to_unit_ = std::min(extent > 0 ? 1 / extent : 1, 1e300);
  gather_triangles();
  link(where);
}

void UnwrapSurface::gather_triangles() {
  const std::vector<Triangle>& all = mesh_->triangles();
  std::size_t t = 0;
  std::vector<std::array<std::uint32_t, 3>> of_face;
  for (std::uint32_t f = 0; f < face_count(); ++f) {
    first_triangle_.push_back(triangles_.size());
    const std::uint32_t begin = first(f), n = end(f) - begin;
    of_face.clear();
    for (; t < all.size() && all[t].face == f; ++t) of_face.push_back(all[t].corner);
    // A triangle's side that skips corners and has no triangle behind it: those corners lie on it.
    const std::size_t drawn = of_face.size();
    for (std::size_t k = 0; k < drawn && of_face.size() + 2 < n; ++k)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = of_face[k][i], b = of_face[k][(i + 1) % 3];
        const auto has_side = [&](const std::array<std::uint32_t, 3>& o) {
          return (o[0] == b && o[1] == a) || (o[1] == b && o[2] == a) || (o[2] == b && o[0] == a);
        };
        if (std::any_of(of_face.begin(), of_face.begin() + long(drawn), has_side)) continue;
        for (std::uint32_t step = (b + n - a) % n; step > 1; --step) {
          const std::uint32_t c = begin + (a - begin + step) % n, d = begin + (a - begin + step - 1) % n;
          of_face.push_back({a, d, c});
        }
      }
    triangles_.insert(triangles_.end(), of_face.begin(), of_face.end());
  }
  first_triangle_.push_back(triangles_.size());
}

void UnwrapSurface::link(const std::string& where) {
  across_.assign(corner_count(), no_index);
  std::vector<DirectedEdge> edges;
  for (std::uint32_t c = 0; c < corner_count(); ++c) {
    if (!has_area(face_of_[c])) continue;
    const std::uint32_t a = position_of(c), b = position_of(next(c));
    edges.push_back({std::min(a, b), std::max(a, b), c, a < b});
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
  });
  std::size_t crowded = 0, most = 0, worst = 0;
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    for (end = begin + 1;
         end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high;)
      ++end;
    const auto upwards = std::count_if(edges.begin() + long(begin), edges.begin() + long(end),
                                       [](const DirectedEdge& e) { return e.upwards; });
    if (end - begin > 2 && 2 * std::size_t(upwards) != end - begin) {
      ++crowded;
      if (end - begin > most) most = end - begin, worst = begin;
    } else if (end - begin == 2) {
      const DirectedEdge &a = edges[begin], &b = edges[begin + 1];
      if (a.upwards == b.upwards || face_of_[a.corner] == face_of_[b.corner])
        ++turned_edges_;
      else
        across_[a.corner] = b.corner, across_[b.corner] = a.corner;
    }
  }
  if (crowded > 0) throw too_many_faces(where, crowded, edges[worst], most);
}

EdgeCuts border_cuts(const UnwrapSurface& surface) {
  EdgeCuts cuts(surface.corner_count());
  for (std::uint32_t c = 0; c < cuts.size(); ++c) cuts[c] = surface.across(c) == no_index;
  return cuts;
}

void cut_seams(const UnwrapSurface& surface, const std::vector<SeamEdge>& seams, EdgeCuts& cuts) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> marked;
  for (const SeamEdge& s : seams)
    marked.emplace_back(std::uint32_t(std::min(s.a, s.b)), std::uint32_t(std::max(s.a, s.b)));
  std::sort(marked.begin(), marked.end());
  for (std::uint32_t c = 0; c < cuts.size(); ++c) {
    const std::uint32_t a = surface.position_of(c), b = surface.position_of(surface.next(c));
    if (std::binary_search(marked.begin(), marked.end(), std::pair(std::min(a, b), std::max(a, b)))) cuts[c] = 1;
  }
}

std::vector<SeamEdge> seams_of(const UnwrapSurface& surface, const EdgeCuts& cuts) {
  std::vector<SeamEdge> out;
  for (std::uint32_t c = 0; c < cuts.size(); ++c) {
    if (!cuts[c] || surface.across(c) == no_index || surface.across(c) < c) continue;
    const int a = int(surface.position_of(c)), b = int(surface.position_of(surface.next(c)));
    out.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(out.begin(), out.end(),
            [](const SeamEdge& a, const SeamEdge& b) { return std::tie(a.a, a.b) < std::tie(b.a, b.b); });
  return out;
}

ChartFaces charts_between(const UnwrapSurface& surface, const EdgeCuts& cuts) {
  ChartFaces out;
  out.chart_of.assign(surface.face_count(), no_index);
  for (std::uint32_t start = 0; start < surface.face_count(); ++start) {
    if (out.chart_of[start] != no_index || !surface.has_area(start)) continue;
    const std::uint32_t chart = std::uint32_t(out.faces.size());
    std::vector<std::uint32_t> reached{start};
    out.chart_of[start] = chart;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (std::uint32_t c = surface.first(reached[i]); c < surface.end(reached[i]); ++c) {
        if (cuts[c]) continue;
        const std::uint32_t other = surface.face_of(surface.across(c));
        if (out.chart_of[other] == no_index) out.chart_of[other] = chart, reached.push_back(other);
      }
    std::sort(reached.begin(), reached.end());
    out.faces.push_back(std::move(reached));
  }
  return out;
}

}  // namespace cg
