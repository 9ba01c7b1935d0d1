// Editing a layout: selections of corners, and functions from a layout to a layout. A layout is a value, so undo is a
// list of them. Corners of one vertex with the same uv are one uv vertex: what is split lies apart, what is welded has
// the same numbers.
#pragma once
#include <optional>

#include "mapping/uv_layout.h"

namespace cg {

using Corners = std::vector<std::uint32_t>;  // of the mesh, ascending

Corners corners_of_face(const UvLayout& layout, std::uint32_t face);
Corners corners_of_chart(const UvLayout& layout, std::uint32_t chart);
// Whose uv lie in the rectangle, its border included.
Corners corners_within(const UvLayout& layout, const glm::dvec2& low, const glm::dvec2& high);
// And all other corners of the same uv vertices: what moves without tearing.
Corners whole_vertices(const UvLayout& layout, const Corners& corners);

// The face in whose triangles the point of the texture lies; of several, the one drawn last.
std::optional<std::uint32_t> face_at(const UvLayout& layout, const glm::dvec2& uv);
// The nearest corner within `reach`.
std::optional<std::uint32_t> corner_near(const UvLayout& layout, const glm::dvec2& uv, double reach);
// Where a point of a face lies in the texture: `weight` belongs to the corners of the mesh's triangle `t`, sum 1.
glm::dvec2 uv_on_triangle(const UvLayout& layout, std::size_t t, const glm::dvec3& weight);

// p -> centre + R S (p - centre) + offset.
struct UvTransform {
  glm::dvec2 offset{0, 0}, centre{0, 0};
  double degrees = 0;  // counter-clockwise
  glm::dvec2 scale{1, 1};
};

// In place, and without finding the charts again: for a drag that whole_vertices keeps together. Numbers that would not
// be finite stay as they were.
void transform_corners(CornerUv& uv, const Corners& corners, const UvTransform& how);
UvLayout transformed(const UvLayout& layout, const Corners& corners, const UvTransform& how);

// The selected corners of each vertex of the mesh get their mean uv.
UvLayout welded(const UvLayout& layout, const Corners& corners);
// The chart on one side of a seam's edge, the one with fewer faces, is turned, scaled and moved onto the other, and
// joined to it there. The layout itself where there is no such edge, or both sides are one chart.
UvLayout stitched(const UvLayout& layout, const SeamEdge& edge);
// The faces come apart from the others: their corners there draw back by `gap` towards the faces' middles.
UvLayout split_off(const UvLayout& layout, const std::vector<std::uint32_t>& faces, double gap);

// The mesh with one of its vertices elsewhere, and the layout on it: its uv stay, its stretch does not.
MeshHandle with_vertex_at(const Mesh& mesh, std::uint32_t position, const glm::dvec3& place);
UvLayout on_mesh(const UvLayout& layout, MeshHandle mesh);

}  // namespace cg
