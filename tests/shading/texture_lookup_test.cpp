// What a texture gives at a point against what OpenGL's specification says by hand.
#include "shading/texture_lookup.h"

#include <gtest/gtest.h>

#include <limits>

namespace cg {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

// 0, 1, 2 ... along x, in every row.
TextureHandle ramp(int width, int height = 1) {
  Image<glm::vec4> texels(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) texels.at(x, y) = glm::vec4(float(x), float(y), 0, 1);
  return TextureImage::make(texels, Encoding::as_stored);
}

Sampling with(Wrap wrap, MagFilter mag = MagFilter::nearest, MinFilter min = MinFilter::nearest) {
  Sampling s;
  s.wrap_s = s.wrap_t = wrap;
  s.mag_filter = mag, s.min_filter = min;
  s.border = {7, 7, 7}, s.border_alpha = 0.25;
  return s;
}

template <class Real>
class TextureLookupTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(TextureLookupTest, Reals);

TYPED_TEST(TextureLookupTest, NearestTexelsBeyondTheBorders) {
  using Real = TypeParam;
  const auto t = ramp(10);
  const auto at = [&](Wrap wrap, double u) { return nearest_texel<Real>(*t, with(wrap), 0, {Real(u), Real(0.5)}).x; };
  EXPECT_EQ(at(Wrap::repeat, -0.25), 7);
  EXPECT_EQ(at(Wrap::repeat, 1.0), 0);
  EXPECT_EQ(at(Wrap::repeat, 0.75), 7);
  EXPECT_EQ(at(Wrap::repeat, 123.25), 2);
  EXPECT_EQ(at(Wrap::clamp, -0.3), 0);
  EXPECT_EQ(at(Wrap::clamp, 1.0), 9);
  EXPECT_EQ(at(Wrap::clamp, 1e30), 9);
  EXPECT_EQ(at(Wrap::mirror, -0.25), 2);
  EXPECT_EQ(at(Wrap::mirror, 1.25), 7);
  EXPECT_EQ(at(Wrap::mirror, 2.25), 2);
  EXPECT_EQ(at(Wrap::border, -0.01), 7);
  EXPECT_EQ(at(Wrap::border, 1.0), 7);
  EXPECT_EQ(at(Wrap::border, 0.95), 9);
  EXPECT_EQ(nearest_texel<Real>(*t, with(Wrap::border), 0, {Real(5), Real(0.5)}).w, Real(0.25));
}

TYPED_TEST(TextureLookupTest, EveryNumberHasATexel) {
  using Real = TypeParam;
  const auto t = ramp(7, 3);
  const double numbers[] = {0, -0.0, 1, -1, 1e8, -1e8, 1e20, -1e20, 1e38, -1e38, 1e-40, -1e-40, nan, inf, -inf, 0x1p24};
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border})
    for (const double u : numbers)
      for (const double v : numbers) {
        const Vec2<Real> uv(static_cast<Real>(u), static_cast<Real>(v));
        for (const Vec4<Real>& c :
             {nearest_texel(*t, with(wrap), 0, uv), linear_texels(*t, with(wrap), 0, uv),
              texture_colour<Real>(*t, with(wrap), {uv, Vec2<Real>(Real(u)), Vec2<Real>(Real(v))})}) {
          EXPECT_TRUE(c.x >= 0 && c.x <= 7) << u << " " << v;
          EXPECT_TRUE(c.w >= 0.25 && c.w <= 1);
        }
      }
  // NaN is texel 0.
  EXPECT_EQ(nearest_texel<Real>(*t, with(Wrap::repeat), 0, {Real(nan), Real(nan)}).x, 0);
}

TYPED_TEST(TextureLookupTest, BetweenTexelCentresTheColourIsLinear) {
  using Real = TypeParam;
  const auto t = ramp(10);
  const Sampling s = with(Wrap::clamp);
  for (double u = 0.05; u <= 0.95; u += 0.01)
    EXPECT_NEAR(linear_texels<Real>(*t, s, 0, {Real(u), Real(0.5)}).x, 10 * u - 0.5, 4e-6);
  EXPECT_EQ(linear_texels<Real>(*t, s, 0, {Real(0), Real(0.5)}).x, 0);
  EXPECT_NEAR(linear_texels<Real>(*t, with(Wrap::repeat), 0, {Real(0), Real(0.5)}).x, 4.5, 1e-6);  // of 9 and 0
  EXPECT_NEAR(linear_texels<Real>(*t, with(Wrap::mirror), 0, {Real(1), Real(0.5)}).x, 9, 1e-6);
  EXPECT_NEAR(linear_texels<Real>(*t, with(Wrap::border), 0, {Real(0), Real(0.5)}).x, 3.5, 1e-6);  // of 0 and 7
}

