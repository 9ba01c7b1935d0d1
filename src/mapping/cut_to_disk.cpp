// The cut graph of a surface is what a spanning tree of its faces does not cross, without its dead ends (Erickson and
// Har-Peled, Optimally Cutting a Surface into a Disk, 2004; Gu, Gortler and Hoppe, Geometry Images, 2002).
#include "mapping/cut_to_disk.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace cg {

namespace {

struct Neighbour {
  std::uint32_t vertex, corner;  // over the edge of this corner, in either direction
};

// The edges inside the chart, from each of its vertices.
std::vector<std::vector<Neighbour>> inner_edges(const UnwrapSurface& s, const EdgeCuts& cuts, const ChartMesh& chart,
                                                const std::vector<std::uint32_t>& vertex_of) {
  std::vector<std::vector<Neighbour>> out(chart.position.size());
  for (const std::uint32_t c : chart.corner) {
    if (cuts[c]) continue;
    out[vertex_of[c]].push_back({vertex_of[s.next(c)], c});  // the other direction comes from the other side's corner
  }
  return out;
}

void cut(const UnwrapSurface& s, std::uint32_t corner, EdgeCuts& cuts) {
  cuts[corner] = 1;
  cuts[s.across(corner)] = 1;
}

struct Ways {
  std::vector<double> distance;
  std::vector<Neighbour> from;  // the vertex before, and the edge from there
  std::uint32_t farthest = 0;
};

// Shortest ways from the sources along inner edges (Dijkstra).
Ways ways_from(const ChartMesh& chart, const std::vector<std::vector<Neighbour>>& edges,
               const std::vector<std::uint32_t>& sources) {
  Ways out{std::vector<double>(chart.position.size(), std::numeric_limits<double>::infinity()),
           std::vector<Neighbour>(chart.position.size(), {no_index, no_index}), sources.front()};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (const std::uint32_t v : sources) out.distance[v] = 0, front.push({0, v});
  while (!front.empty()) {
    const auto [d, v] = front.top();
    front.pop();
    if (d > out.distance[v]) continue;
    out.farthest = v;
    for (const Neighbour& n : edges[v]) {
      const double further = d + glm::distance(chart.position[v], chart.position[n.vertex]);
      if (further >= out.distance[n.vertex]) continue;
      out.distance[n.vertex] = further, out.from[n.vertex] = {v, n.corner};
      front.push({further, n.vertex});
    }
  }
  return out;
}

void cut_way(const UnwrapSurface& s, const Ways& ways, std::uint32_t to, EdgeCuts& cuts) {
  for (std::uint32_t v = to; ways.from[v].vertex != no_index; v = ways.from[v].vertex)
    cut(s, ways.from[v].corner, cuts);
}

// From the longest border to the nearest other one.
bool join_borders(const UnwrapSurface& s, const ChartMesh& chart, const std::vector<std::vector<Neighbour>>& edges,
                  EdgeCuts& cuts) {
  const auto longest = std::max_element(chart.loops.begin(), chart.loops.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const Ways ways = ways_from(chart, edges, *longest);
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
  std::vector<std::vector<Neighbour>> graph(chart.position.size());
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
          std::find_if(graph[end].begin(), graph[end].end(), [&](const Neighbour& n) { return !closed[n.corner]; });
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
      const std::uint32_t a = ways_from(chart, edges, {0}).farthest;
      const Ways ways = ways_from(chart, edges, {a});
      cut_way(s, ways, ways.farthest, cuts);
    } else if (chart.loops.size() < 2 || !join_borders(s, chart, edges, cuts)) {
      cut_handles(s, faces, chart, vertex_of, cuts);
      return;
    }
  }
}

}  // namespace cg
