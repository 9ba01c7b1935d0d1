// x^n for several x at once, in float: loops that a compiler turns into vector instructions.
// This work is based on: Stephen Moshier, Cephes Mathematical Library (logf.c, exp2f.c), 1992: the polynomials.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

namespace cg {

// x^n for 2^-126 <= x <= 2 and 0 <= n <= 128, to 4e-6 of the result (in absolute terms 2e-7 where it is below 1/20);
// results below 2^-126 are 2^-126, and x <= 0, or NaN, gives 2^-126 too (1 where n is 0).
inline float power(float x, float n) {
  const float positive = x > 1.17549435e-38f ? x : 1.17549435e-38f;
  // x = 2^exponent (1 + f) with f in [sqrt(1/2) - 1, sqrt(2) - 1)
  const std::int32_t bits = std::bit_cast<std::int32_t>(positive);
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const float f = std::bit_cast<float>(bits - exponent * (1 << 23)) - 1.0f;
  float p = 7.0376836292e-2f;
  p = p * f - 1.1514610310e-1f;
  p = p * f + 1.1676998740e-1f;
  p = p * f - 1.2420140846e-1f;
  p = p * f + 1.4249322787e-1f;
  p = p * f - 1.6668057665e-1f;
  p = p * f + 2.0000714765e-1f;
  p = p * f - 2.4999993993e-1f;
  p = p * f + 3.3333331174e-1f;
  const float logarithm = f + f * f * (p * f - 0.5f);
  const float y = n * (logarithm * 1.44269504f + float(exponent));
  const float limited = y > -126.0f ? (y < 127.0f ? y : 127.0f) : -126.0f;
  // 2^limited = 2^whole 2^g with g in [-1/2, 1/2]
  const float shifted = limited + 12582912.0f;  // 1.5 * 2^23: rounds to a whole number, kept in the low bits
  const std::int32_t whole = std::bit_cast<std::int32_t>(shifted) - 0x4b400000;
  const float g = limited - (shifted - 12582912.0f);
  float q = 1.535336188319500e-4f;
  q = q * g + 1.339887440266574e-3f;
  q = q * g + 9.618437357674640e-3f;
  q = q * g + 5.550332471162809e-2f;
  q = q * g + 2.402264791363012e-1f;
  q = q * g + 6.931472028550421e-1f;
  q = q * g + 1.0f;
  return q * std::bit_cast<float>((whole + 127) * (1 << 23));
}

// The same in double, by the library.
inline double power(double x, double n) { return x > 0 ? std::pow(x, n) : (n == 0 ? 1.0 : 0.0); }

}  // namespace cg
