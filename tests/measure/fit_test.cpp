#include "measure/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "measure/trade.h"

namespace cg {
namespace {

struct Curve {
  std::vector<double> x, error;
};

// error = scale x^order at x = 1, 2, 4, ...
Curve power_law(double order, double scale, int count) {
  Curve c;
  for (int i = 0; i < count; ++i) {
    c.x.push_back(std::exp2(i));
    c.error.push_back(scale * std::pow(c.x.back(), order));
  }
  return c;
}

TEST(FitTest, APowerLawIsFoundExactly) {
  for (const double order : {-2.0, -0.75, -0.5, 0.0, 0.5, 1.0, 2.0}) {
    const Curve c = power_law(order, 3e-4, 7);
    const auto fit = fit_straight_part(c.x, c.error);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, order, 1e-12);
    EXPECT_NEAR(fit->standard_error, 0, 1e-12);
    EXPECT_EQ(fit->points, 7u);
    EXPECT_NEAR(fit->x_low, 1, 1e-12);
    EXPECT_NEAR(fit->x_high, 64, 1e-9);
    EXPECT_FALSE(fit->bend_low);
    EXPECT_FALSE(fit->bend_high);
    EXPECT_NEAR(fit->at(8), 3e-4 * std::pow(8, order), 1e-12 * std::pow(8, order));
  }
}

// Known answer: y = x + noise (+d, -d, -d, +d) at x = 0, 1, 2, 3 decades has slope 1, SSE = 4 d^2, Sxx = 5.
TEST(FitTest, TheStandardErrorIsThatOfLeastSquares) {
  const double d = 0.02;
  const std::vector<double> x{1, 10, 100, 1000};
  std::vector<double> error;
  for (std::size_t i = 0; i < 4; ++i) error.push_back(x[i] * std::pow(10, i == 0 || i == 3 ? d : -d));
  const auto fit = fit_line(x, error);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 1, 1e-12);
  EXPECT_NEAR(fit->standard_error, std::sqrt(4 * d * d / 2 / 5), 1e-12);
}

TEST(FitTest, ANoiseFloorIsABendAtTheAccurateEnd) {
  Curve c = power_law(2, 1e-6, 9);
  for (double& e : c.error) e = std::hypot(e, 2e-5);  // from x = 4 on downwards
  const auto fit = fit_straight_part(c.x, c.error);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 2, 0.05);
  ASSERT_TRUE(fit->bend_low);
  EXPECT_LE(*fit->bend_low, 4);
  EXPECT_FALSE(fit->bend_high);
  EXPECT_EQ(fit->x_high, 256);
}

TEST(FitTest, SaturationIsABendAtTheCoarseEnd) {
  Curve c = power_law(1, 1e-3, 12);
  for (double& e : c.error) e = std::min(e, 0.1);
  const auto fit = fit_straight_part(c.x, c.error);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 1, 0.02);
  ASSERT_TRUE(fit->bend_high);
  EXPECT_NEAR(*fit->bend_high, 256, 129);
  EXPECT_FALSE(fit->bend_low);
}

// A slope that changes and changes back is no straight line, though neither end leaves it and a parabola is no better.
TEST(FitTest, AnSIsNotTakenForALine) {
  Curve c;
  double error = 1;
  for (int i = 0; i < 10; ++i) {
    c.x.push_back(std::exp2(i));
    c.error.push_back(error);
    error *= std::exp2(i < 3 || i > 5 ? -0.8 : -0.2);
  }
  const auto fit = fit_straight_part(c.x, c.error);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->points, c.x.size());
}

TEST(FitTest, WhatHasNoLogarithmIsLeftOut) {
  Curve c = power_law(1, 1, 5);
  c.error[0] = 0;
  c.error[4] = std::nan("");
  const auto fit = fit_straight_part(c.x, c.error);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->points, 3u);
  EXPECT_NEAR(fit->slope, 1, 1e-12);
  EXPECT_FALSE(fit_straight_part(std::vector<double>{1, 2}, std::vector<double>{0, 1}));
  EXPECT_FALSE(fit_line(std::vector<double>{2, 2}, std::vector<double>{1, 3}));  // one x only
  EXPECT_FALSE(fit_line({}, {}));
}

TEST(FitTest, TheOrderOfThePointsDoesNotMatter) {
  const std::vector<double> x{8, 1, 4, 2}, error{64, 1, 16, 4};
  EXPECT_NEAR(fit_straight_part(x, error)->slope, 2, 1e-12);
}

TEST(SpreadTest, MedianLeastAndGreatest) {
  const Spread s = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(s.low, 1);
  EXPECT_EQ(s.median, 3);
  EXPECT_EQ(s.high, 5);
  EXPECT_EQ(spread_of({7}).high, 7);
  EXPECT_EQ(spread_of({1, 2}).median, 1.5);
  EXPECT_EQ(spread_of({}).median, 0);
}

TEST(ParetoTest, NoneOfTheFrontIsBeatenAndAllOthersAre) {
  const std::vector<double> ms{1, 2, 3, 4, 2, 5}, error{9, 4, 5, 1, 4, 1};
  EXPECT_EQ(pareto_front(ms, error), (std::vector<bool>{true, true, false, true, false, false}));
  EXPECT_EQ(pareto_front(std::vector<double>{1, 2}, std::vector<double>{std::nan(""), 1}),
            (std::vector<bool>{false, true}));
  EXPECT_TRUE(pareto_front({}, {}).empty());
}

}  // namespace
}  // namespace cg
