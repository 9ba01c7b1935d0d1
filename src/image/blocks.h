// Loops over the channels of many pixels, written so that the compiler uses vector instructions at -O2 too.
#pragma once
#include <cstddef>

#include "image/display.h"

namespace cg {

// The channels of all pixels in a row: 3 size() floats.
inline const float* channels(const ColourImage& image) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  return image.empty() ? nullptr : &image.pixels().front().x;
}
inline float* channels(ColourImage& image) { return image.empty() ? nullptr : &image.pixels().front().x; }

// out[i] = f(in[i]) for i < n, in blocks of a fixed length. `f` has no branch.
template <class In, class Out, class F>
void map_values(const In* __restrict in, Out* __restrict out, std::size_t n, F f) {
  constexpr std::size_t block = 32;
  std::size_t i = 0;
  for (; i + block <= n; i += block)
    for (std::size_t k = 0; k < block; ++k) out[i + k] = f(in[i + k]);
  for (; i < n; ++i) out[i] = f(in[i]);
}

// displayed() for n channels.
void display_channels(const Display& display, const float* linear, float* shown, std::size_t n);

// to_8bit() for n pixels of three channels.
void to_8bit_pixels(const float* shown, glm::u8vec4* pixels, std::size_t n);

// The 8-bit picture of an image, a row at a time (fresh memory costs more than the arithmetic):
// show(channels of a row, what is shown 0..1, how many).
template <class Show>
Picture painted(const ColourImage& image, Show show) {
  Picture out(image.width(), image.height());
  const std::size_t n = std::size_t(image.width());
  std::vector<float> shown(3 * n);
  for (int y = 0; y < image.height(); ++y) {
    show(channels(image) + 3 * n * std::size_t(y), shown.data(), 3 * n);
    to_8bit_pixels(shown.data(), out.row(y), n);
  }
  return out;
}

}  // namespace cg
