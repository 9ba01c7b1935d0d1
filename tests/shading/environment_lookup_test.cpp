// Where directions look, against the tables by hand and the way back.
#include "shading/environment_lookup.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace cg {
namespace {

Vec3<double> random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

TEST(EnvironmentLookupTest, TheAxesAreTheMiddlesOfTheFaces) {
  const Vec3<double> axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int f = 0; f < cube_faces; ++f) {
    const auto place = cube_place(axes[f]);
    EXPECT_EQ(int(place.face), f) << cube_face_signs[std::size_t(f)];
    EXPECT_EQ(place.st, Vec2<double>(0.5, 0.5));
  }
}

// Rows of the specification's table, at a point that is off every middle.
TEST(EnvironmentLookupTest, CornersOfTheTable) {
  const auto st = [](const Vec3<double>& r) { return cube_place(r).st; };
  const auto near = [](Vec2<double> a, double s, double t) { return glm::length(a - Vec2<double>(s, t)) < 1e-15; };
  EXPECT_TRUE(near(st({2, 1, 0.5}), 0.375, 0.25));   // +x: sc -rz, tc -ry
  EXPECT_TRUE(near(st({-2, 1, 0.5}), 0.625, 0.25));  // -x: +rz, -ry
  EXPECT_TRUE(near(st({1, 2, 0.5}), 0.75, 0.625));   // +y: +rx, +rz
  EXPECT_TRUE(near(st({1, -2, 0.5}), 0.75, 0.375));  // -y: +rx, -rz
  EXPECT_TRUE(near(st({1, 0.5, 2}), 0.75, 0.375));   // +z: +rx, -ry
  EXPECT_TRUE(near(st({1, 0.5, -2}), 0.25, 0.375));  // -z: -rx, -ry
}

TEST(EnvironmentLookupTest, WhereTwoComponentsAreAlike) {
  EXPECT_EQ(cube_place<double>({1, 1, 1}).face, CubeFace::near);
  EXPECT_EQ(cube_place<double>({1, 1, 0}).face, CubeFace::top);
  EXPECT_EQ(cube_place<double>({-1, 1, -1}).face, CubeFace::far);
  EXPECT_EQ(cube_place<double>({0, 0, 0}).face, CubeFace::near);
  EXPECT_EQ(cube_place<double>({std::numeric_limits<double>::quiet_NaN(), 1, 0}).st, Vec2<double>(0.5, 0.5));
}

TEST(EnvironmentLookupTest, ThereAndBack) {
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3<double> r = random_direction(random), back = cube_direction(cube_place(r));
    EXPECT_LT(glm::length(unit(back) - unit(r)), 1e-14);
  }
}

TEST(EnvironmentLookupTest, AMirroredBallShowsItsReflections) {
  // The ball's normal n at (s, t) reflects the viewer's ray (0, 0, -1) into r.
  for (double s = 0.05; s < 1; s += 0.1)
    for (double t = 0.05; t < 1; t += 0.1) {
      const double x = 2 * s - 1, y = 2 * t - 1;
      if (x * x + y * y > 0.98) continue;
      const Vec3<double> n(x, y, std::sqrt(1 - x * x - y * y));
      const auto place = sphere_map_place(mirrored(Vec3<double>(0, 0, -1), n));
      EXPECT_NEAR(place.x, s, 1e-14);
      EXPECT_NEAR(place.y, t, 1e-14);
    }
  const auto rim = sphere_map_place<double>({0, 0, -1});
  EXPECT_TRUE(std::isfinite(rim.x) && std::isfinite(rim.y));
}

TEST(EnvironmentLookupTest, LongitudeAndLatitude) {
  const auto at = [](const Vec3<double>& r) { return latitude_longitude_place(r); };
  EXPECT_EQ(at({0, 0, -1}), Vec2<double>(0.5, 0.5));
  EXPECT_NEAR(at({1, 0, 0}).x, 0.75, 1e-15);
  EXPECT_NEAR(at({-1, 0, 0}).x, 0.25, 1e-15);
  EXPECT_NEAR(at({0, 5, 0}).y, 1, 1e-15);
  EXPECT_NEAR(at({1, -1, 0}).y, 0.25, 1e-15);
  EXPECT_EQ(at({0, 0, 0}), Vec2<double>(0.5, 0.5));
}

TEST(EnvironmentLookupTest, FresnelFromTheNormalToTheHorizon) {
  const Vec3<double> glass(0.04);
  EXPECT_NEAR(fresnel_share(glass, 1.0).x, 0.04, 1e-15);
  EXPECT_NEAR(fresnel_share(glass, 0.0).x, 1, 1e-15);
  EXPECT_NEAR(fresnel_share(glass, 0.5).x, 0.04 + 0.96 / 32, 1e-15);
}

}  // namespace
}  // namespace cg
