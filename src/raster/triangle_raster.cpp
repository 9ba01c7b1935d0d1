#include "raster/triangle_raster.h"

#ifdef __FMA__
#include <immintrin.h>
#endif

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

// The plane's depths at (x, y), multiply_add twice. By reference, as machines without such registers pass them so.
inline void depths(const DepthPlane& plane, const Lanes<float>& x, float y, Lanes<float>& z) {
#ifdef __FMA__
  const __m256 row = _mm256_fmadd_ps(_mm256_set1_ps(plane.dx), x, _mm256_set1_ps(plane.at_origin));
  z = _mm256_fmadd_ps(_mm256_set1_ps(plane.dy), _mm256_set1_ps(y), row);
#else
  z = (plane.at_origin + plane.dx * x) + plane.dy * y;
#endif
}

// Depth test and write in the box, eight pixels at a time.
template <class Int>
void draw_box(const Band& band, const PixelBox& box, const Edge<Int> (&edges)[3], const DepthPlane& plane,
              std::uint32_t id) {
  constexpr Lanes<Int> step = lane_numbers<Int>;
  const Lanes<Int> dx0 = step * edges[0].dx, dx1 = step * edges[1].dx, dx2 = step * edges[2].dx;
  const Lanes<float> first_x = lane_numbers<float> + float(box.low_x);
  VisibilityBuffer& buffer = *band.buffer;
  Int c0 = edges[0].c, c1 = edges[1].c, c2 = edges[2].c;
  for (int y = box.low_y; y <= box.high_y; ++y) {
    Lanes<Int> e0 = dx0 + c0, e1 = dx1 + c1, e2 = dx2 + c2;
    Lanes<float> xs = first_x;
    PixelGroup* group = &buffer.group(box.low_x, buffer.height - 1 - y);
    for (int x = box.low_x; x <= box.high_x; x += lanes, group += VisibilityBuffer::tile_height) {
      PixelGroup& pixels = *group;
      const Lanes<std::int32_t> inside = __builtin_convertvector((e0 | e1 | e2) >= 0, Lanes<std::int32_t>);
      Lanes<float> z;
      depths(plane, xs, float(y), z);
      const Lanes<std::int32_t> wins = inside & (z < pixels.depth);
      pixels.depth = wins ? z : pixels.depth;
      pixels.triangle = wins ? Lanes<std::uint32_t>{} + id : pixels.triangle;
      e0 += edges[0].dx * lanes, e1 += edges[1].dx * lanes, e2 += edges[2].dx * lanes;
      xs += float(lanes);
    }
    c0 += edges[0].dy, c1 += edges[1].dy, c2 += edges[2].dy;
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
  // Within 1000 pixels an edge's values stay below 2 * 1000 * 1000 * subpixels < 2^31.
  const bool small = box.high_x - box.low_x < 1000 && box.high_y - box.low_y < 1000;
  box.low_x = std::max(box.low_x, 0);
  box.high_x = std::min(box.high_x, band.buffer->width - 1);
  box.low_y = std::max(box.low_y, band.buffer->height - band.bottom);
  box.high_y = std::min(box.high_y, band.buffer->height - 1 - band.top);
  if (box.empty()) return;
  box.low_x -= box.low_x % lanes;  // whole groups; the edges leave out what lies beside the triangle
  const std::int64_t area = std::int64_t(v1.snapped_x - v0.snapped_x) * std::int64_t(v2.snapped_y - v0.snapped_y) -
                            std::int64_t(v2.snapped_x - v0.snapped_x) * std::int64_t(v1.snapped_y - v0.snapped_y);
  if (area == 0) return;
  const WindowVertex &a = area > 0 ? v0 : v1, &b = area > 0 ? v1 : v0;
  if (small)
    draw_counter_clockwise<std::int32_t>(band, box, a, b, v2, id);
  else
    draw_counter_clockwise<std::int64_t>(band, box, a, b, v2, id);
}

}  // namespace cg
