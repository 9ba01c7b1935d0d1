// Triangles into the z-buffer: edge functions in integers, depth from a plane. Eight triangles are set up at once.
#pragma once
#include "raster/visibility.h"

namespace cg {

// The rows of the visibility buffer that one thread may write.
struct Band {
  VisibilityBuffer* buffer;
  int top, bottom;  // rows, counted from the top; bottom is excluded
};

// The pixels whose centre may lie inside; empty where high < low. y is counted from the bottom, as in OpenGL.
struct PixelBox {
  int low_x, low_y, high_x, high_y;
  bool empty() const { return high_x < low_x || high_y < low_y; }
};

inline PixelBox pixel_box(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2) {
  const auto low = [](int a, int b, int c) { return (std::min({a, b, c}) + subpixels - 1) >> subpixel_bits; };
  const auto high = [](int a, int b, int c) { return std::max({a, b, c}) >> subpixel_bits; };
  return {low(v0.snapped_x, v1.snapped_x, v2.snapped_x), low(v0.snapped_y, v1.snapped_y, v2.snapped_y),
          high(v0.snapped_x, v1.snapped_x, v2.snapped_x), high(v0.snapped_y, v1.snapped_y, v2.snapped_y)};
}

// Draws triangles in the rows of `band`, in the order in which they are added. They wait until there are eight: the
// vertices must stay where they are, and flush() draws what is left.
class TriangleQueue {
 public:
  explicit TriangleQueue(const Band& band) : band_(band) {}

  void add(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
    put(v0, v1, v2, id);
    // Of a fine mesh many triangles lie between the pixels' centres: to count costs less than a branch guessed wrong.
    count_ += pixel_box(v0, v1, v2).empty() ? 0 : 1;
    if (count_ == lanes) flush();
  }
  // One that is known to have a pixel in its box. Its vertices are not looked at before there are eight.
  void add_seen(const std::array<const WindowVertex*, 3>& v, std::uint32_t id) {
    put(*v[0], *v[1], *v[2], id);
    if (++count_ == lanes) flush();
  }
  void flush();

 private:
  void put(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
    const std::size_t i = std::size_t(count_);
    vertices_[0][i] = &v0, vertices_[1][i] = &v1, vertices_[2][i] = &v2;
    ids_[i] = id;
  }

  Band band_;
  std::array<std::array<const WindowVertex*, lanes>, 3> vertices_;
  std::array<std::uint32_t, lanes> ids_;
  int count_ = 0;
};

// One triangle at once.
inline void draw_triangle(const Band& band, const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2,
                          std::uint32_t id) {
  TriangleQueue queue(band);
  queue.add(v0, v1, v2, id);
  queue.flush();
}

}  // namespace cg
