// One row of F against light: what every solver spends its time in. Factors are floats (or doubles), sums doubles.
#pragma once
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "radiosity/channels.h"
#include "radiosity/form_factors.h"

namespace cg {

// The next eight numbers, in double. (GCC makes five instructions of what is one.) By reference, as everything here:
// how such a vector is returned depends on the machine that is compiled for, and compilers complain of it.
inline void next_lanes(const float* p, Lanes<double>& out) {
#ifdef __AVX512F__
  // Of all lanes, though with a mask: GCC 12 takes what _mm512_cvtps_pd() leaves open for a mistake.
  out = Lanes<double>(_mm512_maskz_cvtps_pd(__mmask8(-1), _mm256_loadu_ps(p)));
#else
  out = Lanes<double>{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]};
#endif
}
inline void next_lanes(const double* p, Lanes<double>& out) { std::memcpy(&out, p, sizeof out); }

// sum += a b, rounded once where the machine can: half the arithmetic.
inline void add_product(const Lanes<double>& a, const Lanes<double>& b, Lanes<double>& sum) {
#ifdef __AVX512F__
  sum = Lanes<double>(_mm512_fmadd_pd(__m512d(a), __m512d(b), __m512d(sum)));
#else
  sum += a * b;
#endif
}

inline double sum_of(const Lanes<double>& v) {
  return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

// sum_j row_j x_j of `Rows` dense rows at once, `stride` numbers apart, so that x is read once for all of them; a row
// has x.padded_size() numbers. One row's sum is the same bits whichever rows it is computed with.
template <std::size_t Rows, class Real>
void dot(const Real* rows, std::size_t stride, const Channels& x, glm::dvec3* out) {
  // So many bytes of each row are fetched ahead, at its end those of the next rows: the machine follows few rows by
  // itself, and each only to the end of a page. (Further ahead, the lines of eight rows drive each other out.)
  constexpr std::size_t ahead = 256 / sizeof(Real);
  const double *r = x.plane(0), *g = x.plane(1), *b = x.plane(2);
  const std::size_t n = x.padded_size();
  Lanes<double> red[Rows] = {}, green[Rows] = {}, blue[Rows] = {};
  for (std::size_t j = 0; j < n; j += lanes) {
    Lanes<double> xr, xg, xb;
    next_lanes(r + j, xr), next_lanes(g + j, xg), next_lanes(b + j, xb);
    const std::size_t fetched = j + ahead < n ? ahead : ahead + (Rows - 1) * stride;
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Rows; ++k) {
      const Real* row = rows + k * stride + j;
      __builtin_prefetch(row + fetched);
      Lanes<double> f;
      next_lanes(row, f);
      add_product(f, xr, red[k]), add_product(f, xg, green[k]), add_product(f, xb, blue[k]);
    }
  }
  for (std::size_t k = 0; k < Rows; ++k) out[k] = {sum_of(red[k]), sum_of(green[k]), sum_of(blue[k])};
}

// Four sums, so that none waits for the one before.
inline glm::dvec3 dot(const std::vector<FormFactor>& row, const Channels& x) {
  constexpr std::size_t at_once = 8, ahead = 128;
  const Quad* quads = x.quads();
  const FormFactor* f = row.data();
  const auto add = [&](std::size_t k, Quad& sum) { sum += double(f[k].value) * quads[f[k].patch]; };
  Quad a{}, b{}, c{}, d{};
  std::size_t k = 0;
  for (; k + at_once <= row.size(); k += at_once) {
    __builtin_prefetch(f + k + ahead);
    add(k, a), add(k + 1, b), add(k + 2, c), add(k + 3, d);
    add(k + 4, a), add(k + 5, b), add(k + 6, c), add(k + 7, d);
  }
  for (; k < row.size(); ++k) add(k, a);
  const Quad sum = (a + b) + (c + d);
  return {sum[0], sum[1], sum[2]};
}

// sum_j row_j x_j of one channel; a dense row and x have n numbers, whole lanes.
inline double dot(const float* row, const double* x, std::size_t n) {
  Lanes<double> sum{}, f, b;
  for (std::size_t j = 0; j < n; j += lanes) {
    next_lanes(row + j, f), next_lanes(x + j, b);
    sum += f * b;
  }
  return sum_of(sum);
}
inline double dot(const std::vector<FormFactor>& row, const double* x) {
  double sum = 0;
  for (const FormFactor& f : row) sum += double(f.value) * x[f.patch];
  return sum;
}

// y_j += row_j x factor_j.
template <class Real>
void add(const Real* row, const glm::dvec3& x, const Channels& factor, Channels& y) {
  for (int c = 0; c < 3; ++c) {
    const double* rho = factor.plane(c);
    double* out = y.plane_alone(c);
    for (std::size_t j = 0; j < y.padded_size(); j += lanes) {
      Lanes<double> sum, f, k;
      next_lanes(out + j, sum), next_lanes(row + j, f), next_lanes(rho + j, k);
      sum += f * x[c] * k;
      std::memcpy(out + j, &sum, sizeof sum);
    }
  }
}

inline void add(const std::vector<FormFactor>& row, const glm::dvec3& x, const Channels& factor, Channels& y) {
  for (int c = 0; c < 3; ++c) {
    const double* rho = factor.plane(c);
    double* out = y.plane_alone(c);
    for (const FormFactor& f : row) out[f.patch] += double(f.value) * x[c] * rho[f.patch];
  }
}

}  // namespace cg
