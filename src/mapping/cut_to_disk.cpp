// The cut graph of a surface is what a spanning tree of its faces does not cross, without its dead ends (Erickson and
// Har-Peled, Optimally Cutting a Surface into a Disk, 2004; Gu, Gortler and Hoppe, Geometry Images, 2002).
#include "mapping/cut_to_disk.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "mapping/edge_paths.h"

namespace cg {

namespace {

void cut(const UnwrapSurface& s, std::uint32_t corner, EdgeCuts& cuts) {
  cuts[corner] = 1;
  cuts[s.across(corner)] = 1;
}

void cut_way(const UnwrapSurface& s, const Ways& ways, std::uint32_t to, EdgeCuts& cuts) {
  for (const std::uint32_t c : ways.edges_to(to)) cut(s, c, cuts);
}

Ways shortest_ways(const UnwrapSurface& s, const InnerEdges& edges, const std::vector<std::uint32_t>& sources) {
  return ways_from(edges, sources, {}, [&](std::uint32_t c) { return glm::distance(s.point(c), s.point(s.next(c))); });
}

// From the longest border to the nearest other one.
bool join_borders(const UnwrapSurface& s, const ChartMesh& chart, const InnerEdges& edges, EdgeCuts& cuts) {
  const auto longest = std::max_element(chart.loops.begin(), chart.loops.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const Ways ways = shortest_ways(s, edges, *longest);
  std::uint32_t nearest = no_index;
  for (const auto& loop : chart.loops) {
    if (&loop == &*longest) continue;
    for (const std::uint32_t v : loop)
      if (ways.from[v].vertex != no_index && (nearest == no_index || ways.distance[v] < ways.distance[nearest]))
        nearest = v;
  }
  if (nearest == no_index) return false;
  cut_way(s, ways, nearest, cuts);
  return true;
}

// Cuts what a spanning tree of the faces does not cross, and closes the dead ends again.
void cut_handles(const UnwrapSurface& s, const std::vector<std::uint32_t>& faces, const ChartMesh& chart,
                 const std::vector<std::uint32_t>& vertex_of, EdgeCuts& cuts) {
  std::vector<char> reached(s.face_count()), crossed(s.corner_count());
  std::vector<std::uint32_t> queue{faces.front()};
  reached[faces.front()] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (std::uint32_t c = s.first(queue[i]); c < s.end(queue[i]); ++c) {
      if (cuts[c] || reached[s.face_of(s.across(c))]) continue;
      reached[s.face_of(s.across(c))] = 1;
      crossed[c] = crossed[s.across(c)] = 1;
      queue.push_back(s.face_of(s.across(c)));
    }
  InnerEdges graph(chart.position.size());
  std::vector<std::size_t> degree(chart.position.size());
  for (const std::uint32_t c : chart.corner) {
    if (cuts[c] || crossed[c]) continue;
    graph[vertex_of[c]].push_back({vertex_of[s.next(c)], c});
    ++degree[vertex_of[c]];
  }
  for (const auto& loop : chart.loops)
    for (const std::uint32_t v : loop) degree[v] += 2;  // no dead end: the border goes on
  std::vector<char> closed(s.corner_count());
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    for (std::uint32_t end = v; degree[end] == 1;) {
      const auto edge =
          std::find_if(graph[end].begin(), graph[end].end(), [&](const InnerEdge& n) { return !closed[n.corner]; });
      closed[edge->corner] = closed[s.across(edge->corner)] = 1;
      --degree[end], --degree[edge->vertex];
      end = edge->vertex;
    }
  for (const std::uint32_t c : chart.corner)
    if (!cuts[c] && !crossed[c] && !closed[c]) cut(s, c, cuts);
}

}  // namespace

void cut_to_disk(const UnwrapSurface& s, const std::vector<std::uint32_t>& faces, EdgeCuts& cuts,
                 std::vector<std::uint32_t>& vertex_of) {
  for (;;) {
    const ChartMesh chart = make_chart_mesh(s, cuts, faces, vertex_of);
    if (is_disk(chart, faces.size())) return;
    const auto edges = inner_edges(s, cuts, chart, vertex_of);
    if (chart.loops.empty() && chart.euler_characteristic(faces.size()) == 2) {
      const std::uint32_t a = shortest_ways(s, edges, {0}).farthest;
      const Ways ways = shortest_ways(s, edges, {a});
      cut_way(s, ways, ways.farthest, cuts);
    } else if (chart.loops.size() < 2 || !join_borders(s, chart, edges, cuts)) {
      cut_handles(s, faces, chart, vertex_of, cuts);
      return;
    }
  }
}

}  // namespace cg
