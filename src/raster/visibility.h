// Which triangle each pixel shows: a z-buffer with, beside each depth, the number of the triangle. Nothing is
// shaded here, so that later each visible pixel is shaded once.
// This work is based on: Edwin Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces, 1974
// (z-buffer); Juan Pineda, A Parallel Algorithm for Polygon Rasterization, 1988 (edge functions);
// The OpenGL Graphics System 2.1, section 3.5.1 (which pixels, which depth).
#pragma once
#include <tbb/cache_aligned_allocator.h>

#include <span>

#include "raster/drawing.h"
#include "raster/lanes.h"

namespace cg {

// Eight neighbouring pixels, beginning at a multiple of eight: a cache line. All triangles write to the same groups, as
// a processor reads what it has just written without waiting only where it reads the same eight.
struct alignas(64) PixelGroup {
  Lanes<float> depth;             // window depth; 1 where nothing is
  Lanes<std::uint32_t> triangle;  // Drawing's number, or no_triangle
};

// Row 0 is the top row, as in Image. In memory, groups stand in tiles of 8x8 pixels, so that a small triangle finds its
// pixels side by side and a processor needs few pages at a time. What stands in the padding to whole tiles means
// nothing.
class VisibilityBuffer {
 public:
  int width = 0, height = 0;

  static int whole_tiles(int rows);  // rounded up to them
  // Of a picture of that size.
  static std::size_t bytes(int w, int h);
  std::size_t bytes() const { return groups_.capacity() * sizeof(PixelGroup); }
  // Room for a picture; its pixels mean nothing before they are cleared.
  void resize(int w, int h);
  // Room for the tiles with row y alone, cleared.
  void clear_around_row(int w, int h, int y);
  void clear(int w, int h);
  int tile_rows() const { return (height + tile_height - 1) / tile_height; }
  void clear_tile_row(int tile_y);
  std::span<PixelGroup> tile_row(int tile_y);

  // The pixels x / 8 * 8 .. + 7 of row y.
  PixelGroup& group(int x, int y) { return groups_[index(x, y)]; }
  const PixelGroup& group(int x, int y) const { return groups_[index(x, y)]; }
  float depth(int x, int y) const { return group(x, y).depth[x % lanes]; }
  std::uint32_t triangle(int x, int y) const { return group(x, y).triangle[x % lanes]; }

  static constexpr int tile_height = 8;

 private:
  static unsigned groups_a_row(int w);
  std::size_t index(int x, int y) const {
    const unsigned row = unsigned(y),
                   tile = (row / tile_height - first_tile_row_) * groups_a_row_ + unsigned(x) / lanes;
    return std::size_t(tile) * tile_height + row % tile_height;
  }
  unsigned groups_a_row_ = 0, first_tile_row_ = 0;
  std::vector<PixelGroup, tbb::cache_aligned_allocator<PixelGroup>> groups_;
};

// What several threads hold beside the picture, kept from picture to picture.
struct ThreadsMemory {
  std::vector<VisibilityBuffer> pictures;           // of the threads but the first, where each draws into its own
  std::vector<std::vector<std::uint32_t>> in_band;  // triangles, by part and by band, where each draws rows of its own
  std::size_t bytes() const;
};

// Which of the two ways threads take, by what costs less: triangles of their own, each into a picture of its own.
bool draws_triangles_apart(std::size_t triangles, int width, int height, int threads);

// Fills `out`, of the picture's size. Of triangles at the same depth the one drawn first stays, as with
// GL_LESS. Both faces are drawn.
void find_visible(const Drawing& drawing, Workers& workers, ThreadsMemory& memory, VisibilityBuffer& out);

// The same for the pixel (x, y) of a picture of width x height, row 0 at the top: the number of its triangle, or
// no_triangle.
std::uint32_t visible_at(const Drawing& drawing, int width, int height, int x, int y);

}  // namespace cg
