#include "math/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cg {
namespace {

// x^k integrates to 1/(k + 1) up to the degree 2n - 1, and not beyond.
TEST(GaussLegendre, IntegratesPolynomialsUpToItsDegree) {
  for (int n = 1; n <= most_gauss_points; ++n) {
    const auto integral = [&](int power) {
      double sum = 0;
      for (const GaussPoint& p : gauss_legendre(n)) sum += p.weight * std::pow(p.x, power);
      return sum;
    };
    for (int k = 0; k < 2 * n; ++k) EXPECT_NEAR(integral(k), 1.0 / (k + 1), 2e-15) << n << ' ' << k;
    if (n <= 8) {
      EXPECT_GT(1.0 / (2 * n + 1) - integral(2 * n), 1e-12) << n;
    }
  }
}

TEST(GaussLegendre, PointsAscendAndMirror) {
  for (int n = 1; n <= most_gauss_points; ++n) {
    const auto points = gauss_legendre(n);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_GT(points[i].x, i ? points[i - 1].x : 0);
      EXPECT_NEAR(points[i].x + points[points.size() - 1 - i].x, 1, 1e-15);
    }
    EXPECT_LT(points.back().x, 1);
  }
}

}  // namespace
}  // namespace cg
