// This work is based on: Parry Moon, The Scientific Basis of Illuminating Engineering, 1936 (the contour integral);
// Peter Schroeder and Pat Hanrahan, On the Form Factor between Two Polygons, 1993 (pairs of edges).
#include "radiosity/contour_integral.h"

#include <algorithm>
#include <vector>

#include "math/gauss_legendre.h"
#include "math/transform.h"

namespace cg {

namespace {

// An edge from `begin` along the unit vector `along`.
struct Edge {
  glm::dvec3 begin, along;
  double length;
};

// Its second derivative is ln sqrt(x^2 + d^2). Of four such terms little is left where the polygons are thin: the
// longest type that the processor has keeps some more of it.
long double second_antiderivative(long double x, long double d) {
  const long double r2 = x * x + d * d;
  if (r2 == 0) return 0;
  return (x * x - d * d) * std::log(r2) / 4 - x * x * 3 / 4 + (d > 0 ? d * x * std::atan(x / d) : 0);
}

// Its derivative is ln sqrt(x^2 + d^2).
double antiderivative(double x, double d) {
  const double r2 = x * x + d * d;
  if (r2 == 0) return 0;
  return 0.5 * x * std::log(r2) - x + (d > 0 ? d * std::atan(x / d) : 0);
}

// The integral of ln r over both edges, which are parallel: over s in 0..length and t in low..high of
// ln sqrt((s - t)^2 + d^2).
long double parallel_edges(const Edge& a, const Edge& b) {
  const glm::dvec3 gap = b.begin - a.begin;
  const double d = glm::length(glm::cross(gap, a.along));
  const double begin = glm::dot(gap, a.along), end = begin + b.length * (glm::dot(a.along, b.along) > 0 ? 1 : -1);
  const double low = std::min(begin, end), high = std::max(begin, end);
  const auto term = [&](double x, double y) { return second_antiderivative((long double)(x)-y, d); };
  return (term(a.length, low) - term(0, low)) - (term(a.length, high) - term(0, high));
}

// The integral of ln r over an edge, from a point.
double over_edge(const glm::dvec3& point, const Edge& b) {
  const glm::dvec3 gap = point - b.begin;
  const double along = glm::dot(gap, b.along), d = glm::length(glm::cross(gap, b.along));
  return antiderivative(b.length - along, d) - antiderivative(-along, d);
}

// Ten Gauss points on the part low..high of a.
double gauss(const Edge& a, const Edge& b, double low, double high) {
  double sum = 0;
  for (const GaussPoint& p : gauss_legendre(10))
    sum += p.weight * over_edge(a.begin + (low + p.x * (high - low)) * a.along, b);
  return sum * (high - low);
}

// Halved until the halves agree with the whole: towards a corner that the edges share the integrand has no derivative.
double skew_edges(const Edge& a, const Edge& b, double low, double high, double whole, double tolerance, int depth) {
  const double middle = 0.5 * (low + high);
  const double left = gauss(a, b, low, middle), right = gauss(a, b, middle, high);
  if (std::abs(left + right - whole) <= tolerance || depth == 0) return left + right;
  return skew_edges(a, b, low, middle, left, tolerance, depth - 1) +
         skew_edges(a, b, middle, high, right, tolerance, depth - 1);
}

// The integral of ln r over both edges.
long double edge_pair(const Edge& a, const Edge& b) {
  // From the shorter: over the longer one in closed form nothing is lost, and no noise is taken for a difference.
  if (b.length < a.length) return edge_pair(b, a);
  const bool parallel = glm::length(glm::cross(a.along, b.along)) < 1e-13;
  if (parallel && a.length > 0.01 * b.length) return parallel_edges(a, b);
  return skew_edges(a, b, 0, a.length, gauss(a, b, 0, a.length), 1e-15 * a.length * b.length, 40);
}

std::vector<Edge> edges_of(std::span<const glm::dvec3> polygon, const glm::dvec3& origin, double scale) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p = (polygon[i] - origin) / scale;
    const glm::dvec3 q = (polygon[i + 1 < polygon.size() ? i + 1 : 0] - origin) / scale;
    const auto [length, along] = length_and_unit(q - p);
    if (length > 0) edges.push_back({p, along, length});
  }
  return edges;
}

}  // namespace

double contour_integral(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second) {
  double extent = 0;
  for (const auto polygon : {first, second})
    for (const glm::dvec3& p : polygon) extent = std::max(extent, glm::distance(p, first[0]));
  const double scale = extent > 0 ? std::exp2(std::ceil(std::log2(extent))) : 1;  // a power of two rounds nothing
  long double sum = 0;
  const std::vector<Edge> others = edges_of(second, first[0], scale);
  for (const Edge& a : edges_of(first, first[0], scale))
    for (const Edge& b : others)
      if (const double cosine = glm::dot(a.along, b.along); std::abs(cosine) > 1e-15) sum += cosine * edge_pair(a, b);
  return double(sum) * scale * scale / (2 * pi);
}

}  // namespace cg
