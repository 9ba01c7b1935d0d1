// How much a map from the surface to the plane stretches: by the singular values sigma_1 >= sigma_2 of each triangle's
// Jacobian (Sander, Snyder, Gortler and Hoppe, Texture Mapping Progressive Meshes, 2001).
#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

#include "mapping/chart_mesh.h"

namespace cg {

struct Stretch {
  double sigma_1 = 0, sigma_2 = 0;  // sigma_2 < 0: flipped
  double area = 0;                  // on the surface

  // 1 for a triangle whose angles are kept.
  double quasi_conformal() const;
  double area_scale() const { return sigma_1 * sigma_2; }  // of areas; < 0: flipped
};

Stretch stretch_of(const FlatTriangle& triangle, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// Of many triangles. All are 1 where nothing is distorted.
class DistortionSum {
 public:
  void add(const Stretch& s);
  void add(const DistortionSum& other);

  std::size_t triangles = 0, flipped = 0;  // flipped: or without area in the plane
  double worst_quasi_conformal = 1;
  double surface_area = 0, flat_area = 0;
  double mean_quasi_conformal() const { return surface_area > 0 ? quasi_conformal_ / surface_area : 1; }
  // The root of the mean scale of areas times the mean of its inverse, each weighted by area on the surface: 1 where
  // all parts are enlarged alike.
  double area_distortion() const;

 private:
  double quasi_conformal_ = 0, inverse_ = 0;
};

// Of a chart whose vertices lie at `flat`.
DistortionSum distortion_of(const ChartMesh& chart, std::span<const glm::dvec2> flat);

}  // namespace cg
