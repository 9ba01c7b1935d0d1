// How several threads share a picture's triangles: each draws rows of its own, or triangles of its own into a picture
// of its own. Both give the bits that one thread draws. This work is based on: Steven Molnar, Michael Cox, David
// Ellsworth, Henry Fuchs, A Sorting Classification of Parallel Rendering, 1994 (sort-middle, sort-last).
#pragma once
#include "raster/triangle_raster.h"

namespace cg {

// A run of an object's triangles.
struct TrianglePart {
  std::size_t object;
  Part triangles;
};
inline constexpr std::size_t triangles_a_part = 8192;  // at most: less than a millisecond's work

inline void draw_part(const Drawing& drawing, const TrianglePart& part, TriangleQueue& queue) {
  for_each_triangle(drawing.objects[part.object], part.triangles,
                    [&](const auto&... triangle) { queue.add(triangle...); });
}

// Each thread draws rows of its own: the triangles are sorted by rows first. `parts` in the order of drawing.
void draw_rows_apart(const Drawing& drawing, const std::vector<TrianglePart>& parts, Workers& workers,
                     std::vector<std::vector<std::uint32_t>>& in_band, VisibilityBuffer& out);

// Each thread takes runs of triangles and draws them into a picture of its own, the first into `out`; then these become
// one.
void draw_triangles_apart(const Drawing& drawing, const std::vector<TrianglePart>& parts, Workers& workers,
                          std::vector<VisibilityBuffer>& pictures, VisibilityBuffer& out);

}  // namespace cg
