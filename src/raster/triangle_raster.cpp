#include "raster/triangle_raster.h"

#include <cstddef>

#ifdef __FMA__
#include <immintrin.h>
#endif

namespace cg {

namespace {

using Ints = Lanes<std::int32_t>;
using LongInts = Lanes<std::int64_t>;
using Floats = Lanes<float>;

void lower(const Ints& a, Ints& least) { least = a < least ? a : least; }
void raise(const Ints& a, Ints& most) { most = a > most ? a : most; }

// a b, which takes more than 32 bits.
void product(const Ints& a, const Ints& b, LongInts& out) {
  out = __builtin_convertvector(a, LongInts) * __builtin_convertvector(b, LongInts);
}

// One corner of eight triangles.
struct Corners {
  Floats x, y, z;
  Ints snapped_x, snapped_y;

  explicit Corners(const std::array<const WindowVertex*, lanes>& v) {
    Floats w_inverse, snapped_x_bits, snapped_y_bits, outside;
    columns(v, offsetof(WindowVertex, x), x, y, z, w_inverse);
    columns(v, offsetof(WindowVertex, w_inverse), w_inverse, snapped_x_bits, snapped_y_bits, outside);
    snapped_x = Ints(snapped_x_bits), snapped_y = Ints(snapped_y_bits);
  }

 private:
  // The four numbers that stand side by side in each vertex, `offset` bytes from its beginning: rows of a matrix, whose
  // columns are wanted. To pick each number from memory would take several times as long.
  static void columns(const std::array<const WindowVertex*, lanes>& v, std::size_t offset, Floats& c0, Floats& c1,
                      Floats& c2, Floats& c3) {
    static_assert(offsetof(WindowVertex, w_inverse) == 12 && offsetof(WindowVertex, outside) == 24);
    Floats rows[4];  // vertices 0..3 in the lower half, 4..7 in the upper
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<float, lanes> both;
      std::memcpy(&both[0], reinterpret_cast<const char*>(v[i]) + offset, 16);
      std::memcpy(&both[4], reinterpret_cast<const char*>(v[i + 4]) + offset, 16);
      std::memcpy(&rows[i], &both, sizeof both);
    }
    const Floats low01 = __builtin_shufflevector(rows[0], rows[1], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats high01 = __builtin_shufflevector(rows[0], rows[1], 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats low23 = __builtin_shufflevector(rows[2], rows[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats high23 = __builtin_shufflevector(rows[2], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
    c0 = __builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13);
    c1 = __builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15);
    c2 = __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13);
    c3 = __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15);
  }
};

void swap_where(const Ints& mask, Corners& a, Corners& b) {
  const Corners was = a;
  a.x = mask ? b.x : a.x, a.y = mask ? b.y : a.y, a.z = mask ? b.z : a.z;
  a.snapped_x = mask ? b.snapped_x : a.snapped_x, a.snapped_y = mask ? b.snapped_y : a.snapped_y;
  b.x = mask ? was.x : b.x, b.y = mask ? was.y : b.y, b.z = mask ? was.z : b.z;
  b.snapped_x = mask ? was.snapped_x : b.snapped_x, b.snapped_y = mask ? was.snapped_y : b.snapped_y;
}

// Their pixel boxes, as pixel_box() finds one, within the band and widened to whole groups of pixels: the edges leave
// out what lies beside the triangle.
struct Boxes {
  Ints low_x, low_y, high_x, high_y;
  Ints small;  // -1 where an edge's values fit into 32 bits

