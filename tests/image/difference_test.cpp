// Differences whose figures are known.
#include "image/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/compose.h"
#include "image/ramp.h"

namespace cg {
namespace {

using Mask = Image<std::uint8_t>;

TEST(Difference, EqualPictures) {
  const ColourImage a(8, 4, {0.2f, 0.4f, 2});
  const Difference d = difference(a, a, {}, {}, {});
  EXPECT_EQ(d.covered, 32u);
  EXPECT_EQ(d.coverage_mismatch, 0u);
  EXPECT_EQ(d.max_error, 0);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_EQ(d.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(d.worst_x, -1);
}

TEST(Difference, OnePixel) {
  ColourImage a(10, 10, glm::vec3(0.5f)), b = a;
  a.at(3, 7).g = 0.75f;
  b.at(5, 8).r = 0.5f + 0.5f / 255;  // within a step
  const Difference d = difference(a, b, {}, {}, {});
  EXPECT_EQ(d.max_error, 0.25);
  EXPECT_EQ(d.worst_x, 3);
  EXPECT_EQ(d.worst_y, 7);
  EXPECT_EQ(d.over_1_255, 1u);
  EXPECT_NEAR(d.rmse, std::sqrt((0.0625 + std::pow(0.5 / 255, 2)) / 300), 1e-8);
  EXPECT_NEAR(d.psnr, -20 * std::log10(d.rmse), 1e-12);
  EXPECT_EQ(d.error.at(3, 7), glm::vec3(0, 0.25f, 0));
}

TEST(Difference, OneStepIsNotOverOneStep) {
  for (int i = 0; i < 255; ++i) {
    const ColourImage a(1, 1, glm::vec3(float(i) / 255)), b(1, 1, glm::vec3(float(i + 1) / 255));
    EXPECT_EQ(difference(a, b, {}, {}, {}).over_1_255, 0u) << i;
  }
}

TEST(Difference, OnlyWhereBothCover) {
  const ColourImage a(4, 1, glm::vec3(1)), b(4, 1, glm::vec3(0));
  Mask in_a(4, 1, 1), in_b(4, 1, 1);
  in_a.at(0, 0) = 0;
  in_b.at(1, 0) = 0;
  in_a.at(2, 0) = in_b.at(2, 0) = 0;
  const Difference d = difference(a, b, in_a, in_b, {});
  EXPECT_EQ(d.coverage_mismatch, 2u);
  EXPECT_EQ(d.covered, 1u);
  EXPECT_EQ(d.worst_x, 3);
  EXPECT_EQ(d.psnr, 0);
  EXPECT_EQ(difference(a, b, Mask(4, 1), Mask(4, 1), {}).covered, 0u);
}

TEST(Difference, AfterTheDisplay) {
  const ColourImage a(1, 1, glm::vec3(3)), b(1, 1, glm::vec3(7)), half(1, 1, glm::vec3(0.5f));
  EXPECT_EQ(difference(a, b, {}, {}, {}).max_error, 0);  // both clamp to white
  const Display dark{DisplayTransform::photographic, -3, {}};
  EXPECT_GT(difference(a, b, {}, {}, dark).max_error, 0.2);
  EXPECT_NEAR(difference(ColourImage(1, 1), half, {}, {}, {DisplayTransform::photographic, 0, {}}).max_error,
              1.055 * std::pow(0.5, 1 / 2.4) - 0.055, 1e-6);
}

TEST(Difference, NanIsBlackAndEmptyIsEmpty) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(difference(ColourImage(1, 1, glm::vec3(nan)), ColourImage(1, 1), {}, {}, {}).max_error, 0);
  const Difference none = difference({}, {}, {}, {}, {});
  EXPECT_EQ(none.covered, 0u);
  EXPECT_TRUE(absolute_picture(none, 8).empty());
}

TEST(Difference, Pictures) {
  const ColourImage a(1, 1, {0.5f, 0.25f, 0.5f}), b(1, 1, {0.25f, 0.5f, 0.5f});
  const Difference d = difference(a, b, {}, {}, {});
  EXPECT_EQ(absolute_picture(d, 2).at(0, 0), glm::u8vec4(128, 128, 0, 255));
  EXPECT_EQ(signed_picture(d, 2).at(0, 0), glm::u8vec4(191, 64, 128, 255));
  EXPECT_EQ(false_colour(d, 4).at(0, 0), ramp(1));
  EXPECT_EQ(false_colour(d, 2).at(0, 0), ramp(0.5));
}

TEST(Clamped, IsMarkedAndCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  ColourImage linear(5, 1, glm::vec3(0.5f));
  linear.at(1, 0).g = 1.5f;
  linear.at(2, 0).b = -0.5f;
  linear.at(3, 0).r = 1 + 1e-6f;
  linear.at(4, 0) = {-1, 2, nan};
  Picture shown = picture({}, linear);
  const glm::u8vec4 plain = shown.at(0, 0);
  const Clamped c = mark_clamped(shown, linear, {});
  EXPECT_EQ(c.above, 2u);
  EXPECT_EQ(c.below, 1u);
  EXPECT_EQ(shown.at(0, 0), plain);
  EXPECT_NE(shown.at(1, 0), shown.at(2, 0));
  EXPECT_EQ(shown.at(1, 0), shown.at(4, 0));
  EXPECT_EQ(mark_clamped(shown, linear, {DisplayTransform::photographic, -2, {}}).above, 0u);
}

// Lightness L of OKLab, as a person sees it, or as one without red or green cones does (Viénot, Brettel and Mollon,
// "Digital video colourmaps for checking the legibility of displays by dichromats", 1999).
double lightness(const glm::u8vec4& c, bool dichromat) {
  double r = double(linear_from_srgb(float(c.r) / 255)), g = double(linear_from_srgb(float(c.g) / 255));
  double b = double(linear_from_srgb(float(c.b) / 255));
  if (dichromat) {
    const double yellow = 0.29275 * r + 0.70725 * g, blue = -0.02234 * r + 0.02234 * g + b;
    r = g = yellow;
    b = std::max(blue, 0.0);
  }
  return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
         0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
         0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

TEST(Ramp, LightnessRisesEvenlyForEveryone) {
  for (bool dichromat : {false, true})
    for (int i = 0; i < 32; ++i) {
      const double step = lightness(ramp((i + 1) / 32.0), dichromat) - lightness(ramp(i / 32.0), dichromat);
      EXPECT_GT(step, 0.4 * 0.83 / 32) << i << dichromat;
      EXPECT_LT(step, 2.0 * 0.83 / 32) << i << dichromat;
    }
  EXPECT_EQ(ramp(std::nan("")), ramp(0));
  EXPECT_EQ(ramp(9), ramp(1));
}

TEST(Ramp, LegendIsTheErrorThere) { EXPECT_EQ(ramp_legend(0.5), (std::array{0.0, 0.125, 0.25, 0.375, 0.5})); }

TEST(Compose, WipeAndSideBySide) {
  const glm::u8vec4 red{255, 0, 0, 255}, blue{0, 0, 255, 255};
  const Picture left(10, 2, red), right(10, 2, blue);
  EXPECT_EQ(wipe(left, right, 0), right);
  EXPECT_EQ(wipe(left, right, 1), left);
  const Picture half = wipe(left, right, 0.5);
  EXPECT_EQ(half.at(4, 1), red);
  EXPECT_EQ(half.at(6, 1), blue);
  const Picture both = side_by_side({left, Picture(3, 5, blue)});
  EXPECT_EQ(both.width(), 17);
  EXPECT_EQ(both.height(), 5);
  EXPECT_EQ(both.at(9, 1), red);
  EXPECT_EQ(both.at(14, 4), blue);
  EXPECT_TRUE(side_by_side({}).empty());
}

}  // namespace
}  // namespace cg
