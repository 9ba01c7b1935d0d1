// This work is based on: Gene Golub, John Welsch, Calculation of Gauss Quadrature Rules, 1969 (the recurrence and the
// weights; the zeros are found by halving between those of one degree less, as there are few); Arthur Stroud, Don
// Secrest, Gaussian Quadrature Formulas, 1966 (the conical product on triangles).
#include "radiosity/sample_positions.h"

#include <cmath>

namespace cg {

namespace {

// Monic polynomials orthogonal on 0..1 to the weight x^power: p_{n+1} = (x - a_n) p_n - b_n p_{n-1}. Jacobi's with
// alpha = 0 and beta = power, moved from -1..1.
struct Recurrence {
  double a, b;
};
Recurrence recurrence(int n, int power) {
  const double k = n, beta = power, sum = 2 * k + beta;
  const double a = n == 0 ? beta / (beta + 2) : beta * beta / (sum * (sum + 2));
  double b = 0;
  if (n == 1)
    b = 4 * (1 + beta) / ((2 + beta) * (2 + beta) * (3 + beta));
  else if (n > 1)
    b = 4 * k * k * (k + beta) * (k + beta) / (sum * sum * (sum + 1) * (sum - 1));
  return {(1 + a) / 2, b / 4};
}

double polynomial(int degree, int power, double x) {
  double last = 0, p = 1;
  for (int n = 0; n < degree; ++n) {
    const Recurrence r = recurrence(n, power);
    const double next = (x - r.a) * p - r.b * last;
    last = p, p = next;
  }
  return p;
}

double zero_between(int degree, int power, double low, double high) {
  const bool rising = polynomial(degree, power, high) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((polynomial(degree, power, middle) > 0) == rising ? high : low) = middle;
  }
  return (low + high) / 2;
}

// Christoffel's number: 1 / sum of the squares of the normalised polynomials; the weight function's integral counts 1.
double weight_at(int count, int power, double x) {
  double sum = 0, last = 0, p = 1, square = 1;
  for (int n = 0; n < count; ++n) {
    const Recurrence r = recurrence(n, power);
    if (n > 0) square *= r.b;
    sum += p * p / square;
    const double next = (x - r.a) * p - r.b * last;
    last = p, p = next;
  }
  return 1 / sum;
}

}  // namespace

std::vector<RulePoint> gauss_rule(int count, int power) {
  std::vector<double> zeros;
  for (int degree = 1; degree <= count; ++degree) {
    std::vector<double> borders{0};
    borders.insert(borders.end(), zeros.begin(), zeros.end());
    borders.push_back(1);
    zeros.clear();
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
      zeros.push_back(zero_between(degree, power, borders[i], borders[i + 1]));
  }
  std::vector<RulePoint> rule;
  for (const double x : zeros) rule.push_back({x, weight_at(count, power, x)});
  return rule;
}

namespace {

std::vector<RulePoint> middles(int count) {
  std::vector<RulePoint> rule;
  for (int i = 0; i < count; ++i) rule.push_back({(i + 0.5) / count, 1.0 / count});
  return rule;
}

// Over a quad by its bilinear map: a position counts as much as the map stretches the area there.
std::vector<SamplePosition> on_quad(const Patch& patch, const std::vector<RulePoint>& rule) {
  const auto& c = patch.corner;
  std::vector<SamplePosition> out;
  double sum = 0;
  for (const RulePoint& v : rule)
    for (const RulePoint& u : rule) {
      const glm::dvec3 lower = c[0] + u.x * (c[1] - c[0]), upper = c[3] + u.x * (c[2] - c[3]);
      const glm::dvec3 along_u = (1 - v.x) * (c[1] - c[0]) + v.x * (c[2] - c[3]);
      const double stretch = glm::dot(glm::cross(along_u, upper - lower), patch.normal) / patch.area;
      const double weight = u.weight * v.weight * (stretch > 0 ? stretch : 0);
      if (!(weight > 0)) continue;
      out.push_back({lower + v.x * (upper - lower), weight});
      sum += weight;
    }
  for (SamplePosition& p : out) p.weight /= sum;
  return out;
}

// The conical product: x from the first corner towards the opposite side, y along that.
std::vector<SamplePosition> gauss_on_triangle(const Patch& patch, int samples) {
  const auto& c = patch.corner;
  std::vector<SamplePosition> out;
  for (const RulePoint& x : gauss_rule(samples, 1))
    for (const RulePoint& y : gauss_rule(samples, 0))
      out.push_back({c[0] + x.x * (c[1] - c[0] + y.x * (c[2] - c[1])), x.weight * y.weight});
  return out;
}

// The centroids of samples^2 congruent triangles.
std::vector<SamplePosition> grid_on_triangle(const Patch& patch, int samples) {
  const glm::dvec3 a = patch.corner[0], u = (patch.corner[1] - a) / double(samples),
                   v = (patch.corner[2] - a) / double(samples);
  std::vector<SamplePosition> out;
  const double weight = 1.0 / (double(samples) * samples);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i + j < samples; ++i) {
      out.push_back({a + (i + 1.0 / 3) * u + (j + 1.0 / 3) * v, weight});
      if (i + j + 1 < samples) out.push_back({a + (i + 2.0 / 3) * u + (j + 2.0 / 3) * v, weight});
    }
  return out;
}

}  // namespace

std::vector<SamplePosition> sample_positions(const Patch& patch, int samples, Placement placement) {
  if (!(patch.area > 0)) return {};
  const bool gauss = placement == Placement::gauss;
  if (patch.corners == 3) return gauss ? gauss_on_triangle(patch, samples) : grid_on_triangle(patch, samples);
  return on_quad(patch, gauss ? gauss_rule(samples, 0) : middles(samples));
}

}  // namespace cg