  Boxes(const Corners& a, const Corners& b, const Corners& c, const Band& band) {
    low_x = high_x = a.snapped_x, low_y = high_y = a.snapped_y;
    lower(b.snapped_x, low_x), lower(c.snapped_x, low_x), raise(b.snapped_x, high_x), raise(c.snapped_x, high_x);
    lower(b.snapped_y, low_y), lower(c.snapped_y, low_y), raise(b.snapped_y, high_y), raise(c.snapped_y, high_y);
    low_x = (low_x + (subpixels - 1)) >> subpixel_bits, high_x >>= subpixel_bits;
    low_y = (low_y + (subpixels - 1)) >> subpixel_bits, high_y >>= subpixel_bits;
    // Within 1000 pixels they stay below 2 * 1000 * 1000 * subpixels < 2^31.
    small = (high_x - low_x < 1000) & (high_y - low_y < 1000);
    const int height = band.buffer->height;
    raise(Ints{}, low_x), lower(Ints{} + (band.buffer->width - 1), high_x);
    raise(Ints{} + (height - band.bottom), low_y), lower(Ints{} + (height - 1 - band.top), high_y);
    low_x &= ~(lanes - 1);
  }
};

// The depth of a triangle's plane at pixel (x, y). Its arithmetic is that of Mesa's llvmpipe (lp_state_setup.c,
// lp_bld_interp.c), a float plane through the window's origin, so that where two triangles meet at a grazing angle
// the same one wins.
struct DepthPlane {
  float at_origin, dx, dy;
};
struct DepthPlanes {
  Floats at_origin, dx, dy;

  DepthPlanes(const Corners& v0, const Corners& v1, const Corners& v2) {
    const Floats x01 = v0.x - v1.x, y01 = v0.y - v1.y, z01 = v0.z - v1.z;
    const Floats x20 = v2.x - v0.x, y20 = v2.y - v0.y, z20 = v2.z - v0.z;
    const Floats area_inverse = 1.0f / (x01 * y20 - y01 * x20);
    dx = z01 * (y20 * area_inverse) - z20 * (y01 * area_inverse);
    dy = z20 * (x01 * area_inverse) - z01 * (x20 * area_inverse);
    at_origin = v0.z - (dx * (v0.x - 0.5f) + dy * (v0.y - 0.5f));
  }
  DepthPlane operator[](int i) const { return {at_origin[i], dx[i], dy[i]}; }
};

// E(x, y) = c + x dx + y dy at pixel centres; inside is E >= 0. Pixel steps are subpixels * (difference of
// coordinates), so E can be divided by `subpixels` and rounded down without changing its sign at any pixel: that
// keeps it small.
template <class Int>
struct Edge {
  Int c, dx, dy;  // c at the pixel box's corner
};
struct Edges {
  LongInts c;
  Ints dx, dy;

