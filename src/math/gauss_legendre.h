// Points and weights that integrate polynomials exactly.
// This work is based on: Carl Friedrich Gauss, Methodus nova integralium valores per approximationem inveniendi, 1814.
#pragma once
#include <span>

namespace cg {

struct GaussPoint {
  double x, weight;  // 0 < x < 1; the weights sum to 1
};

inline constexpr int most_gauss_points = 32;

// The n points of Gauss and Legendre on 0..1, ascending, 1 <= n <= most_gauss_points: the sum of weight f(x) is the
// integral of f where f is a polynomial of degree below 2n.
std::span<const GaussPoint> gauss_legendre(int n);

}  // namespace cg
