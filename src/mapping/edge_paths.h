// Shortest ways along the edges inside a chart.
#pragma once
#include <functional>

#include "mapping/chart_mesh.h"

namespace cg {

struct InnerEdge {
  std::uint32_t vertex, corner;  // where it leads, and the corner whose edge it is, or the one across from it
};
using InnerEdges = std::vector<std::vector<InnerEdge>>;  // from each of the chart's vertices

// `vertex_of` as make_chart_mesh left it.
InnerEdges inner_edges(const UnwrapSurface& surface, const EdgeCuts& cuts, const ChartMesh& chart,
                       const std::vector<std::uint32_t>& vertex_of);

struct Ways {
  std::vector<double> distance;  // infinite where no way leads
  std::vector<InnerEdge> from;   // the vertex before, and the edge from there; no_index at a source
  std::uint32_t farthest = 0;

  // The edges from the vertex back to its source.
  std::vector<std::uint32_t> edges_to(std::uint32_t vertex) const;
};

// From the sources to all vertices that are not closed, an edge's length by `length_of(corner)` (Dijkstra, A Note on
// Two Problems in Connexion with Graphs, 1959).
Ways ways_from(const InnerEdges& edges, const std::vector<std::uint32_t>& sources, const std::vector<char>& closed,
               const std::function<double(std::uint32_t)>& length_of);

}  // namespace cg
