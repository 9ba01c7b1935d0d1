// One chart as a triangle mesh of its own, in which a position on a cut has a vertex for each side.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mapping/unwrap_surface.h"

namespace cg {

struct ChartMesh {
  std::vector<glm::dvec3> position;                    // of each vertex, in the surface's frame
  std::vector<std::array<std::uint32_t, 3>> triangle;  // vertices, counter-clockwise
  std::vector<std::uint32_t> corner, vertex;           // the mesh's corners in the chart, and the vertex of each
  // Closed chains of border vertices with the chart to the left, and the corner whose edge leads from each to the next.
  std::vector<std::vector<std::uint32_t>> loops, loop_edges;
  std::size_t edges = 0;  // between faces

  long euler_characteristic(std::size_t faces) const { return long(position.size()) - long(edges) + long(faces); }
};

// `vertex_of` has one number a corner; those of the chart's corners are overwritten, so that charts can be made at the
// same time.
ChartMesh make_chart_mesh(const UnwrapSurface& surface, const EdgeCuts& cuts, std::span<const std::uint32_t> faces,
                          std::vector<std::uint32_t>& vertex_of);

inline bool is_disk(const ChartMesh& chart, std::size_t faces) {
  return chart.loops.size() == 1 && chart.euler_characteristic(faces) == 1;
}

// A triangle laid flat: (0, 0), (x1, 0), (x2, y2) with x1, y2 > 0. What is thinner than 1e-6 of its length is made that
// thick.
struct FlatTriangle {
  double x1, x2, y2;
  double area() const { return 0.5 * x1 * y2; }
};
FlatTriangle lay_flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace cg
