#include "radiosity/closed_form.h"

#include <algorithm>
#include <array>

#include "math/gauss_legendre.h"
#include "math/transform.h"
#include "radiosity/contour_integral.h"
#include "scene/polygon.h"

namespace cg {

namespace {

using Polygon = std::span<const glm::dvec3>;

glm::dvec3 mean_corner(Polygon polygon) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& p : polygon) sum += p;
  return sum / double(polygon.size());
}

// angle/sine - 1 of an angle of at most 60 degrees, given its sine squared.
double angle_over_sine_less_1(double s2) {
  if (s2 > 0.01) {
    const double s = std::sqrt(std::min(s2, 1.0));
    return std::asin(s) / s - 1;
  }
  // The series of the arc sine.
  return s2 *
         (1.0 / 6 +
          s2 * (3.0 / 40 + s2 * (5.0 / 112 + s2 * (35.0 / 1152 +
                                                   s2 * (63.0 / 2816 + s2 * (231.0 / 13312 + s2 * (143.0 / 10240)))))));
}

// Lambert's sum over the edges, angle times dot(normal, v_i x v_i+1)/|v_i x v_i+1|, the angle by atan2: acos would lose
// half the digits of a small one.
double lambert_sum(const glm::dvec3& point, const glm::dvec3& normal, Polygon polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& p = polygon[i];
    const glm::dvec3& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const glm::dvec3 v = p - point, turn = glm::cross(v, q - p);
    const double size = glm::length(turn);
    if (size > 0) sum += std::atan2(size, glm::dot(v, q - point)) * glm::dot(normal, turn) / size;
  }
  return sum;
}

// The same for a polygon that is small seen from the point, where the edges' terms all but cancel. With v = m + d, m to
// the middle of the polygon and e the edge, a term is dot(normal, v x e) (1 + x)/|m|^2 with a small x; the edges sum to
// 0, and with them the part that has m and not x.
double lambert_sum_of_small(const glm::dvec3& point, const glm::dvec3& normal, Polygon polygon,
                            const glm::dvec3& middle) {
  const glm::dvec3 m = middle - point;
  const double m2 = glm::dot(m, m);
  const auto excess = [&](const glm::dvec3& d) { return (2 * glm::dot(m, d) + glm::dot(d, d)) / m2; };  // |v|^2/m2 - 1
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& p = polygon[i];
    const glm::dvec3& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const glm::dvec3 d = p - middle, e = q - p, turn = glm::cross(m + d, e);
    const double a = excess(d), b = excess(q - middle);
    const double square = (1 + a) * (1 + b), root = std::sqrt(square);  // |v_i| |v_i+1|/m2
    const double angle = angle_over_sine_less_1(glm::dot(turn, turn) / (m2 * m2 * square));
    const double lengths = -(a + b + a * b) / (root * (1 + root));  // 1/root - 1
    const double x = lengths + angle + lengths * angle;
    sum += x * glm::dot(normal, glm::cross(m, e)) + (1 + x) * glm::dot(normal, glm::cross(d, e));
  }
  return sum / m2;
}

double sum_over_edges(const glm::dvec3& point, const glm::dvec3& normal, Polygon polygon) {
  const glm::dvec3 middle = mean_corner(polygon), m = middle - point;
  const double small = 0.25 * glm::dot(m, m);
  for (const glm::dvec3& p : polygon)
    if (const glm::dvec3 d = p - middle; glm::dot(d, d) > small) return lambert_sum(point, normal, polygon);
  return lambert_sum_of_small(point, normal, polygon, middle);
}

// Heights below this share of the distances are rounding: the point lies in the plane.
constexpr double in_plane = 1e-14;

// A polygon with what both ways to integrate over it ask for.
struct Side {
  std::vector<glm::dvec3> corners{};  // the part that the other's front can see
  glm::dvec3 normal{0}, centre{0};
  double radius = 0;

  void measure() {
    centre = mean_corner(corners);
    for (const glm::dvec3& p : corners) radius = std::max(radius, glm::distance(p, centre));
  }
};

// The integral of f over the quadrilateral by n x n Gauss points; a triangle has its last corner twice.
template <class Function>
double integral(const std::array<glm::dvec3, 4>& p, int n, const Function& f) {
  const glm::dvec3 right = p[1] - p[0], up = p[3] - p[0], bend = p[2] - p[3] - right;
  double sum = 0;
  for (const GaussPoint& u : gauss_legendre(n))
    for (const GaussPoint& v : gauss_legendre(n)) {
      const double area = glm::length(glm::cross(right + v.x * bend, up + u.x * bend));
      sum += u.weight * v.weight * area * f(p[0] + u.x * right + v.x * up + u.x * v.x * bend);
    }
  return sum;
}

