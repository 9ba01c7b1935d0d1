#include "mapping/edge_paths.h"

#include <limits>
#include <queue>

namespace cg {

InnerEdges inner_edges(const UnwrapSurface& s, const EdgeCuts& cuts, const ChartMesh& chart,
                       const std::vector<std::uint32_t>& vertex_of) {
  InnerEdges out(chart.position.size());
  for (const std::uint32_t c : chart.corner)
    if (!cuts[c]) out[vertex_of[c]].push_back({vertex_of[s.next(c)], c});  // the other way: from the corner across
  return out;
}

std::vector<std::uint32_t> Ways::edges_to(std::uint32_t vertex) const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = vertex; from[v].vertex != no_index; v = from[v].vertex) out.push_back(from[v].corner);
  return out;
}

Ways ways_from(const InnerEdges& edges, const std::vector<std::uint32_t>& sources, const std::vector<char>& closed,
               const std::function<double(std::uint32_t)>& length_of) {
  Ways out{std::vector<double>(edges.size(), std::numeric_limits<double>::infinity()),
           std::vector<InnerEdge>(edges.size(), {no_index, no_index}), sources.front()};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (const std::uint32_t v : sources) out.distance[v] = 0, front.push({0, v});
  while (!front.empty()) {
    const auto [d, v] = front.top();
    front.pop();
    if (d > out.distance[v]) continue;
    out.farthest = v;
    for (const InnerEdge& e : edges[v]) {
      if (!closed.empty() && closed[e.vertex]) continue;
      const double further = d + length_of(e.corner);
      if (further >= out.distance[e.vertex]) continue;
      out.distance[e.vertex] = further, out.from[e.vertex] = {v, e.corner};
      front.push({further, e.vertex});
    }
  }
  return out;
}

}  // namespace cg
