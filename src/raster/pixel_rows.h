// The loop over a picture that shades what the visibility buffer found, eight pixels at a time.
#pragma once
#include <atomic>

#include "raster/deferred_shading.h"

namespace cg {

// Of each file that includes it: the compiler knows all calls, and the loops over a picture hold what they call.
namespace {

inline constexpr std::size_t rows_of_pixels_a_part = 8;

// Where eight pixels stand: the first one's x; y counted from the bottom; those that show a triangle.
struct Place {
  int x, y;
  LaneBytes covered;
};

// Brings colours into a float's range; those that are not numbers become 0. Returns how many of the lanes `covered`
// these are. A sliver's weights may carry a colour beyond float's range.
// In the loop over the picture: a call would carry eight pixels through memory and back.
template <class Real>
[[gnu::always_inline]] inline int finish(const LaneVectors<Real>& I, LaneBytes covered, LaneVectors<float>& out) {
  const Lanes<Real> most = Lanes<Real>{} + Real(1e30), least = -most;
  const auto limited = [&](const Lanes<Real>& c, Lanes<float>& to) {
    const Lanes<Real> above = c < least ? least : c;
    to = __builtin_convertvector(above > most ? most : above, Lanes<float>);
  };
  limited(I.x, out.x), limited(I.y, out.y), limited(I.z, out.z);
  const Lanes<float> sum = out.x + out.y + out.z;
  const Lanes<std::int32_t> bad = sum != sum;
  const LaneBytes bad_bytes = lane_bytes(bad) & covered;
  if (bad_bytes == 0) return 0;
  put(bad, LaneVectors<float>{}, out);
  return lane_count(bad_bytes);
}

// Limited as saturate() does it: a sliver's plane may overshoot.
[[gnu::always_inline]] inline void store_depth(const Lanes<float>& depth, int count, float* to) {
  const Lanes<float> zero{}, one = zero + 1.0f, above = depth > zero ? depth : zero;
  const Lanes<float> limited = above < one ? above : one;
  std::memcpy(to, &limited, std::size_t(count) * sizeof *to);
}

// x y z x y z ... in memory, as Image has them.
[[gnu::always_inline]] inline void store(const LaneVectors<float>& v, int count, glm::vec3* to) {
  // clang-format off
  const Lanes<float> xy0 = __builtin_shufflevector(v.x, v.y, 0, 8, 0, 1, 9, 0, 2, 10);
  const Lanes<float> xy1 = __builtin_shufflevector(v.x, v.y, 0, 3, 11, 0, 4, 12, 0, 5);
  const Lanes<float> xy2 = __builtin_shufflevector(v.x, v.y, 13, 0, 6, 14, 0, 7, 15, 0);
  const Lanes<float> pixels[3] = {__builtin_shufflevector(xy0, v.z, 0, 1, 8, 3, 4, 9, 6, 7),
                                  __builtin_shufflevector(xy1, v.z, 10, 1, 2, 11, 4, 5, 12, 7),
                                  __builtin_shufflevector(xy2, v.z, 0, 13, 2, 3, 14, 5, 6, 15)};
  // clang-format on
  if (count < lanes) {
    std::memcpy(to, pixels, std::size_t(count) * sizeof *to);
    return;
  }
  // One by one: to copy all at once, the processor would wait until they have come to memory.
  float* numbers = &to->x;
  for (int i = 0; i < 3; ++i) std::memcpy(numbers + i * lanes, &pixels[i], sizeof pixels[i]);
}

// Writes eight pixels of the picture, from (x, y) on. Returns how many of them were not finite.
template <class Real, class Pixels>
int shade_group(const VisibilityBuffer& visibility, int x, int y, const LaneVectors<float>& background, Pixels& pixels,
                Frame& frame) {
  const PixelGroup& group = visibility.group(x, y);
  const int count = std::min(visibility.width - x, lanes);
  const Lanes<std::int32_t> empty = group.triangle == no_triangle;
  const LaneBytes covered = ~lane_bytes(empty) & first_lanes(count);
  LaneVectors<float> colour = background;
  int bad = 0;
  if (covered != 0) {
    LaneVectors<Real> I{};
    pixels.shade(group.triangle, {x, visibility.height - 1 - y, covered}, I);
    bad = finish(I, covered, colour);
    put(empty, background, colour);
  }
  store(colour, count, frame.colour.row(y) + x);
  store_depth(group.depth, count, frame.depth.row(y) + x);
  const LaneBytes ones = covered & one_in_each_lane;
  std::memcpy(frame.covered.row(y) + x, &ones, std::size_t(count));
  return bad;
}

// The whole picture, with one `Pixels` for each part.
template <class Real, class Pixels>
void shade_rows(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                const glm::vec3& background, Workers& workers, Frame& frame) {
  const Lanes<float> zero{};
  const LaneVectors<float> nothing_there{zero + background.x, zero + background.y, zero + background.z};
  std::atomic<std::size_t> bad{0};
  const std::size_t height = std::size_t(visibility.height);
  workers.for_each(part_count(height, rows_of_pixels_a_part), [&](int i) {
    const Part rows = part_of(height, rows_of_pixels_a_part, i);
    Pixels pixels(drawing, shading);
    int here = 0;
    // Column by column: what lies above and below shows the same triangles.
    for (int x = 0; x < visibility.width; x += lanes)
      for (std::size_t y = rows.begin; y < rows.end; ++y)
        here += shade_group<Real>(visibility, x, int(y), nothing_there, pixels, frame);
    bad += std::size_t(here);
  });
  frame.nan_pixels = bad.load();
}

}  // namespace

}  // namespace cg
