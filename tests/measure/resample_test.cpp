#include "measure/resample.h"

#include <gtest/gtest.h>

namespace cg {
namespace {

ColourImage made(int width, int height, float (*at)(int, int)) {
  ColourImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = glm::vec3(at(x, y));
  return image;
}

TEST(ResampleTest, ABoxIsTheMean) {
  const ColourImage image = made(6, 4, [](int x, int y) { return float(x + 10 * y); });
  const ColourImage out = resampled(image, Resampling::box, 2);
  ASSERT_EQ(out.width(), 3);
  ASSERT_EQ(out.height(), 2);
  EXPECT_EQ(out.at(0, 0).r, 5.5f);
  EXPECT_EQ(out.at(2, 1).g, 4.5f + 25);
}

TEST(ResampleTest, NoFilterChangesAnEvenPicture) {
  const ColourImage image = made(12, 12, [](int, int) { return 0.25f; });
  for (const Resampling how : {Resampling::box, Resampling::tent})
    for (const int factor : {1, 2, 3, 4, 6}) {
      const ColourImage out = resampled(image, how, factor);
      for (const glm::vec3& c : out.pixels()) EXPECT_NEAR(double(c.b), 0.25, 1e-7);
    }
}

// A tent keeps a straight slope where it has samples on both sides: it is symmetric.
TEST(ResampleTest, ATentKeepsASlopeInside) {
  const ColourImage image = made(20, 20, [](int x, int) { return (float(x) + 0.5f) / 4; });
  const ColourImage out = resampled(image, Resampling::tent, 4);
  for (int x = 1; x < 4; ++x) EXPECT_NEAR(double(out.at(x, 2).r), x + 0.5, 1e-6);
}

TEST(ResampleTest, ATentOfOneSampleAPixelIsThePicture) {
  const ColourImage image = made(5, 3, [](int x, int y) { return float(x * y); });
  EXPECT_TRUE(resampled(image, Resampling::tent, 1) == image);
}

TEST(ResampleTest, NearestRepeatsPixels) {
  const ColourImage image = made(2, 2, [](int x, int y) { return float(x + 2 * y); });
  const ColourImage out = resampled(image, Resampling::nearest, 3);
  ASSERT_EQ(out.width(), 6);
  EXPECT_EQ(out.at(2, 2).r, 0.0f);
  EXPECT_EQ(out.at(3, 2).r, 1.0f);
  EXPECT_EQ(out.at(5, 5).r, 3.0f);
}

TEST(ResampleTest, APixelIsCoveredWhereASampleIs) {
  Image<std::uint8_t> covered(4, 4);
  covered.at(3, 0) = 1;
  const Image<std::uint8_t> small = resampled_coverage(covered, Resampling::box, 2);
  EXPECT_EQ(small.at(1, 0), 1);
  EXPECT_EQ(small.at(0, 0), 0);
  EXPECT_EQ(resampled_coverage(covered, Resampling::nearest, 2).at(7, 1), 1);
}

}  // namespace
}  // namespace cg
