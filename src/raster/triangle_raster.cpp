#include "raster/triangle_raster.h"

namespace cg {

namespace {

// The depth of a triangle's plane at pixel (x, y). Its arithmetic is that of Mesa's llvmpipe (lp_state_setup.c,
// lp_bld_interp.c), a float plane through the window's origin, so that where two triangles meet at a grazing angle
// the same one wins.
struct DepthPlane {
  float at_origin, dx, dy;

  DepthPlane(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2) {
    const float x01 = v0.x - v1.x, y01 = v0.y - v1.y, z01 = v0.z - v1.z;
    const float x20 = v2.x - v0.x, y20 = v2.y - v0.y, z20 = v2.z - v0.z;
    const float area_inverse = 1.0f / (x01 * y20 - y01 * x20);
    dx = z01 * (y20 * area_inverse) - z20 * (y01 * area_inverse);
    dy = z20 * (x01 * area_inverse) - z01 * (x20 * area_inverse);
    at_origin = v0.z - (dx * (v0.x - 0.5f) + dy * (v0.y - 0.5f));
  }

  float at(float x, float y) const { return multiply_add(dy, y, multiply_add(dx, x, at_origin)); }
};

// E(x, y) = c + x dx + y dy at pixel centres; inside is E >= 0. Pixel steps are subpixels * (difference of
// coordinates), so E can be divided by `subpixels` and rounded down without changing its sign at any pixel: that
// keeps it small.
template <class Int>
struct Edge {
  Int c, dx, dy;  // c at the pixel box's corner

  // From a to b, the triangle to its left (in y-up coordinates of a counter-clockwise triangle).
  Edge(const WindowVertex& a, const WindowVertex& b, int x, int y) {
    const std::int64_t ex = std::int64_t(b.snapped_x) - a.snapped_x, ey = std::int64_t(b.snapped_y) - a.snapped_y;
    // OpenGL leaves open to whom a centre that lies exactly on an edge belongs, but it must be one of the two. Ours
    // is the rule of a top-left filler in a picture whose row 0 is the bottom: left edges and bottom edges.
    const bool inclusive = ey < 0 || (ey == 0 && ex > 0);
    const std::int64_t at_corner = ex * (std::int64_t(y) * subpixels - a.snapped_y) -
                                   ey * (std::int64_t(x) * subpixels - a.snapped_x) - (inclusive ? 0 : 1);
    c = Int(at_corner >> subpixel_bits);
    dx = Int(-ey);
    dy = Int(ex);
  }
};

// Depth test and write of `lanes` pixels beginning at x, where the three edges are `e` and step by `dx`.
template <class Int>
inline void draw_lanes(float* depth, std::uint32_t* triangle, const Int (&e)[3], const Edge<Int> (&edges)[3],
                       const DepthPlane& plane, int x, float y, std::uint32_t id) {
  for (int i = 0; i < lanes; ++i) {
    const Int e0 = e[0] + Int(i) * edges[0].dx, e1 = e[1] + Int(i) * edges[1].dx, e2 = e[2] + Int(i) * edges[2].dx;
    const float z = plane.at(float(x + i), y);
    const bool wins = ((e0 | e1 | e2) >= 0) & (z < depth[i]);
    depth[i] = wins ? z : depth[i];
    triangle[i] = wins ? id : triangle[i];
  }
}

template <class Int>
void draw_box(const Band& band, const PixelBox& box, const Edge<Int> (&edges)[3], const DepthPlane& plane,
              std::uint32_t id) {
  VisibilityBuffer& buffer = *band.buffer;
  Int row_e[3] = {edges[0].c, edges[1].c, edges[2].c};
  for (int y = box.low_y; y <= box.high_y; ++y) {
    const std::size_t row = buffer.row(buffer.height - 1 - y);
    Int e[3] = {row_e[0], row_e[1], row_e[2]};
    for (int x = box.low_x; x <= box.high_x; x += lanes) {
      draw_lanes(&buffer.depth[row + std::size_t(x)], &buffer.triangle[row + std::size_t(x)], e, edges, plane, x,
                 float(y), id);
      for (int k = 0; k < 3; ++k) e[k] += edges[k].dx * lanes;
    }
    for (int k = 0; k < 3; ++k) row_e[k] += edges[k].dy;
  }
}

template <class Int>
void draw_counter_clockwise(const Band& band, const PixelBox& box, const WindowVertex& v0, const WindowVertex& v1,
                            const WindowVertex& v2, std::uint32_t id) {
  const Edge<Int> edges[3] = {
      {v0, v1, box.low_x, box.low_y}, {v1, v2, box.low_x, box.low_y}, {v2, v0, box.low_x, box.low_y}};
  draw_box(band, box, edges, DepthPlane(v1, v0, v2), id);  // llvmpipe's order: clockwise seen with y up
}

}  // namespace

PixelBox pixel_box(const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2) {
  const auto [x_min, x_max] = std::minmax({v0.snapped_x, v1.snapped_x, v2.snapped_x});
  const auto [y_min, y_max] = std::minmax({v0.snapped_y, v1.snapped_y, v2.snapped_y});
  return {(x_min + subpixels - 1) >> subpixel_bits, (y_min + subpixels - 1) >> subpixel_bits, x_max >> subpixel_bits,
          y_max >> subpixel_bits};
}

void draw_triangle(const Band& band, const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2,
                   std::uint32_t id) {
  PixelBox box = pixel_box(v0, v1, v2);
  box.low_x = std::max(box.low_x, 0);
  box.high_x = std::min(box.high_x, band.buffer->width - 1);
  box.low_y = std::max(box.low_y, band.buffer->height - band.bottom);
  box.high_y = std::min(box.high_y, band.buffer->height - 1 - band.top);
  if (box.empty()) return;
  const std::int64_t area = std::int64_t(v1.snapped_x - v0.snapped_x) * std::int64_t(v2.snapped_y - v0.snapped_y) -
                            std::int64_t(v2.snapped_x - v0.snapped_x) * std::int64_t(v1.snapped_y - v0.snapped_y);
  if (area == 0) return;
  const bool small = box.high_x - box.low_x < 1000 && box.high_y - box.low_y < 1000;
  (void)small;
  if (area > 0)
    draw_counter_clockwise<std::int64_t>(band, box, v0, v1, v2, id);
  else
    draw_counter_clockwise<std::int64_t>(band, box, v1, v0, v2, id);
}

}  // namespace cg