  // From a to b, the triangle to its left (in y-up coordinates of a counter-clockwise triangle).
  Edges(const Corners& a, const Corners& b, const Boxes& boxes) {
    const Ints ex = b.snapped_x - a.snapped_x, ey = b.snapped_y - a.snapped_y;
    // OpenGL leaves open to whom a centre that lies exactly on an edge belongs, but it must be one of the two. Ours
    // is the rule of a top-left filler in a picture whose row 0 is the bottom: left edges and bottom edges.
    const Ints exclusive = ~((ey < 0) | ((ey == 0) & (ex > 0)));  // -1 where such a centre is left out
    LongInts along_y, along_x;
    product(ex, boxes.low_y * subpixels - a.snapped_y, along_y);
    product(ey, boxes.low_x * subpixels - a.snapped_x, along_x);
    c = (along_y - along_x + __builtin_convertvector(exclusive, LongInts)) >> subpixel_bits;
    dx = -ey;
    dy = ex;
  }
  template <class Int>
  Edge<Int> edge(int i) const {
    return {Int(c[i]), dx[i], dy[i]};
  }
};

// Twice the signed area, > 0 where the triangle is counter-clockwise with y up.
void area(const Corners& a, const Corners& b, const Corners& c, LongInts& out) {
  LongInts ab_ac, ac_ab;
  product(b.snapped_x - a.snapped_x, c.snapped_y - a.snapped_y, ab_ac);
  product(c.snapped_x - a.snapped_x, b.snapped_y - a.snapped_y, ac_ab);
  out = ab_ac - ac_ab;
}

// The plane's depths at (x, y), multiply_add twice. By reference, as machines without such registers pass them so.
inline void depths(const DepthPlane& plane, const Floats& x, float y, Floats& z) {
#ifdef __FMA__
  const __m256 row = _mm256_fmadd_ps(_mm256_set1_ps(plane.dx), x, _mm256_set1_ps(plane.at_origin));
  z = _mm256_fmadd_ps(_mm256_set1_ps(plane.dy), _mm256_set1_ps(y), row);
#else
  z = (plane.at_origin + plane.dx * x) + plane.dy * y;
#endif
}

// Depth test and write in the box, eight pixels at a time.
template <class Int>
void draw_box(VisibilityBuffer& buffer, const PixelBox& box, const Edge<Int> (&edges)[3], const DepthPlane& plane,
              std::uint32_t id) {
  constexpr Lanes<Int> step = lane_numbers<Int>;
  const Lanes<Int> dx0 = step * edges[0].dx, dx1 = step * edges[1].dx, dx2 = step * edges[2].dx;
  const Floats first_x = lane_numbers<float> + float(box.low_x);
  Int c0 = edges[0].c, c1 = edges[1].c, c2 = edges[2].c;
  for (int y = box.low_y; y <= box.high_y; ++y) {
    Lanes<Int> e0 = dx0 + c0, e1 = dx1 + c1, e2 = dx2 + c2;
    Floats xs = first_x;
    PixelGroup* group = &buffer.group(box.low_x, buffer.height - 1 - y);
    for (int x = box.low_x; x <= box.high_x; x += lanes, group += VisibilityBuffer::tile_height) {
      PixelGroup& pixels = *group;
      const Ints inside = __builtin_convertvector((e0 | e1 | e2) >= 0, Ints);
      Floats z;
      depths(plane, xs, float(y), z);
      const Ints wins = inside & (z < pixels.depth);
      pixels.depth = wins ? z : pixels.depth;
      pixels.triangle = wins ? Lanes<std::uint32_t>{} + id : pixels.triangle;
      e0 += edges[0].dx * lanes, e1 += edges[1].dx * lanes, e2 += edges[2].dx * lanes;
      xs += float(lanes);
    }
    c0 += edges[0].dy, c1 += edges[1].dy, c2 += edges[2].dy;
  }
}

template <class Int>
void draw(VisibilityBuffer& buffer, const Boxes& boxes, const Edges (&edges)[3], const DepthPlanes& planes, int i,
          std::uint32_t id) {
  const PixelBox box{boxes.low_x[i], boxes.low_y[i], boxes.high_x[i], boxes.high_y[i]};
  const Edge<Int> its_edges[3] = {edges[0].edge<Int>(i), edges[1].edge<Int>(i), edges[2].edge<Int>(i)};
  draw_box(buffer, box, its_edges, planes[i], id);
}

}  // namespace

void TriangleQueue::flush() {
  if (count_ == 0) return;
  const LaneBytes added = first_lanes(count_);
  for (auto& corner : vertices_) std::fill(corner.begin() + count_, corner.end(), corner[0]);
  count_ = 0;
  Corners a(vertices_[0]), b(vertices_[1]);
  const Corners c(vertices_[2]);
  const Boxes boxes(a, b, c, band_);
  LongInts doubled_area;
  area(a, b, c, doubled_area);
  const Ints drawn =
      (boxes.low_x <= boxes.high_x) & (boxes.low_y <= boxes.high_y) & __builtin_convertvector(doubled_area != 0, Ints);
  LaneBytes left = lane_bytes(drawn) & added & one_in_each_lane;
  if (left == 0) return;
  swap_where(__builtin_convertvector(doubled_area < 0, Ints), a, b);
  const Edges edges[3] = {{a, b, boxes}, {b, c, boxes}, {c, a, boxes}};
  const DepthPlanes planes(b, a, c);  // llvmpipe's order: clockwise seen with y up
  for (; left != 0; left &= left - 1) {
    const int i = first_lane(left);
    (boxes.small[i] ? draw<std::int32_t> : draw<std::int64_t>)(*band_.buffer, boxes, edges, planes, i,
                                                               ids_[std::size_t(i)]);
  }
}

}  // namespace cg