// Lambert's form integrated over `from`: as many points as the nearest singularity, at `nearness` times the distance
// from the middle that a corner has, demands for 1e-15.
double area_integral(const Side& from, const Side& to, double nearness) {
  const double ellipse = nearness + std::sqrt(nearness * nearness - 1);
  const int n = std::clamp(int(std::ceil(17.5 / std::log(ellipse))), 3, most_gauss_points);
  const auto factor = [&](const glm::dvec3& p) { return point_form_factor(p, from.normal, to.corners); };
  const std::vector<glm::dvec3>& c = from.corners;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < c.size(); i += 2)
    sum += integral({c[0], c[i], c[i + 1], c[std::min(i + 2, c.size() - 1)]}, n, factor);
  return sum;
}

// How far `to` is from the middle of `from` at least, in units of from's radius.
double nearness_of(const Side& from, const Side& to) {
  const double height = glm::dot(to.normal, from.centre - to.corners.front());
  return std::max(height, glm::distance(from.centre, to.centre) - to.radius) / from.radius;
}

}  // namespace

std::vector<glm::dvec3> clipped_to_front(Polygon polygon, const glm::dvec3& origin, const glm::dvec3& normal,
                                         double tolerance) {
  std::vector<glm::dvec3> out;
  const auto height = [&](const glm::dvec3& p) {
    const double h = glm::dot(normal, p - origin);
    return std::abs(h) <= tolerance ? 0.0 : h;
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3& p = polygon[i];
    const glm::dvec3& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double a = height(p), b = height(q);
    if (a >= 0) out.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) out.push_back(p + (a / (a - b)) * (q - p));
  }
  return out;
}

double point_form_factor(const glm::dvec3& point, const glm::dvec3& normal, Polygon polygon) {
  const glm::dvec3 area = vector_area(polygon);
  double lowest = 0, highest = 0, farthest = 0;
  for (const glm::dvec3& p : polygon) {
    const glm::dvec3 v = p - point;
    const double h = glm::dot(normal, v);
    lowest = std::min(lowest, h), highest = std::max(highest, h);
    farthest = std::max(farthest, glm::dot(v, v));
  }
  farthest = std::sqrt(farthest);
  if (!(highest > in_plane * farthest)) return 0;
  if (!(glm::dot(area, point - polygon[0]) > in_plane * glm::length(area) * farthest)) return 0;
  // Seen from its front a polygon turns the other way than v_i x v_i+1 has it.
  if (lowest >= 0) return saturate(-sum_over_edges(point, normal, polygon) / (2 * pi));
  const std::vector<glm::dvec3> above = clipped_to_front(polygon, point, normal);
  return above.size() < 3 ? 0 : saturate(-sum_over_edges(point, normal, above) / (2 * pi));
}

double polygon_form_factor(Polygon from, Polygon to) {
  Side a{.normal = polygon_normal(from)}, b{.normal = polygon_normal(to)};
  if (a.normal == glm::dvec3(0) || b.normal == glm::dvec3(0)) return 0;
  double extent = 0;
  for (const Polygon p : {from, to})
    for (const glm::dvec3& corner : p) extent = std::max(extent, glm::distance(corner, from[0]));
  const auto seen = [&](Polygon p, Polygon by, const glm::dvec3& normal, Side& side) {
    side.corners = clipped_to_front(p, by[0], normal, in_plane * extent);
    const auto above = [&](const glm::dvec3& c) { return glm::dot(normal, c - by[0]) > in_plane * extent; };
    if (std::none_of(side.corners.begin(), side.corners.end(), above)) return false;
    side.measure();
    return true;
  };
  if (!seen(from, to, b.normal, a) || !seen(to, from, a.normal, b)) return 0;
  const double area = glm::length(vector_area(from));
  // From the smaller one, which the other surrounds less: A_1 F_12 = A_2 F_21.
  const Side &small = a.radius <= b.radius ? a : b, &large = a.radius <= b.radius ? b : a;
  const double nearness = nearness_of(small, large);
  const double flux = nearness > 5 ? area_integral(small, large, nearness) : contour_integral(a.corners, b.corners);
  return saturate(flux / area);
}

}  // namespace cg
