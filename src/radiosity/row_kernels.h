// One row of F against light: what every solver spends its time in. Factors are floats (or doubles), sums doubles.
#pragma once
#include "radiosity/channels.h"
#include "radiosity/form_factors.h"

namespace cg {

// The next eight numbers, in double.
template <class Real>
inline Lanes<double> next_lanes(const Real* p) {
  Lanes<Real> v;
  std::memcpy(&v, p, sizeof v);
  return __builtin_convertvector(v, Lanes<double>);
}

inline double sum_of(const Lanes<double>& v) {
  return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

// sum_j row_j x_j; row has x.padded_size() numbers.
template <class Real>
glm::dvec3 dot(const Real* row, const Channels& x) {
  const double *r = x.plane(0), *g = x.plane(1), *b = x.plane(2);
  const std::size_t n = x.padded_size();
  Lanes<double> red{}, green{}, blue{};
  for (std::size_t j = 0; j < n; j += lanes) {
    const Lanes<double> f = next_lanes(row + j);
    red += f * next_lanes(r + j);
    green += f * next_lanes(g + j);
    blue += f * next_lanes(b + j);
  }
  return {sum_of(red), sum_of(green), sum_of(blue)};
}

// Four entries at a time, so that no sum waits for the one before.
inline glm::dvec3 dot(const std::vector<FormFactor>& row, const Channels& x) {
  const double* planes[3] = {x.plane(0), x.plane(1), x.plane(2)};
  double sums[4][3] = {};
  std::size_t k = 0;
  for (; k + 4 <= row.size(); k += 4)
    for (std::size_t e = 0; e < 4; ++e)
      for (std::size_t c = 0; c < 3; ++c) sums[e][c] += double(row[k + e].value) * planes[c][row[k + e].patch];
  for (; k < row.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) sums[0][c] += double(row[k].value) * planes[c][row[k].patch];
  glm::dvec3 out;
  for (std::size_t c = 0; c < 3; ++c) out[int(c)] = (sums[0][c] + sums[1][c]) + (sums[2][c] + sums[3][c]);
  return out;
}

// y_j += row_j x factor_j.
template <class Real>
void add(const Real* row, const glm::dvec3& x, const Channels& factor, Channels& y) {
  for (int c = 0; c < 3; ++c) {
    const double* rho = factor.plane(c);
    double* out = y.plane(c);
    for (std::size_t j = 0; j < y.padded_size(); j += lanes) {
      const Lanes<double> sum = next_lanes(out + j) + next_lanes(row + j) * x[c] * next_lanes(rho + j);
      std::memcpy(out + j, &sum, sizeof sum);
    }
  }
}

inline void add(const std::vector<FormFactor>& row, const glm::dvec3& x, const Channels& factor, Channels& y) {
  for (int c = 0; c < 3; ++c) {
    const double* rho = factor.plane(c);
    double* out = y.plane(c);
    for (const FormFactor& f : row) out[f.patch] += double(f.value) * x[c] * rho[f.patch];
  }
}

}  // namespace cg
