// Two pictures compared as the display shows them. PSNR is that of ITU-R J.340 with a peak of 1.
#include "image/difference.h"

#include <algorithm>
#include <cmath>

#include "image/blocks.h"
#include "image/ramp.h"
#include "math/vec.h"

namespace cg {

namespace {

using Mask = Image<std::uint8_t>;

float largest_channel(const glm::vec3& error) {
  return std::max(std::abs(error.r), std::max(std::abs(error.g), std::abs(error.b)));
}

// Adds the row y of `d.error` to the figures; returns the sum of its squares.
double add_row(Difference& d, int y, const std::uint8_t* covered_a, const std::uint8_t* covered_b) {
  constexpr float step = 1.0f / 255 + 1e-6f;
  const glm::vec3* error = d.error.row(y);
  double squares = 0;
  for (int x = 0; x < d.error.width(); ++x) {
    const bool a = !covered_a || covered_a[x], b = !covered_b || covered_b[x];
    d.coverage_mismatch += a != b;
    if (!a || !b) continue;
    const float largest = largest_channel(error[x]);
    ++d.covered;
    squares += double(glm::dot(error[x], error[x]));
    d.over_1_255 += largest > step;
    if (double(largest) > d.max_error) {
      d.max_error = double(largest);
      d.worst_x = x;
      d.worst_y = y;
    }
  }
  return squares;
}

}  // namespace

Difference difference(const ColourImage& a, const ColourImage& b, const Mask& covered_a, const Mask& covered_b,
                      const Display& display) {
  [[maybe_unused]] const auto fits = [&](const auto& image) {
    return image.width() == a.width() && image.height() == a.height();
  };
  assert(fits(b) && (covered_a.empty() || fits(covered_a)) && (covered_b.empty() || fits(covered_b)));
  Difference d;
  d.error = ColourImage(a.width(), a.height());
  const std::size_t n = 3 * std::size_t(a.width());
  std::vector<float> shown_b(n);
  double squares = 0;
  for (int y = 0; y < a.height(); ++y) {
    float* error = channels(d.error) + n * std::size_t(y);
    display_channels(display, channels(a) + n * std::size_t(y), error, n);
    display_channels(display, channels(b) + n * std::size_t(y), shown_b.data(), n);
    for (std::size_t i = 0; i < n; ++i) error[i] -= shown_b[i];
    squares +=
        add_row(d, y, covered_a.empty() ? nullptr : covered_a.row(y), covered_b.empty() ? nullptr : covered_b.row(y));
  }
  if (d.covered) d.rmse = std::sqrt(squares / (3 * double(d.covered)));
  if (d.rmse > 0) d.psnr = -20 * std::log10(d.rmse);
  return d;
}

Picture absolute_picture(const Difference& difference, double gain) {
  return painted(difference.error, [g = float(gain)](const float* error, float* shown, std::size_t n) {
    map_values(error, shown, n, [g](float e) { return std::abs(e) * g; });
  });
}

Picture signed_picture(const Difference& difference, double gain) {
  return painted(difference.error, [g = float(gain) / 2](const float* error, float* shown, std::size_t n) {
    map_values(error, shown, n, [g](float e) { return e * g + 0.5f; });
  });
}

Picture false_colour(const Difference& difference, double gain) {
  const ColourImage& error = difference.error;
  Picture out(error.width(), error.height());
  std::transform(error.pixels().begin(), error.pixels().end(), out.pixels().begin(),
                 [gain](const glm::vec3& e) { return ramp(double(largest_channel(e)) * gain); });
  return out;
}

Clamped mark_clamped(Picture& shown, const ColourImage& linear, const Display& display) {
  assert(shown.width() == linear.width() && shown.height() == linear.height());
  constexpr glm::u8vec4 vermilion{213, 94, 0, 255}, sky_blue{86, 180, 233, 255};
  constexpr float rounding = 1e-5f;
  const bool exposed = display.transform == DisplayTransform::photographic;
  const float exposure = exposed ? float(std::exp2(display.exposure)) : 1.0f;
  Clamped count;
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const glm::vec3 c = linear.pixels()[i] * exposure;
    if (std::max(c.r, std::max(c.g, c.b)) > 1 + rounding) {
      shown.pixels()[i] = vermilion;
      ++count.above;
    } else if (std::min(c.r, std::min(c.g, c.b)) < -rounding) {
      shown.pixels()[i] = sky_blue;
      ++count.below;
    }
  }
  return count;
}

}  // namespace cg
