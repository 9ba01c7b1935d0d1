// One triangle into the z-buffer: edge functions in integers, depth from a plane.
#pragma once
#include "raster/visibility.h"

namespace cg {

// The rows of the visibility buffer that one thread may write.
struct Band {
  VisibilityBuffer* buffer;
  int top, bottom;  // rows, counted from the top; bottom is excluded
};

// Draws the triangle with the number `id` in the rows of `band`.
void draw_triangle(const Band& band, const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2,
                   std::uint32_t id);

// The pixels whose centre may lie inside; empty where high < low. y is counted from the bottom, as in OpenGL.
struct PixelBox {
  int low_x, low_y, high_x, high_y;
  bool empty() const { return high_x < low_x || high_y < low_y; }
};
PixelBox pixel_box(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2);

}  // namespace cg
