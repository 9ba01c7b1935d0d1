#include "radiosity/hemicube.h"

#include <algorithm>
#include <cmath>

#include "math/transform.h"

namespace cg {

HemicubeFrame hemicube_frame(const glm::dvec3& position, const glm::dvec3& normal, std::size_t number, int samples) {
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.z <= size.y                   ? glm::dvec3(0, 0, 1)
                                                               : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = unit(axis - glm::dot(axis, normal) * normal), y = glm::cross(normal, x);
  if (samples <= 1) return {position, x, y, normal, 1.0 / 1024, 1.0 / 1536};
  constexpr double golden_slope = 0.55357435889704525;  // atan((sqrt(5) - 1) / 2)
  const double angle = golden_slope + pi / 2 * double(number) / (double(samples) * samples);
  const glm::dvec3 turned = std::cos(angle) * x + std::sin(angle) * y;
  return {position, turned, glm::cross(normal, turned), normal, 0, 0, true};
}

FacePoint<double> sample_point(const HemicubeFrame& frame, HemicubeFace face, int x, int y, int resolution) {
  const double pixel = 2.0 / resolution;
  FacePoint<double> p = pixel_centre(face, x, y, resolution);
  p.s += pixel * frame.beside_s, p.t += pixel * frame.beside_t;
  if (frame.staggered && crosses_in_s(face)) p.t += pixel * row_stagger[std::size_t(x) % row_stagger.size()];
  if (frame.staggered && crosses_in_t(face)) p.s += pixel * row_stagger[std::size_t(y) % row_stagger.size()];
  return p;
}

glm::dvec3 on_cube(HemicubeFace face, const FacePoint<double>& p) {
  switch (face) {
    case HemicubeFace::top:
      return {p.s, p.t, 1};
    case HemicubeFace::right:
      return {1, p.t, 1 - p.s};
    case HemicubeFace::left:
      return {-1, p.t, p.s};
    case HemicubeFace::upper:
      return {p.s, 1, 1 - p.t};
    case HemicubeFace::lower:
      return {p.s, -1, p.t};
  }
  return {};
}

int hemicube_resolution(int wanted) { return std::clamp((wanted + 1) / 2 * 2, 16, 1024); }

double delta_form_factor_top(double x, double y, double area) {
  const double r = x * x + y * y + 1;
  return area / (pi * r * r);
}

double delta_form_factor_side(double y, double z, double area) {
  const double r = y * y + z * z + 1;
  return z * area / (pi * r * r);
}

namespace {

// From the point to the rectangle [0, x] x [0, y] at distance 1, facing it.
double corner_top(double x, double y) {
  const double hx = std::sqrt(1 + x * x), hy = std::sqrt(1 + y * y);
  return (x / hx * std::atan(y / hx) + y / hy * std::atan(x / hy)) / (2 * pi);
}

// To the rectangle [0, y] x [0, z] at distance 1 that stands upright, its lower side at the height of the point.
double corner_side(double y, double z) {
  const double h = std::sqrt(1 + z * z);
  return (std::atan(y) - std::atan(y / h) / h) / (2 * pi);
}

template <class Corner>
double over_rectangle(const Corner& corner, double a0, double a1, double b0, double b1) {
  return (corner(a1, b1) - corner(a0, b1)) - (corner(a1, b0) - corner(a0, b0));
}

}  // namespace

double integrated_form_factor_top(double x0, double x1, double y0, double y1) {
  return over_rectangle(corner_top, x0, x1, y0, y1);
}

double integrated_form_factor_side(double y0, double y1, double z0, double z1) {
  return over_rectangle(corner_side, y0, y1, z0, z1);
}

namespace {

double pixel_weight(PixelWeight weight, HemicubeFace f, int x, int y, int resolution) {
  const double size = 2.0 / resolution, area = size * size;
  const FacePoint<double> centre = pixel_centre(f, x, y, resolution);
  const glm::dvec3 d = on_cube(f, centre);
  const double r2 = glm::dot(d, d);
  switch (weight) {
    case PixelWeight::delta_form_factor:
      if (f == HemicubeFace::top) return delta_form_factor_top(d.x, d.y, area);
      return crosses_in_s(f) ? delta_form_factor_side(d.y, d.z, area) : delta_form_factor_side(d.x, d.z, area);
    case PixelWeight::integrated: {
      const double half = size / 2, s = centre.s, t = centre.t;
      if (f == HemicubeFace::top) return integrated_form_factor_top(s - half, s + half, t - half, t + half);
      const double along = crosses_in_s(f) ? t : s;
      return integrated_form_factor_side(along - half, along + half, d.z - half, d.z + half);
    }
    case PixelWeight::unweighted:
      return 1;
    case PixelWeight::solid_angle:
      return area / (r2 * std::sqrt(r2));
    case PixelWeight::r_squared:
      return d.z * area / (pi * r2);
  }
  return 0;
}

}  // namespace

PixelWeights::PixelWeights(int resolution, PixelWeight weight) : resolution_(resolution) {
  std::array<std::vector<double>, 5> exact;
  for (const HemicubeFace f : hemicube_faces) {
    std::vector<double>& face = exact[std::size_t(f)];
    for (int y = 0; y < face_height(f, resolution); ++y)
      for (int x = 0; x < face_width(f, resolution); ++x) face.push_back(pixel_weight(weight, f, x, y, resolution));
  }
  const auto total = [](const std::vector<double>& face) {
    double sum = 0;
    for (const double w : face) sum += w;
    return sum;
  };
  top_sum_ = total(exact[0]), side_sum_ = total(exact[1]);
  const bool right = weight == PixelWeight::delta_form_factor || weight == PixelWeight::integrated;
  const double scale = right ? 1 : 1 / sum();
  top_sum_ *= scale, side_sum_ *= scale;
  for (std::size_t f = 0; f < exact.size(); ++f) {
    std::vector<float>& face = f == 0 ? top_ : sides_[f - 1];
    for (const double w : exact[f]) face.push_back(float(w * scale));
  }
}

}  // namespace cg
