// Which triangle each pixel shows: a z-buffer with, beside each depth, the number of the triangle. Nothing is
// shaded here, so that later each visible pixel is shaded once.
// This work is based on: Edwin Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces, 1974
// (z-buffer); Juan Pineda, A Parallel Algorithm for Polygon Rasterization, 1988 (edge functions);
// The OpenGL Graphics System 2.1, section 3.5.1 (which pixels, which depth).
#pragma once
#include <tbb/cache_aligned_allocator.h>

#include "raster/drawing.h"

namespace cg {

// Pixels eight at a time, in groups that begin at multiples of eight in every triangle: a processor reads what it
// has just written without waiting only where it reads the same eight. Rows are padded to whole groups.
inline constexpr int lanes = 8;

// Row 0 is the top row, as in Image.
struct VisibilityBuffer {
  int width = 0, height = 0;
  std::size_t stride = 0;
  template <class T>
  using Pixels = std::vector<T, tbb::cache_aligned_allocator<T>>;
  Pixels<float> depth;             // window depth; 1 where nothing is
  Pixels<std::uint32_t> triangle;  // Drawing's number, or no_triangle

  void clear(int w, int h);
  std::size_t row(int y) const { return std::size_t(y) * stride; }
};

// Fills `out`, of the picture's size and cleared. Of triangles at the same depth the one drawn first stays, as with
// GL_LESS. Both faces are drawn.
void find_visible(const Drawing& drawing, Workers& workers, VisibilityBuffer& out);

// The same for the pixel (x, y) of a picture of width x height, row 0 at the top: the number of its triangle, or
// no_triangle.
std::uint32_t visible_at(const Drawing& drawing, int width, int height, int x, int y);

}  // namespace cg
