#include "mapping/chart_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/vec.h"

namespace cg {

namespace {

// Gives `number` to all corners of the fan around corner `c`'s position that no cut separates.
void number_fan(const UnwrapSurface& s, const EdgeCuts& cuts, std::uint32_t c, std::uint32_t number,
                std::vector<std::uint32_t>& vertex_of) {
  vertex_of[c] = number;
  for (std::uint32_t k = c; !cuts[k];) {  // over the edge that leaves the vertex
    k = s.next(s.across(k));
    if (k == c) return;
    vertex_of[k] = number;
  }
  for (std::uint32_t k = c; !cuts[s.last(k)];) {  // over the edge that comes to it
    k = s.across(s.last(k));
    if (k == c) return;
    vertex_of[k] = number;
  }
}

// The border edge that follows `c`'s: around the vertex at its end, the chart to the left.
std::uint32_t next_border(const UnwrapSurface& s, const EdgeCuts& cuts, std::uint32_t c) {
  std::uint32_t k = s.next(c);
  while (!cuts[k]) k = s.next(s.across(k));
  return k;
}

void add_loops(const UnwrapSurface& s, const EdgeCuts& cuts, const std::vector<std::uint32_t>& vertex_of,
               ChartMesh& chart) {
  std::vector<char> seen(chart.position.size());
  std::vector<std::uint32_t> borders;
  for (const std::uint32_t c : chart.corner)
    if (cuts[c]) borders.push_back(c);
  for (const std::uint32_t start : borders) {
    if (seen[vertex_of[start]]) continue;
    chart.loops.emplace_back(), chart.loop_edges.emplace_back();
    std::uint32_t c = start;
    do {
      seen[vertex_of[c]] = 1;
      chart.loops.back().push_back(vertex_of[c]);
      chart.loop_edges.back().push_back(c);
      c = next_border(s, cuts, c);
    } while (c != start);
  }
}

}  // namespace

ChartMesh make_chart_mesh(const UnwrapSurface& s, const EdgeCuts& cuts, std::span<const std::uint32_t> faces,
                          std::vector<std::uint32_t>& vertex_of) {
  ChartMesh out;
  std::size_t inner = 0;
  for (const std::uint32_t f : faces)
    for (std::uint32_t c = s.first(f); c < s.end(f); ++c) {
      vertex_of[c] = no_index;
      out.corner.push_back(c);
      inner += !cuts[c];
    }
  out.edges = out.corner.size() - inner / 2;
  for (const std::uint32_t c : out.corner)
    if (vertex_of[c] == no_index) {
      number_fan(s, cuts, c, std::uint32_t(out.position.size()), vertex_of);
      out.position.push_back(s.point(c));
    }
  for (const std::uint32_t c : out.corner) out.vertex.push_back(vertex_of[c]);
  for (const std::uint32_t f : faces)
    for (std::size_t t = s.first_triangle(f); t < s.first_triangle(f + 1); ++t) {
      const auto& [a, b, c] = s.triangle(t);
      out.triangle.push_back({vertex_of[a], vertex_of[b], vertex_of[c]});
    }
  add_loops(s, cuts, vertex_of, out);
  return out;
}

FlatTriangle lay_flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto [length, along] = length_and_unit(b - a);
  const glm::dvec3 side = c - a;
  const double x2 = glm::dot(side, along), y2 = glm::length(side - x2 * along);
  const double longest = std::max({length, glm::length(side), glm::length(c - b), 1e-12});
  return {std::max(length, 1e-6 * longest), x2, std::max(y2, 1e-6 * longest)};
}

}  // namespace cg