TYPED_TEST(TextureLookupTest, TheLevelIsTheLogarithmOfThePixelsLongerExtent) {
  using Real = TypeParam;
  const auto t = ramp(256, 256);
  const auto level = [&](double ux, double vx, double uy, double vy) {
    return level_of_detail<Real>(*t, {Real(ux / 256), Real(vx / 256)}, {Real(uy / 256), Real(vy / 256)});
  };
  for (const double scale : {0.25, 0.7, 1.0, 1.5, 2.0, 5.0, 300.0})
    EXPECT_NEAR(level(scale, 0, 0, scale), std::log2(scale), 1e-6);
  EXPECT_NEAR(level(4, 0, 0, 1), 2, 1e-6);  // stretched 4 : 1
  const double r = std::sqrt(0.5);
  EXPECT_NEAR(level(2 * r, 2 * r, -2 * r, 2 * r), 1, 1e-6);  // turned by 45 degrees
  EXPECT_EQ(level(0, 0, 0, 0), -inf);
}

// Level k of a wide ramp: texel i stands for 2^k of level 0, so its mean is 2^k i + (2^k - 1)/2.
TYPED_TEST(TextureLookupTest, MinificationReadsTheLevelThatTheFilterNames) {
  using Real = TypeParam;
  const auto t = ramp(64, 64);
  const Vec2<Real> uv(Real(0.0001), Real(0.0001));
  const auto read = [&](MinFilter f, double lambda) {
    return double(texture_at_level<Real>(*t, with(Wrap::clamp, MagFilter::nearest, f), uv, Real(lambda)).x);
  };
  const auto mean = [](int k) { return (std::exp2(k) - 1) / 2; };
  EXPECT_EQ(read(MinFilter::nearest, 3), 0);
  EXPECT_EQ(read(MinFilter::nearest_mipmap_nearest, 1.49), mean(1));
  EXPECT_EQ(read(MinFilter::nearest_mipmap_nearest, 1.5), mean(1));  // ceil(lambda + 1/2) - 1
  EXPECT_EQ(read(MinFilter::nearest_mipmap_nearest, 1.51), mean(2));
  EXPECT_EQ(read(MinFilter::nearest_mipmap_nearest, 99), mean(6));
  EXPECT_NEAR(read(MinFilter::nearest_mipmap_linear, 2.25), 0.75 * mean(2) + 0.25 * mean(3), 1e-5);
  EXPECT_NEAR(read(MinFilter::linear_mipmap_linear, 2.25), 0.75 * mean(2) + 0.25 * mean(3), 1e-5);
  EXPECT_EQ(read(MinFilter::linear_mipmap_linear, 99), mean(6));
}

TYPED_TEST(TextureLookupTest, MagnificationEndsWhereAPixelIsATexelWide) {
  using Real = TypeParam;
  const auto t = ramp(64);
  const Vec2<Real> uv(Real(0.5), Real(0.5));  // linear: between 31 and 32
  const auto read = [&](MagFilter mag, MinFilter min, double lambda) {
    return double(texture_at_level<Real>(*t, with(Wrap::clamp, mag, min), uv, Real(lambda)).x);
  };
  EXPECT_EQ(read(MagFilter::linear, MinFilter::nearest, 0), 31.5);
  EXPECT_EQ(read(MagFilter::linear, MinFilter::nearest, 0.1), 32);
  EXPECT_EQ(read(MagFilter::nearest, MinFilter::linear, 0), 32);
  EXPECT_EQ(read(MagFilter::nearest, MinFilter::linear, 0.1), 31.5);
}

// Many samples along a pixel that is 8 texels long and 1 high keep the level of its height.
TYPED_TEST(TextureLookupTest, AnisotropyKeepsTheShorterExtentsLevel) {
  using Real = TypeParam;
  Image<glm::vec4> rows(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) rows.at(x, y) = glm::vec4(float(y % 2), 0, 0, 1);
  const auto t = TextureImage::make(rows, Encoding::as_stored);
  Sampling s = with(Wrap::repeat, MagFilter::linear, MinFilter::linear_mipmap_linear);
  Footprint<Real> f{{Real(0.3), Real(10.5 / 64)}, {Real(8.0 / 64), Real(0)}, {Real(0), Real(1.0 / 64)}};
  EXPECT_NEAR(texture_colour(*t, s, f).x, 0.5, 1e-5);  // level 3: the rows are gone
  s.anisotropy = 8;
  EXPECT_NEAR(texture_colour(*t, s, f).x, 0, 1e-5);  // row 10 is black
}

TEST(TextureLookupTest, FloatFollowsDouble) {
  const auto t = ramp(57, 31);
  const Sampling s = with(Wrap::mirror, MagFilter::linear, MinFilter::linear_mipmap_linear);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double u = std::fmod(i * 0.754877666, 1) * 4 - 2, v = std::fmod(i * 0.569840291, 1) * 4 - 2;
    const double w = std::exp2(i % 9 - 4) / 57;
    const Footprint<double> d{{u, v}, {w, w / 3}, {-w / 2, w}};
    const Footprint<float> f{glm::vec2(d.uv), glm::vec2(d.dx), glm::vec2(d.dy)};
    const glm::dvec4 difference = texture_colour(*t, s, d) - glm::dvec4(texture_colour(*t, s, f));
    worst = std::max(worst, std::abs(difference.x) + std::abs(difference.y));
  }
  EXPECT_LT(worst, 1e-3);  // 57 texels' values of up to 57, uv of up to 2 with 24 bits
}

}  // namespace
}  // namespace cg
