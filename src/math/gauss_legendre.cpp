#include "math/gauss_legendre.h"

#include <array>
#include <cassert>
#include <cmath>

#include "math/transform.h"

namespace cg {

namespace {

using Rule = std::array<GaussPoint, most_gauss_points>;

// The zeros of Legendre's polynomial P_n by Newton's method, from x = cos(pi (i - 1/4)/(n + 1/2)); the weight of each
// is 2/((1 - x^2) P_n'(x)^2) on -1..1.
Rule make_rule(int n) {
  Rule rule{};
  for (int i = 0; i < n; ++i) {
    double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {
      double p = x, before = 1;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p, p = next;
      }
      slope = n * (before - x * p) / (1 - x * x);
      x -= p / slope;
    }
    rule[std::size_t(n - 1 - i)] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

}  // namespace

std::span<const GaussPoint> gauss_legendre(int n) {
  static const auto rules = [] {
    std::array<Rule, most_gauss_points> all;
    for (int k = 1; k <= most_gauss_points; ++k) all[std::size_t(k - 1)] = make_rule(k);
    return all;
  }();
  assert(n >= 1 && n <= most_gauss_points);
  return {rules[std::size_t(n - 1)].data(), std::size_t(n)};
}

}  // namespace cg
