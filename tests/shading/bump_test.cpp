// Bumped normals against surfaces that are really displaced.
#include "shading/bump.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace cg {
namespace {

constexpr double pi = std::numbers::pi;
using Vec = Vec3<double>;

// The unit normal of (u, v) -> P, by central differences.
Vec normal_of(const std::function<Vec(double, double)>& P, double u, double v) {
  constexpr double h = 1e-5;
  return unit(glm::cross(P(u + h, v) - P(u - h, v), P(u, v + h) - P(u, v - h)));
}

const TangentFrame<double> plane{{1, 0, 0}, {0, 1, 0}};
const Vec up(0, 0, 1);

// h = a sin kx on a plane: N is along (-a k cos kx, 0, 1), exactly.
TEST(BumpTest, AWaveOnAPlane) {
  const double a = 0.05, k = 8 * pi;
  for (double x = 0; x < 1; x += 0.01) {
    const Vec exact = unit(Vec(-a * k * std::cos(k * x), 0, 1));
    EXPECT_LT(glm::length(bumped_normal(up, plane, {a * k * std::cos(k * x), 0.0}) - exact), 1e-15);
  }
}

TEST(BumpTest, AWaveAlongVAndSkewedCoordinates) {
  // u runs along (2, 0, 0), v along (1, 1, 0): heights by x and y become heights by u and v by the chain rule.
  const TangentFrame<double> skewed{{2, 0, 0}, {1, 1, 0}};
  const double hx = 0.3, hy = -0.4;
  const Vec exact = unit(Vec(-hx, -hy, 1));
  EXPECT_LT(glm::length(bumped_normal(up, skewed, {2 * hx, hx + hy}) - exact), 1e-15);
  // Mirrored uv: the heights still rise along the normal.
  const TangentFrame<double> mirrored{{-1, 0, 0}, {0, 1, 0}};
  EXPECT_LT(glm::length(bumped_normal(up, mirrored, {-hx, hy}) - exact), 1e-15);
}

// On a curved surface what N turns over the height is left out: the error is of order F/R.
TEST(BumpTest, ASphereToFirstOrder) {
  const auto sphere = [](double r, double u, double v) {
    return r * Vec(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
  };
  const double u = 0.7, v = 0.4;
  const TangentFrame<double> frame{Vec(-std::sin(u) * std::cos(v), std::cos(u) * std::cos(v), 0),
                                   Vec(-std::cos(u) * std::sin(v), -std::sin(u) * std::sin(v), std::cos(v))};
  const Vec N = sphere(1, u, v);
  double before = 0;
  for (const double F : {0.02, 0.01, 0.005}) {
    const auto height = [&](double p, double q) { return F * (1 + 0.5 * std::sin(9 * p) * std::cos(7 * q)); };
    const Vec exact = normal_of([&](double p, double q) { return sphere(1 + height(p, q), p, q); }, u, v);
    const Vec2<double> slope{F * 4.5 * std::cos(9 * u) * std::cos(7 * v), -F * 3.5 * std::sin(9 * u) * std::sin(7 * v)};
    const double off = glm::length(bumped_normal(N, frame, slope) - exact);
    EXPECT_LT(off, 10 * F * F);  // F times the slope, itself of order F
    if (before > 0) {
      EXPECT_NEAR(before / off, 4, 0.4);
    }
    before = off;
  }
}

TEST(BumpTest, NoHeightIsNoBumpToTheBit) {
  const Vec N = unit(Vec(0.3, -0.2, 0.9));
  EXPECT_EQ(bumped_normal(N, plane, {0.0, 0.0}), N);
  EXPECT_EQ(mapped_normal(N, plane, {0.5, 0.5, 1}, 1.0), N);
}

TEST(BumpTest, NormalsStayUnitAndAbove) {
  for (const double steep : {1e-8, 1e-3, 1.0, 1e3, 1e8, 1e160}) {
    const Vec n = bumped_normal(up, plane, {steep, -steep});
    EXPECT_NEAR(glm::length(n), 1, 1e-6);
    EXPECT_GE(n.z, 0);
    const glm::vec3 f = bumped_normal<float>({0, 0, 1}, {{1, 0, 0}, {0, 1, 0}}, {float(steep), float(steep)});
    EXPECT_NEAR(glm::length(f), 1, 1e-5);
  }
}

// Central differences over a texel flatten a wave by sin(x)/x, x = k/N: known shortfalls of the slope a k.
TEST(BumpTest, StepsOfATexelFlattenAWave) {
  const double a = 0.05, k = 8 * pi;
  for (const auto& [n, shortfall] : {std::pair{32, 0.1253}, {64, 0.0320}, {128, 0.0081}, {256, 0.0020}}) {
    Image<glm::vec4> heights(n, 1);
    for (int i = 0; i < n; ++i) heights.at(i, 0) = glm::vec4(float(a * std::sin(k * (i + 0.5) / n)));
    const auto t = TextureImage::make(heights, Encoding::as_stored);
    // A crest of the slope: the centre of the texel that lies nearest to kx = 2 pi.
    const double x = (n / 4 + 0.5) / n;
    const double slope = height_gradient<double>(*t, Sampling{}, {x, 0.5}).x / std::cos(k * x);
    EXPECT_NEAR(a * k - slope, shortfall, 2e-4) << n;
  }
}

TEST(BumpTest, ATrianglesFrame) {
  const std::array<Vec, 3> P{Vec(1, 2, 3), Vec(3, 2, 3), Vec(1, 5, 4)};
  const auto frame = tangent_frame<double>(P, {glm::dvec2(0.1, 0.2), glm::dvec2(0.6, 0.2), glm::dvec2(0.1, 1.2)});
  ASSERT_TRUE(frame);
  EXPECT_LT(glm::length(frame->P_u - Vec(4, 0, 0)), 1e-14);
  EXPECT_LT(glm::length(frame->P_v - Vec(0, 3, 1)), 1e-14);
  EXPECT_FALSE(tangent_frame<double>(P, {glm::dvec2(0.5), glm::dvec2(0.5), glm::dvec2(0.5)}));
  EXPECT_FALSE(tangent_frame<double>(P, {glm::dvec2(0), glm::dvec2(1), glm::dvec2(2)}));
  EXPECT_FALSE(tangent_frame<double>(P, {glm::dvec2(NAN), glm::dvec2(1), glm::dvec2(2)}));
}

// A normal picture made from a known slope gives the normal that the height gives.
TEST(BumpTest, ANormalPictureEqualsItsHeights) {
  const Vec n = unit(Vec(-0.3, 0.2, 1));
  const Vec mapped = mapped_normal(up, plane, (n + 1.0) / 2.0, 1.0);
  EXPECT_LT(glm::length(mapped - bumped_normal(up, plane, {0.3, -0.2})), 1e-14);
}

}  // namespace
}  // namespace cg
