// The display transforms. sRGB is that of IEC 61966-2-1:1999.
#include "image/display.h"

#include <array>
#include <bit>
#include <cmath>

#include "image/blocks.h"
#include "math/vec.h"

namespace cg {

namespace {

// sRGB by linear interpolation between 256 points in each octave of 2^-13..1: within 1e-6 of the formula, and several
// times faster than pow.
class SrgbCurve {
 public:
  SrgbCurve() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double x = double(std::bit_cast<float>(first_bits + (std::uint32_t(i) << step_bits)));
      points_[i] = float(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
    }
  }

  // 0 <= linear <= 1.
  float operator()(float linear) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(linear);
    if (bits < first_bits) return 12.92f * linear;  // a straight line there
    const std::uint32_t at = bits - first_bits;
    const float* p = points_.data() + (at >> step_bits);
    const float t = float(int(at & ((1u << step_bits) - 1))) * (1.0f / float(1u << step_bits));
    return p[0] + t * (p[1] - p[0]);
  }

 private:
  static constexpr int octaves = 13, step_bits = 23 - 8;
  static constexpr std::uint32_t first_bits = std::uint32_t(127 - octaves) << 23;  // of 2^-13
  std::array<float, octaves * 256 + 2> points_;                                    // at 1, p[1] is read, times 0
};

const SrgbCurve& srgb_curve() {
  static const SrgbCurve curve;
  return curve;
}

float exposure_of(const Display& display) { return float(std::exp2(display.exposure)); }

// x in 0..1. In double the product and the sum are exact, so a tie is a tie.
std::uint8_t rounded(float x) { return std::uint8_t(int(double(x) * 255 + 0.5)); }

// Two short loops instead of one: the first then has no branch.
void display_photographic(float exposure, const float* linear, float* shown, std::size_t n) {
  constexpr std::size_t block = 256;
  float exposed[block];
  const SrgbCurve& curve = srgb_curve();
  for (std::size_t i = 0; i < n; i += block) {
    const std::size_t m = std::min(block, n - i);
    map_values(linear + i, exposed, m, [exposure](float x) { return saturate(x * exposure); });
    map_values(exposed, shown + i, m, [&curve](float x) { return curve(x); });
  }
}

}  // namespace

void display_channels(const Display& display, const float* linear, float* shown, std::size_t n) {
  if (display.transform == DisplayTransform::lecture)
    map_values(linear, shown, n, [](float x) { return saturate(x); });
  else
    display_photographic(exposure_of(display), linear, shown, n);
}

float srgb_from_linear(float linear) { return srgb_curve()(saturate(linear)); }

float linear_from_srgb(float srgb) {
  const double s = double(saturate(srgb));
  return float(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

glm::vec3 displayed(const Display& display, const glm::vec3& linear) {
  glm::vec3 shown;
  display_channels(display, &linear.x, &shown.x, 3);
  return shown;
}

ColourImage displayed(const Display& display, const ColourImage& linear) {
  ColourImage shown(linear.width(), linear.height());
  display_channels(display, channels(linear), channels(shown), 3 * linear.size());
  return shown;
}

std::uint8_t to_8bit(float shown) { return rounded(saturate(shown)); }

void to_8bit_pixels(const float* shown, glm::u8vec4* pixels, std::size_t n) {
  constexpr std::size_t block = 64;
  float clamped[3 * block];
  std::uint8_t bytes[3 * block];
  for (std::size_t i = 0; i < n; i += block) {
    const std::size_t m = std::min(block, n - i);
    map_values(shown + 3 * i, clamped, 3 * m, [](float x) { return saturate(x); });
    map_values(clamped, bytes, 3 * m, rounded);
    for (std::size_t k = 0; k < m; ++k) pixels[i + k] = {bytes[3 * k], bytes[3 * k + 1], bytes[3 * k + 2], 255};
  }
}

Picture picture(const Display& display, const ColourImage& linear) {
  return painted(linear,
                 [&](const float* in, float* shown, std::size_t n) { display_channels(display, in, shown, n); });
}

}  // namespace cg
