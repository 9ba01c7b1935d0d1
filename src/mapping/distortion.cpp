#include "mapping/distortion.h"

#include <algorithm>
#include <cmath>

namespace cg {

namespace {

constexpr double most = 1e12;  // instead of infinity: what lost its area

}  // namespace

double Stretch::quasi_conformal() const {
  const double small = std::abs(sigma_2);
  return sigma_1 < most * small ? sigma_1 / small : most;
}

Stretch stretch_of(const FlatTriangle& t, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  // The Jacobian's columns: where the triangle's x and y axes go.
  const glm::dvec2 x = (b - a) / t.x1, y = ((c - a) - t.x2 * x) / t.y2;
  // Of (x, y) = rotation and scaling plus reflection and scaling: the singular values are their sizes' sum, difference.
  const double similar = 0.5 * std::hypot(x.x + y.y, x.y - y.x), mirrored = 0.5 * std::hypot(x.x - y.y, x.y + y.x);
  return {similar + mirrored, similar - mirrored, t.area()};
}

void DistortionSum::add(const Stretch& s) {
  ++triangles;
  const double qc = s.quasi_conformal(), scale = s.area_scale();
  flipped += !(scale > 0);
  worst_quasi_conformal = std::max(worst_quasi_conformal, qc);
  surface_area += s.area;
  flat_area += s.area * std::abs(scale);
  quasi_conformal_ += s.area * qc;
  inverse_ += s.area / std::max(std::abs(scale), 1 / most);
}

void DistortionSum::add(const DistortionSum& o) {
  triangles += o.triangles, flipped += o.flipped;
  worst_quasi_conformal = std::max(worst_quasi_conformal, o.worst_quasi_conformal);
  surface_area += o.surface_area, flat_area += o.flat_area;
  quasi_conformal_ += o.quasi_conformal_, inverse_ += o.inverse_;
}

double DistortionSum::area_distortion() const {
  return surface_area > 0 ? std::sqrt(flat_area / surface_area * (inverse_ / surface_area)) : 1;
}

DistortionSum distortion_of(const ChartMesh& chart, std::span<const glm::dvec2> flat) {
  DistortionSum out;
  for (const auto& [a, b, c] : chart.triangle)
    out.add(stretch_of(lay_flat(chart.position[a], chart.position[b], chart.position[c]), flat[a], flat[b], flat[c]));
  return out;
}

}  // namespace cg
