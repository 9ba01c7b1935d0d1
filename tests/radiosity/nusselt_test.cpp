#include "radiosity/nusselt.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "math/transform.h"
#include "radiosity/closed_form.h"

namespace cg {
namespace {

// The area of the shadow by the polygon of the outline's points.
double shadow(const NusseltProjection& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.outline.size(); ++i) {
    const glm::dvec3 &a = p.outline[i], &b = p.outline[i + 1 < p.outline.size() ? i + 1 : 0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

TEST(Nusselt, TheShadowsAreaIsTheFormFactor) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> one(-1, 1);
  const auto vector = [&] { return glm::dvec3(one(random), one(random), one(random)); };
  int seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const glm::dvec3 point = vector(), normal = unit(vector());
    const std::vector<glm::dvec3> triangle{3.0 * vector(), 3.0 * vector(), 3.0 * vector()};
    const NusseltProjection p = nusselt_projection(point, normal, triangle, 1e-3);
    EXPECT_NEAR(p.form_factor, point_form_factor(point, normal, triangle), 1e-15);
    EXPECT_NEAR(std::accumulate(p.sectors.begin(), p.sectors.end(), 0.0) / pi, p.form_factor, 1e-14);
    EXPECT_NEAR(shadow(p) / pi, p.form_factor, 1e-6);  // an arc's chord cuts off a twelfth of the angle's cube
    for (const glm::dvec3& v : p.outline) {
      EXPECT_NEAR(glm::length(v), 1, 1e-14);
      EXPECT_GE(v.z, -1e-12);
    }
    seen += !p.outline.empty();
  }
  EXPECT_GT(seen, 50);
}

// A square above the point throws a shadow that is symmetric about it, and its corners stand where they are seen.
TEST(Nusselt, SquareAbove) {
  const std::vector<glm::dvec3> square{{-0.5, -0.5, 1}, {-0.5, 0.5, 1}, {0.5, 0.5, 1}, {0.5, -0.5, 1}};
  const NusseltProjection p = nusselt_projection({0, 0, 0}, {0, 0, 1}, square, 0.1);
  EXPECT_NEAR(p.form_factor, 0.239456470461, 1e-12);
  ASSERT_EQ(p.sectors.size(), 4u);
  for (const double s : p.sectors) EXPECT_NEAR(s, pi * p.form_factor / 4, 1e-14);
  for (const glm::dvec3& v : p.outline) {
    const glm::dvec3 world = v.x * p.x + v.y * p.y + v.z * glm::dvec3(0, 0, 1), hit = world / world.z;
    EXPECT_NEAR(std::max(std::abs(hit.x), std::abs(hit.y)), 0.5, 1e-12);  // on the square's outline
  }
}

TEST(Nusselt, NothingAbove) {
  const std::vector<glm::dvec3> below{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
  const NusseltProjection p = nusselt_projection({0, 0, 0}, {0, 0, 1}, below);
  EXPECT_TRUE(p.outline.empty());
  EXPECT_EQ(p.form_factor, 0);
}

}  // namespace
}  // namespace cg
