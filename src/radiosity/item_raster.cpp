// ItemScene::draw: sixteen patches are set up at once, then each is drawn tile by tile.
#include <algorithm>
#include <bit>
#include <cstring>

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "radiosity/face_box.h"
#include "radiosity/item_scene.h"
#include "raster/lanes.h"

namespace cg {

namespace {

using Group = ItemScene::Group;
using Rests = ItemScene::Rests;
using Bits = std::uint32_t;

// A position between a patch's edges is found by signs of numbers that are rounded. An edge leaves in what is within
// its rounding, so that no pixel falls between two patches; where both take it, depth decides. Of the sizes that go
// into an edge's number:
constexpr float rounding = 1.0f / (1 << 20);         // 16 units in the last place of what is computed from the eye
constexpr float corner_rounding = 1.0f / (1 << 22);  // and 4 of the corners' coordinates, of size 1,
constexpr float near_by = 1.0f / 16;                 // unless one is as near as this: then they are taken exactly
constexpr float box_margin = 1.0f / 64;              // pixels, for the rounding of projected corners
// Of two faces back to back the front is seen.
constexpr float back_is_farther = 1 - 1.0f / (1 << 18);

void lower(const WideFloats& a, WideFloats& least) { least = a < least ? a : least; }
void raise(const WideFloats& a, WideFloats& most) { most = a > most ? a : most; }

// Bit i where lane i of a comparison holds.
Bits bits_of(const WideInts& mask) {
#ifdef __AVX512DQ__
  return Bits(_mm512_movepi32_mask(__m512i(mask)));
#elif defined(__AVX2__)
  __m256 halves[2];
  std::memcpy(halves, &mask, sizeof halves);
  return Bits(_mm256_movemask_ps(halves[0])) | Bits(_mm256_movemask_ps(halves[1])) << 8;
#else
  Bits bits = 0;
  for (int i = 0; i < wide; ++i) bits |= (Bits(mask[i]) & 1) << i;
  return bits;
#endif
}

// The eye's frame in the scene's scaled coordinates.
struct Eye {
  glm::dvec3 exact;
  glm::vec3 position, rest, axis[3];  // rest: what position, rounded, leaves of exact
};

// Sixteen patches in the frame of the eye.
struct Seen {
  WideFloats x[4], y[4], z[4];                 // corners
  WideFloats edge_x[4], edge_y[4], edge_z[4];  // normals of the planes through the eye and each edge, inwards
  WideFloats slack[4];
  WideFloats near_x, near_y, near_z;  // nearness of direction d is its dot product with this
  Bits front, back;
};

void rotate(const Eye& eye, const WideFloats& x, const WideFloats& y, const WideFloats& z, WideFloats& out_x,
            WideFloats& out_y, WideFloats& out_z) {
  out_x = x * eye.axis[0].x + y * eye.axis[0].y + z * eye.axis[0].z;
  out_y = x * eye.axis[1].x + y * eye.axis[1].y + z * eye.axis[1].z;
  out_z = x * eye.axis[2].x + y * eye.axis[2].y + z * eye.axis[2].z;
}

// The plane n . p = h of each patch, seen from the eye, as nearness n / h; which of its sides the eye sees.
void find_planes(const Eye& eye, const Group& g, Seen& out, WideFloats& side) {
  const Wide<double> h = g.offset - (g.normal_x * eye.exact.x + g.normal_y * eye.exact.y + g.normal_z * eye.exact.z);
  const WideInts front = __builtin_convertvector(h < -ItemScene::edge_on, WideInts);
  const WideInts back = __builtin_convertvector(h > ItemScene::edge_on, WideInts);
  out.front = bits_of(front), out.back = bits_of(back);
  side = front ? WideFloats{} + 1.0f : WideFloats{} - 1.0f;
  const WideFloats farther = front ? WideFloats{} + 1.0f : WideFloats{} + back_is_farther;
  const WideFloats inverse = farther / __builtin_convertvector(h, WideFloats);
  rotate(eye, __builtin_convertvector(g.normal_x, WideFloats) * inverse,
         __builtin_convertvector(g.normal_y, WideFloats) * inverse,
         __builtin_convertvector(g.normal_z, WideFloats) * inverse, out.near_x, out.near_y, out.near_z);
}

// Adds |a|.
void add_size(const WideFloats& a, WideFloats& sum) { sum += WideFloats(WideInts(a) & 0x7fffffff); }
void size_of(const WideFloats& x, const WideFloats& y, const WideFloats& z, WideFloats& size) {
  size = WideFloats{};
  add_size(x, size), add_size(y, size), add_size(z, size);
}

// Corners relative to the eye, to rounding of that distance. What a corner's coordinate left when it was rounded is
// fetched for groups that are near alone.
float find_corners(const Eye& eye, const Group& g, const Rests& rests, Seen& out) {
  WideFloats x[4], y[4], z[4], nearest = WideFloats{} + 4.0f;
  for (int k = 0; k < 4; ++k) {
    x[k] = g.x[k] - eye.position.x, y[k] = g.y[k] - eye.position.y, z[k] = g.z[k] - eye.position.z;
    WideFloats distance;
    size_of(x[k], y[k], z[k], distance);
    lower(distance, nearest);
  }
  const bool near = bits_of(nearest < near_by) != 0;
  for (int k = 0; k < 4; ++k) {
    if (near) {
      x[k] += rests.x[k] - eye.rest.x, y[k] += rests.y[k] - eye.rest.y, z[k] += rests.z[k] - eye.rest.z;
    }
    rotate(eye, x[k], y[k], z[k], out.x[k], out.y[k], out.z[k]);
  }
  return near ? 0 : corner_rounding;
}

void see(const Eye& eye, const Group& g, const Rests& rests, Seen& out) {
  const float of_corners = find_corners(eye, g, rests, out);
  WideFloats side;
  find_planes(eye, g, out, side);
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    // Along the edge, clockwise: from the difference of the corners, as for small patches their cross product would
    // leave nothing but its rounding.
    const WideFloats dx = (out.x[next] - out.x[k]) * side, dy = (out.y[next] - out.y[k]) * side,
                     dz = (out.z[next] - out.z[k]) * side;
    const WideFloats &x = out.x[k], &y = out.y[k], &z = out.z[k];
    out.edge_x[k] = dy * z - dz * y;
    out.edge_y[k] = dz * x - dx * z;
    out.edge_z[k] = dx * y - dy * x;
    WideFloats length, distance;
    size_of(dx, dy, dz, length), size_of(x, y, z, distance);
    out.slack[k] = length * (distance * rounding + of_corners) + 1e-30f;
  }
}

// Which of the sixteen can be on which face: those with a corner on its side of each plane between it and the others.
std::array<Bits, 5> faces_met(const Seen& s) {
  WideFloats most[7], least[6];
  for (int k = 0; k < 4; ++k) {
    const WideFloats planes[7] = {s.z[k] - s.x[k], s.z[k] + s.x[k], s.z[k] - s.y[k], s.z[k] + s.y[k],
                                  s.x[k] - s.y[k], s.x[k] + s.y[k], s.z[k]};
    for (int p = 0; p < 7; ++p) {
      if (k == 0) {
        most[p] = planes[p];
        if (p < 6) least[p] = planes[p];
      } else {
        raise(planes[p], most[p]);
        if (p < 6) lower(planes[p], least[p]);
      }
    }
  }
  Bits over[7], under[6];
  for (int p = 0; p < 7; ++p) over[p] = bits_of(most[p] > 0.0f);
  for (int p = 0; p < 6; ++p) under[p] = bits_of(least[p] < 0.0f);
  return {over[0] & over[1] & over[2] & over[3], under[0] & over[4] & over[5] & over[6],
          under[1] & under[4] & under[5] & over[6], under[2] & under[4] & over[5] & over[6],
          under[3] & over[4] & under[5] & over[6]};
}

// Sixteen patches on one face: functions of s and t, c + a s + b t, of the four edges and of nearness; and the tiles.
struct OnFace {
  WideFloats a[5], b[5], c[5];
  WideInts low_x, low_y, high_x, high_y;  // pixels
};

// Where the samples of a column or row of tiles stand.
struct alignas(64) Samples {
  WideFloats at;
};

// One face of the buffer, and where its samples are.
struct Face {
  ItemTile* tiles;
  int across, width, height;
  float scale, low_s, low_t;  // pixels in a unit; where pixel 0 begins
  float beside_s, beside_t;   // of the samples, in pixels,
  float aside_s, aside_t;     // and so much more or less
  // Of each column and row of tiles: s and t of its sixteen samples.
  const Samples *s, *t;
};

// v made whole downwards and limited.
void make_whole(WideFloats& v, int least, int most, WideInts& out) {
  v = v > float(least) ? v : WideFloats{} + float(least);
  v = v < float(most) ? v : WideFloats{} + float(most);
  out = __builtin_convertvector(v + 1.0f, WideInts) - 1;
}

// The pixels whose samples may be inside of boxes on the face.
void set_pixels(const Face& face, WideFloats& low_s, WideFloats& low_t, WideFloats& high_s, WideFloats& high_t,
                OnFace& out) {
  // Sample i stands at i + 1/2, and a little beside.
  constexpr float up = 0.5f - box_margin, down = box_margin - 0.5f;
  low_s = (low_s - face.low_s) * face.scale + (up - face.beside_s - face.aside_s);
  low_t = (low_t - face.low_t) * face.scale + (up - face.beside_t - face.aside_t);
  high_s = (high_s - face.low_s) * face.scale + (down - face.beside_s + face.aside_s);
  high_t = (high_t - face.low_t) * face.scale + (down - face.beside_t + face.aside_t);
  make_whole(low_s, 0, face.width, out.low_x), make_whole(high_s, -1, face.width - 1, out.high_x);
  make_whole(low_t, 0, face.height, out.low_y), make_whole(high_t, -1, face.height - 1, out.high_y);
}

// Of the patches `wanted`, those that have pixels in their boxes.
template <HemicubeFace F>
Bits find_pixels(const Face& face, const Seen& seen, Bits wanted, OnFace& out) {
  WideFloats nearest, low_s, high_s, low_t, high_t;
  for (int k = 0; k < 4; ++k) {
    WideFloats s, t, w;
    project_to_face(F, seen.x[k], seen.y[k], seen.z[k], s, t, w);
    if (k == 0) {
      nearest = w, low_s = high_s = s, low_t = high_t = t;
    } else {
      lower(w, nearest), lower(s, low_s), raise(s, high_s), lower(t, low_t), raise(t, high_t);
    }
  }
  for (Bits behind = bits_of(nearest <= 0.0f) & wanted; behind != 0; behind &= behind - 1) {
    const int i = std::countr_zero(behind);
    std::array<glm::vec3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = {seen.x[k][i], seen.y[k][i], seen.z[k][i]};
    const FaceBox box = face_box(F, corners).value_or(FaceBox{2, 2, -2, -2});
    low_s[i] = box.low_s, low_t[i] = box.low_t, high_s[i] = box.high_s, high_t[i] = box.high_t;
  }
  set_pixels(face, low_s, low_t, high_s, high_t, out);
  return bits_of((out.low_x <= out.high_x) & (out.low_y <= out.high_y)) & wanted;
}

#ifdef __AVX512F__
// Draws patch i of sixteen.
void draw_patch(const Face& face, const OnFace& p, int i, std::uint32_t item) {
  const int first_x = p.low_x[i] / tile_side, last_x = p.high_x[i] / tile_side;
  const int first_y = p.low_y[i] / tile_side, last_y = p.high_y[i] / tile_side;
  const WideFloats a0 = WideFloats{} + p.a[0][i], a1 = WideFloats{} + p.a[1][i], a2 = WideFloats{} + p.a[2][i],
                   a3 = WideFloats{} + p.a[3][i], nearer = WideFloats{} + p.a[4][i];
  for (int y = first_y; y <= last_y; ++y) {
    const WideFloats& t = face.t[y].at;
    const WideFloats c0 = t * p.b[0][i] + p.c[0][i], c1 = t * p.b[1][i] + p.c[1][i], c2 = t * p.b[2][i] + p.c[2][i],
                     c3 = t * p.b[3][i] + p.c[3][i], near = t * p.b[4][i] + p.c[4][i];
    ItemTile* tile = face.tiles + y * face.across + first_x;
    for (int x = first_x; x <= last_x; ++x, ++tile) {
      const WideFloats& s = face.s[x].at;
      const WideInts inside =
          (WideInts(s * a0 + c0) | WideInts(s * a1 + c1) | WideInts(s * a2 + c2) | WideInts(s * a3 + c3)) >= 0;
      const WideFloats nearness = s * nearer + near;
      const WideInts wins = inside & (nearness > tile->nearness);
      tile->nearness = wins ? nearness : tile->nearness;
      tile->item = wins ? WideItems{} + item : tile->item;
    }
  }
}
#else
// Eight of sixteen, for processors that take so many at once: compilers do not divide comparisons well.
template <class T>
void load_half(const Wide<T>& from, int half, Lanes<T>& out) {
  std::memcpy(&out, reinterpret_cast<const char*>(&from) + half * sizeof out, sizeof out);
}
template <class T>
void store_half(const Lanes<T>& from, int half, Wide<T>& out) {
  std::memcpy(reinterpret_cast<char*>(&out) + half * sizeof from, &from, sizeof from);
}

// Draws patch i of sixteen.
void draw_patch(const Face& face, const OnFace& p, int i, std::uint32_t item) {
  using Floats = Lanes<float>;
  using Ints = Lanes<std::int32_t>;
  const int first_x = p.low_x[i] / tile_side, last_x = p.high_x[i] / tile_side;
  const int first_y = p.low_y[i] / tile_side, last_y = p.high_y[i] / tile_side;
  for (int y = first_y; y <= last_y; ++y)
    for (int half = 0; half < 2; ++half) {
      Floats t, c[5];
      load_half<float>(face.t[y].at, half, t);
      for (int k = 0; k < 5; ++k) c[k] = t * p.b[k][i] + p.c[k][i];
      ItemTile* tile = face.tiles + y * face.across + first_x;
      for (int x = first_x; x <= last_x; ++x, ++tile) {
        Floats s, was_near;
        Lanes<std::uint32_t> was;
        load_half<float>(face.s[x].at, half, s), load_half<float>(tile->nearness, half, was_near);
        load_half<std::uint32_t>(tile->item, half, was);
        const Ints inside = (Ints(s * p.a[0][i] + c[0]) | Ints(s * p.a[1][i] + c[1]) | Ints(s * p.a[2][i] + c[2]) |
                             Ints(s * p.a[3][i] + c[3])) >= 0;
        const Floats nearness = s * p.a[4][i] + c[4];
        const Ints wins = inside & (nearness > was_near);
        store_half<float>(wins ? nearness : was_near, half, tile->nearness);
        store_half<std::uint32_t>(wins ? Lanes<std::uint32_t>{} + item : was, half, tile->item);
      }
    }
}
#endif

template <HemicubeFace F>
void draw_group(const Face& face, const Seen& seen, Bits wanted, std::uint32_t first_item) {
  OnFace p;
  wanted = find_pixels<F>(face, seen, wanted, p);
  if (wanted == 0) return;
  for (int k = 0; k < 4; ++k) {
    on_face(F, seen.edge_x[k], seen.edge_y[k], seen.edge_z[k], p.a[k], p.b[k], p.c[k]);
    p.c[k] += seen.slack[k];
  }
  on_face(F, seen.near_x, seen.near_y, seen.near_z, p.a[4], p.b[4], p.c[4]);
  for (; wanted != 0; wanted &= wanted - 1) {
    const int i = std::countr_zero(wanted);
    draw_patch(face, p, i, (first_item + std::uint32_t(i)) | (seen.back >> i & 1 ? from_behind : 0));
  }
}

// Of all columns (or rows) of tiles, from `low` on.
CacheAligned<Samples> samples_of(int tiles, float low, float pixel, float beside, bool rows, bool staggered = false) {
  static_assert(row_stagger.size() == tile_side);
  WideFloats in_tile;
  for (int i = 0; i < wide; ++i) {
    const int column = i % tile_side, row = i / tile_side;
    in_tile[i] = float(rows ? row : column);
    if (staggered) in_tile[i] += float(row_stagger[std::size_t(rows ? column : row)]);
  }
  CacheAligned<Samples> out(static_cast<std::size_t>(tiles));
  for (int i = 0; i < tiles; ++i)
    out[std::size_t(i)].at = low + (in_tile + (float(i * tile_side) + 0.5f + beside)) * pixel;
  return out;
}

struct AllSamples {
  CacheAligned<Samples> along_s, across_s, along_t, across_t;  // from -1 on, or across a side face from 0
  CacheAligned<Samples> side_s, side_t;                        // along the side faces
  AllSamples(int resolution, float beside_s, float beside_t, bool staggered) {
    const int tiles = (resolution + tile_side - 1) / tile_side;
    const float pixel = 2.0f / float(resolution);
    along_s = samples_of(tiles, -1, pixel, beside_s, false), across_s = samples_of(tiles, 0, pixel, beside_s, false);
    along_t = samples_of(tiles, -1, pixel, beside_t, true), across_t = samples_of(tiles, 0, pixel, beside_t, true);
    side_s = samples_of(tiles, -1, pixel, beside_s, false, staggered);
    side_t = samples_of(tiles, -1, pixel, beside_t, true, staggered);
  }
};

Face face_of(HemicubeFace f, int resolution, const HemicubeFrame& frame, const AllSamples& samples,
             HemicubeItems& items) {
  const bool s = crosses_in_s(f), t = crosses_in_t(f);
  const float aside = frame.staggered ? float(row_stagger.back()) : 0;
  return {items.tiles(f),
          FaceTiles(f, resolution).across,
          face_width(f, resolution),
          face_height(f, resolution),
          float(resolution) / 2,
          s ? 0.0f : -1.0f,
          t ? 0.0f : -1.0f,
          float(frame.beside_s),
          float(frame.beside_t),
          t ? aside : 0,
          s ? aside : 0,
          (s   ? samples.across_s
           : t ? samples.side_s
               : samples.along_s)
              .data(),
          (t   ? samples.across_t
           : s ? samples.side_t
               : samples.along_t)
              .data()};
}

}  // namespace

