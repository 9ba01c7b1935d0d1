// The display transforms against their formulas.
#include "image/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cg {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

TEST(Srgb, TheFormula) {
  for (int i = 0; i <= 1000000; ++i) {
    const float x = float(i) / 1e6f;
    ASSERT_NEAR(double(srgb_from_linear(x)), srgb(double(x)), 1e-6) << x;
  }
  EXPECT_EQ(srgb_from_linear(1), 1.0f);
  EXPECT_EQ(srgb_from_linear(nan), 0.0f);
  EXPECT_EQ(srgb_from_linear(inf), 1.0f);
}

TEST(Srgb, ThereAndBack) {
  for (int i = 0; i <= 65535; ++i)
    ASSERT_NEAR(double(srgb_from_linear(linear_from_srgb(float(i) / 65535))) * 65535, i, 0.1);
  EXPECT_EQ(to_8bit(srgb_from_linear(0.5f)), 188);  // middle grey
}

TEST(Displayed, LectureClamps) {
  const Display lecture;
  EXPECT_EQ(displayed(lecture, {0.25f, -0.5f, 1.5f}), glm::vec3(0.25f, 0, 1));
  EXPECT_EQ(displayed(lecture, {nan, inf, -inf}), glm::vec3(0, 1, 0));
}

TEST(Displayed, PhotographicExposesFirst) {
  const Display display{DisplayTransform::photographic, -2, {}};
  const glm::vec3 c = displayed(display, {4, 2, nan});
  EXPECT_EQ(c.r, 1.0f);
  EXPECT_NEAR(double(c.g), srgb(0.5), 1e-6);
  EXPECT_EQ(c.b, 0.0f);
}

TEST(Displayed, OnePixelAndManyAgree) {
  ColourImage image(64, 3);
  for (std::size_t i = 0; i < image.size(); ++i)
    image.pixels()[i] = {float(i) / 150 - 0.1f, 1 / (float(i) + 0.5f), i % 7 ? 0.3f : nan};
  for (const Display& d : {Display{}, Display{DisplayTransform::photographic, 1.5, {}}}) {
    const ColourImage shown = displayed(d, image);
    const Picture bytes = picture(d, image);
    for (std::size_t i = 0; i < image.size(); ++i) {
      const glm::vec3 c = displayed(d, image.pixels()[i]);
      EXPECT_EQ(shown.pixels()[i], c);
      EXPECT_EQ(bytes.pixels()[i], glm::u8vec4(to_8bit(c.r), to_8bit(c.g), to_8bit(c.b), 255));
    }
  }
}

TEST(To8bit, IsTheNearestStep) {
  for (int i = 0; i <= 255; ++i) EXPECT_EQ(to_8bit(float(i) / 255), i);
  for (int i = 0; i < 255; ++i) {
    const float tie = float((i + 0.5) / 255);
    EXPECT_EQ(to_8bit(std::nextafter(tie, 0.0f)), i);
    EXPECT_EQ(to_8bit(std::nextafter(tie, 1.0f)), i + 1);
  }
  EXPECT_EQ(to_8bit(nan), 0);
  EXPECT_EQ(to_8bit(-1), 0);
  EXPECT_EQ(to_8bit(inf), 255);
}

}  // namespace
}  // namespace cg
