#include "mapping/uv_edit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <map>

#include "math/transform.h"

namespace cg {

namespace {

std::uint32_t position_of(const UvLayout& layout, std::uint32_t corner) {
  return layout.mesh->data().corners[corner].position;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

glm::dvec2 middle_of_face(const UvLayout& layout, std::uint32_t face) {
  const Corners corners = corners_of_face(layout, face);
  glm::dvec2 sum(0);
  for (const std::uint32_t c : corners) sum += layout.uv[c];
  return sum / double(std::max<std::size_t>(corners.size(), 1));
}

}  // namespace

Corners corners_of_face(const UvLayout& layout, std::uint32_t face) {
  Corners out;
  const MeshData& data = layout.mesh->data();
  if (face < data.face_count())
    for (std::uint32_t c = data.first_corner[face]; c < data.first_corner[face + 1]; ++c) out.push_back(c);
  return out;
}

Corners corners_of_chart(const UvLayout& layout, std::uint32_t chart) {
  Corners out;
  const MeshData& data = layout.mesh->data();
  for (std::uint32_t f = 0; f < layout.chart.size(); ++f)
    if (layout.chart[f] == chart && chart != no_index)
      for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c) out.push_back(c);
  return out;
}

Corners corners_within(const UvLayout& layout, const glm::dvec2& low, const glm::dvec2& high) {
  Corners out;
  for (std::uint32_t c = 0; c < layout.uv.size(); ++c) {
    const glm::dvec2& p = layout.uv[c];
    if (p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y) out.push_back(c);
  }
  return out;
}

Corners whole_vertices(const UvLayout& layout, const Corners& corners) {
  std::multimap<std::uint32_t, glm::dvec2> selected;
  for (const std::uint32_t c : corners) selected.emplace(position_of(layout, c), layout.uv[c]);
  Corners out;
  for (std::uint32_t c = 0; c < layout.uv.size(); ++c) {
    const auto [begin, end] = selected.equal_range(position_of(layout, c));
    if (std::any_of(begin, end, [&](const auto& s) { return s.second == layout.uv[c]; })) out.push_back(c);
  }
  return out;
}

std::optional<std::uint32_t> face_at(const UvLayout& layout, const glm::dvec2& p) {
  const std::vector<Triangle>& triangles = layout.mesh->triangles();
  for (std::size_t t = triangles.size(); t-- > 0;) {
    const auto& [a, b, c] = triangles[t].corner;
    const glm::dvec2 &pa = layout.uv[a], &pb = layout.uv[b], &pc = layout.uv[c];
    const double u = cross(pb - pa, p - pa), v = cross(pc - pb, p - pb), w = cross(pa - pc, p - pc);
    if (((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) && u + v + w != 0) return triangles[t].face;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> corner_near(const UvLayout& layout, const glm::dvec2& p, double reach) {
  std::optional<std::uint32_t> out;
  for (std::uint32_t c = 0; c < layout.uv.size(); ++c)
    if (const double d = glm::distance(layout.uv[c], p); d <= reach && (!out || d < glm::distance(layout.uv[*out], p)))
      out = c;
  return out;
}

glm::dvec2 uv_on_triangle(const UvLayout& layout, std::size_t t, const glm::dvec3& weight) {
  const auto& [a, b, c] = layout.mesh->triangles()[t].corner;
  return weight.x * layout.uv[a] + weight.y * layout.uv[b] + weight.z * layout.uv[c];
}

void transform_corners(CornerUv& uv, const Corners& corners, const UvTransform& how) {
  const double c = std::cos(radians(how.degrees)), s = std::sin(radians(how.degrees));
  for (const std::uint32_t i : corners) {
    const glm::dvec2 d = (uv[i] - how.centre) * how.scale;
    const glm::dvec2 p = how.centre + glm::dvec2(c * d.x - s * d.y, s * d.x + c * d.y) + how.offset;
    if (std::isfinite(p.x) && std::isfinite(p.y)) uv[i] = p;
  }
}

UvLayout transformed(const UvLayout& layout, const Corners& corners, const UvTransform& how) {
  CornerUv uv = layout.uv;
  transform_corners(uv, corners, how);
  return make_layout(layout.mesh, std::move(uv));
}

UvLayout welded(const UvLayout& layout, const Corners& corners) {
  struct Sum {
    glm::dvec2 uv{0};
    int count = 0;
  };
  std::map<std::uint32_t, Sum> at;
  for (const std::uint32_t c : corners)
    at[position_of(layout, c)].uv += layout.uv[c], ++at[position_of(layout, c)].count;
  CornerUv uv = layout.uv;
  for (const std::uint32_t c : corners) {
    const Sum& sum = at[position_of(layout, c)];
    if (sum.count > 1) uv[c] = sum.uv / double(sum.count);
  }
  return make_layout(layout.mesh, std::move(uv));
}

UvLayout stitched(const UvLayout& layout, const SeamEdge& edge) {
  const UnwrapSurface s(layout.mesh, "");
  std::uint32_t c = 0;
  const auto is_edge = [&](std::uint32_t k) {
    const int a = int(s.position_of(k)), b = int(s.position_of(s.next(k)));
    return std::minmax(a, b) == std::minmax(edge.a, edge.b) && s.across(k) != no_index;
  };
  while (c < s.corner_count() && !is_edge(c)) ++c;
  if (c == s.corner_count()) return layout;
  std::uint32_t d = s.across(c);
  if (layout.chart[s.face_of(c)] == layout.chart[s.face_of(d)]) return layout;
  const auto faces = [&](std::uint32_t k) {
    return std::count(layout.chart.begin(), layout.chart.end(), layout.chart[s.face_of(k)]);
  };
  if (faces(c) < faces(d)) std::swap(c, d);  // d's chart comes to c's
  using Complex = std::complex<double>;
  const auto at = [&](std::uint32_t k) { return Complex(layout.uv[k].x, layout.uv[k].y); };
  const Complex from = at(d), to = at(s.next(c));
  const Complex along = at(s.next(d)) - from;
  if (along == Complex(0)) return layout;
  const Complex turn = (at(c) - to) / along;
  CornerUv uv = layout.uv;
  const Corners moving = corners_of_chart(layout, layout.chart[s.face_of(d)]);
  for (const std::uint32_t k : moving) {
    const Complex p = to + turn * (at(k) - from);
    uv[k] = {p.real(), p.imag()};
  }
  // Exactly where the other side is.
  for (const auto& [own, other] : {std::pair(d, s.next(c)), std::pair(s.next(d), c)})
    for (const std::uint32_t k : moving)
      if (s.position_of(k) == s.position_of(own) && layout.uv[k] == layout.uv[own]) uv[k] = layout.uv[other];
  return make_layout(layout.mesh, std::move(uv));
}

UvLayout split_off(const UvLayout& layout, const std::vector<std::uint32_t>& faces, double gap) {
  std::vector<char> chosen(layout.mesh->data().face_count());
  Corners own;
  for (const std::uint32_t f : faces) {
    if (f >= chosen.size() || chosen[f]) continue;
    chosen[f] = 1;
    for (const std::uint32_t c : corners_of_face(layout, f)) own.push_back(c);
  }
  std::sort(own.begin(), own.end());
  const Corners all = whole_vertices(layout, own);
  // uv vertices that other faces have too.
  std::multimap<std::uint32_t, glm::dvec2> shared;
  for (const std::uint32_t c : all)
    if (!std::binary_search(own.begin(), own.end(), c)) shared.emplace(position_of(layout, c), layout.uv[c]);
  const auto is_shared = [&](std::uint32_t c) {
    const auto [begin, end] = shared.equal_range(position_of(layout, c));
    return std::any_of(begin, end, [&](const auto& v) { return v.second == layout.uv[c]; });
  };
  // One vertex of several chosen faces draws back as one: towards the middle of their middles.
  std::map<std::tuple<std::uint32_t, double, double>, std::pair<glm::dvec2, int>> middles;
  const auto key = [&](std::uint32_t c) { return std::tuple(position_of(layout, c), layout.uv[c].x, layout.uv[c].y); };
  for (const std::uint32_t f : faces)
    for (const std::uint32_t c : corners_of_face(layout, f)) {
      auto& [sum, count] = middles[key(c)];
      sum += middle_of_face(layout, f), ++count;
    }
  CornerUv uv = layout.uv;
  for (const std::uint32_t c : own) {
    if (!is_shared(c)) continue;
    const auto& [sum, count] = middles[key(c)];
    const glm::dvec2 way = sum / double(count) - layout.uv[c];
    const double length = std::hypot(way.x, way.y);
    if (length > 0) uv[c] += way * std::min(gap / length, 0.5);
  }
  return make_layout(layout.mesh, std::move(uv));
}

MeshHandle with_vertex_at(const Mesh& mesh, std::uint32_t position, const glm::dvec3& place) {
  MeshData data = mesh.data();
  data.positions.at(position) = place;
  return Mesh::make(std::move(data));
}

UvLayout on_mesh(const UvLayout& layout, MeshHandle mesh) { return make_layout(std::move(mesh), layout.uv); }

}  // namespace cg