void ItemScene::draw(const HemicubeFrame& frame, const Horizon& horizon, int resolution, HemicubeItems& items,
                     std::vector<std::uint16_t>& fronts) const {
  items.clear(resolution);
  fronts.resize(groups_.size());
  const AllSamples samples(resolution, float(frame.beside_s), float(frame.beside_t), frame.staggered);
  std::array<Face, 5> faces;
  for (const HemicubeFace f : hemicube_faces) faces[std::size_t(f)] = face_of(f, resolution, frame, samples, items);
  const glm::dvec3 at = to_unit_(frame.position);
  const glm::vec3 rounded(at);
  const Eye eye{
      at, rounded, glm::vec3(at - glm::dvec3(rounded)), {glm::vec3(frame.x), glm::vec3(frame.y), glm::vec3(frame.z)}};
  Seen seen;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (horizon.above[g] == 0) continue;
    see(eye, groups_[g], rests_[g], seen);
    fronts[g] = std::uint16_t(fronts[g] | (seen.front & horizon.above[g]));
    const Bits drawn = (seen.front | seen.back) & horizon.above[g];
    if (drawn == 0) continue;
    const std::array<Bits, 5> met = faces_met(seen);
    const auto first = std::uint32_t(g * wide);
    if (met[0] & drawn) draw_group<HemicubeFace::top>(faces[0], seen, met[0] & drawn, first);
    if (met[1] & drawn) draw_group<HemicubeFace::right>(faces[1], seen, met[1] & drawn, first);
    if (met[2] & drawn) draw_group<HemicubeFace::left>(faces[2], seen, met[2] & drawn, first);
    if (met[3] & drawn) draw_group<HemicubeFace::upper>(faces[3], seen, met[3] & drawn, first);
    if (met[4] & drawn) draw_group<HemicubeFace::lower>(faces[4], seen, met[4] & drawn, first);
  }
}

}  // namespace cg
