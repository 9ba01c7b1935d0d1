// Mipmaps hold the means of what they stand for.
#include "scene/texture_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/display.h"

namespace cg {
namespace {

Image<glm::u8vec4> checker(int width, int height, std::uint8_t low, std::uint8_t high) {
  Image<glm::u8vec4> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t v = (x + y) % 2 == 0 ? low : high;
      out.at(x, y) = {v, v, v, 255};
    }
  return out;
}

TEST(TextureImageTest, LevelsHalveDownToOneTexel) {
  const auto t = TextureImage::make(Image<glm::u8vec4>(33, 17), Encoding::as_stored);
  ASSERT_EQ(t->levels(), 6);  // 1 + floor(log2(33))
  const int widths[] = {33, 16, 8, 4, 2, 1}, heights[] = {17, 8, 4, 2, 1, 1};
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(t->width(k), widths[k]);
    EXPECT_EQ(t->height(k), heights[k]);
  }
  EXPECT_EQ(TextureImage::make(Image<glm::u8vec4>(1, 1), Encoding::as_stored)->levels(), 1);
  EXPECT_EQ(TextureImage::make(Image<glm::u8vec4>(65536, 1), Encoding::as_stored)->levels(), 17);
}

TEST(TextureImageTest, ACheckerOfOneTexelIsGreyInEachLevelAbove) {
  const auto t = TextureImage::make(checker(64, 64, 0, 255), Encoding::as_stored);
  for (int k = 1; k < t->levels(); ++k) EXPECT_NEAR(t->texel(k, 0, 0).r, 0.5, 1e-5) << k;
}

// The mean of black and white as light is 0.5, which sRGB writes as 188 of 255; the mean of the codes would be 127.5.
TEST(TextureImageTest, SRgbIsAveragedAsLight) {
  const auto t = TextureImage::make(checker(64, 64, 0, 255), Encoding::srgb);
  for (int k = 1; k < t->levels(); ++k) {
    EXPECT_NEAR(t->texel(k, 0, 0).r, 0.5, 3e-5) << k;
    const auto& stored = std::get<Image<glm::u16vec4>>(t->texels(k)).at(0, 0);
    EXPECT_NEAR(double(stored.r) / 257, 187.5, 0.1);
    EXPECT_EQ(stored.a, 65535);
  }
  const auto grey = TextureImage::make(Image<glm::u8vec4>(1, 1, {188, 188, 188, 255}), Encoding::srgb);
  EXPECT_NEAR(grey->texel(0, 0, 0).r, 0.5, 0.003);
  EXPECT_EQ(grey->texel(0, 0, 0).a, 1);
}

TEST(TextureImageTest, TheMeanOfAnySizeStaysTheMeanOfTheWhole) {
  for (const auto& [w, h] : {std::pair{3, 5}, {33, 17}, {100, 1}, {1, 7}, {127, 129}}) {
    Image<glm::vec4> texels(w, h);
    glm::dvec4 mean(0);
    for (int i = 0; i < w * h; ++i) {
      glm::vec4& t = texels.pixels()[std::size_t(i)];
      t = {float(i * 7 % 11), float(i % 3), 1.0f, float(i * i % 5)};
      mean += glm::dvec4(t) / double(w * h);
    }
    const auto t = TextureImage::make(texels, Encoding::as_stored);
    const glm::vec4 top = t->texel(t->levels() - 1, 0, 0);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(top[c], mean[c], 1e-5 * mean[c]) << w << "x" << h;
  }
}

TEST(TextureImageTest, SixteenBitsComeBackWhole) {
  Image<glm::u16vec4> texels(256, 256);
  for (int i = 0; i < 65536; ++i) texels.pixels()[std::size_t(i)] = {i, 65535 - i, 0, 65535};
  const auto t = TextureImage::make(texels, Encoding::as_stored);
  for (int i = 0; i < 65536; ++i) ASSERT_NEAR(t->texel(0, i % 256, i / 256).r, double(i) / 65535, 1e-7);
}

TEST(TextureImageTest, WhatIsNotFiniteIsZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const auto t = TextureImage::make(Image<glm::vec4>(2, 2, {nan, inf, -inf, 1}), Encoding::srgb);
  for (int k = 0; k < t->levels(); ++k) EXPECT_EQ(t->texel(k, 0, 0), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(t->encoding(), Encoding::as_stored);  // floats are light
}

TEST(TextureImageTest, ThePyramidTakesLessThanThreeTimesItsPixels) {
  const auto t = TextureImage::make(Image<glm::u8vec4>(1024, 1024), Encoding::as_stored);
  EXPECT_LT(t->bytes(), std::size_t(3) * 1024 * 1024 * 4);
  EXPECT_GT(TextureImage::placeholder()->width(), 1);
}

}  // namespace
}  // namespace cg
