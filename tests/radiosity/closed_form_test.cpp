// Closed forms against the textbook's, against each other, and against sums that hold whatever the shape.
#include "radiosity/closed_form.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "math/gauss_legendre.h"
#include "math/transform.h"
#include "scene/polygon.h"

namespace cg {
namespace {

using Polygon = std::vector<glm::dvec3>;

// The rectangle corner, corner + u, corner + u + v, corner + v; its front is where u x v points.
Polygon rectangle(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  return {corner, corner + u, corner + u + v, corner + v};
}

void expect_relative(double found, double expected, double tolerance) {
  EXPECT_NEAR(found / expected, 1, tolerance) << found << " for " << expected;
}

// a x b at z = 0 facing up, and the same at z = c facing down.
double parallel(double a, double b, double c) {
  return polygon_form_factor(rectangle({0, 0, 0}, {a, 0, 0}, {0, b, 0}), rectangle({0, 0, c}, {0, b, 0}, {a, 0, 0}));
}

// Width w of the emitter on the floor and height h of the wall, along a common edge of length 1.
double perpendicular(double h, double w) {
  return polygon_form_factor(rectangle({0, 0, 0}, {w, 0, 0}, {0, 1, 0}), rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, h}));
}

// John Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11 and C-14.
TEST(ClosedForm, ParallelRectangles) {
  const std::vector<std::array<double, 3>> known{{1, 1, 0.199824895698},         {2, 2, 0.415253283577},
                                                 {0.5, 0.5, 0.0685895888186},    {1, 2, 0.285875384851},
                                                 {4, 0.25, 0.103812913916},      {0.1, 0.1, 0.00316205683876},
                                                 {0.01, 0.01, 3.18288667328e-5}, {10, 10, 0.826994522397},
                                                 {100, 100, 0.980416602926},     {1.0 / 3, 2.0 / 3, 0.06033138537}};
  for (const auto& [x, y, f] : known) {
    expect_relative(parallel(x, y, 1), f, 1e-10);
    expect_relative(parallel(1e-3 * y, 1e-3 * x, 1e-3), f, 1e-10);
  }
}

TEST(ClosedForm, PerpendicularRectangles) {
  const std::vector<std::array<double, 3>> known{
      {1, 1, 0.200043776075},     {2, 1, 0.232852602795}, {1, 2, 0.116426301398}, {0.5, 0.5, 0.240636006177},
      {0.1, 0.1, 0.281887806788}, {10, 1, 0.24920948579}, {3, 3, 0.120192860302}, {0.5, 1, 0.146186679106}};
  for (const auto& [h, w, f] : known) expect_relative(perpendicular(h, w), f, 1e-10);
  EXPECT_NEAR(perpendicular(1e6, 1e-6), 0.5, 1e-5);
}

// The textbook's formula, and the integral that it is the solution of: 8 x 8 Gauss points give 13 digits of that up to
// sizes of half the distance, where the formula loses all that it has.
double textbook(double x, double y) {
  const double a = 1 + x * x, b = 1 + y * y;
  return 2 / (pi * x * y) *
         (0.5 * std::log(a * b / (a + y * y)) + x * std::sqrt(b) * std::atan(x / std::sqrt(b)) +
          y * std::sqrt(a) * std::atan(y / std::sqrt(a)) - x * std::atan(x) - y * std::atan(y));
}

double smooth_integral(double x, double y) {
  double sum = 0;
  for (const GaussPoint& u : gauss_legendre(8))
    for (const GaussPoint& v : gauss_legendre(8)) {
      const double s = x * u.x, t = y * v.x, r2 = s * s + t * t + 1;
      sum += u.weight * v.weight * (x - s) * (y - t) / (pi * r2 * r2);
    }
  return 4 * sum;
}

TEST(ClosedForm, KeepsItsDigitsWhereTheTextbookLosesThem) {
  for (const double x : {0.5, 0.3, 0.2, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6}) {
    expect_relative(parallel(x, x, 1), smooth_integral(x, x), 2e-13);
    expect_relative(parallel(x, 0.3 * x, 1), smooth_integral(x, 0.3 * x), 2e-13);
  }
  EXPECT_GT(std::abs(textbook(1e-4, 1e-4) / smooth_integral(1e-4, 1e-4) - 1), 0.1);  // the trap is there
  for (const double x : {0.6, 1.0, 3.0, 30.0}) expect_relative(parallel(x, 2 * x, 1), textbook(x, 2 * x), 1e-12);
}

// Element to rectangle.
TEST(ClosedForm, PointToRectangle) {
  const auto above_corner = [](double a, double b, double c) {
    return point_form_factor({0, 0, 0}, {0, 0, 1}, rectangle({0, 0, c}, {0, b, 0}, {a, 0, 0}));
  };
  expect_relative(above_corner(1, 1, 1), 0.138531605995, 1e-11);
  expect_relative(above_corner(1, 2, 1), 0.167375009914, 1e-11);
  expect_relative(above_corner(0.5, 0.5, 1), 0.0598641176152, 1e-11);
  expect_relative(above_corner(10, 10, 1), 0.247971408295, 1e-11);
  expect_relative(above_corner(1, 1, 0.01), 0.249979543986, 1e-11);
  const auto above_middle = [](double h) {
    return point_form_factor({0, 0, 0}, {0, 0, 1}, rectangle({-0.5, -0.5, h}, {0, 1, 0}, {1, 0, 0}));
  };
  expect_relative(above_middle(0.5), 0.55412642398, 1e-11);
  expect_relative(above_middle(1), 0.239456470461, 1e-11);
  expect_relative(above_middle(2), 0.0734776348125, 1e-11);
  expect_relative(above_middle(5), 0.0125649724937, 1e-11);
  // Upright: b wide, a high, in the distance c.
  const auto upright = [](double a, double b, double c) {
    return point_form_factor({0, 0, 0}, {0, 0, 1}, rectangle({c, 0, 0}, {0, 0, a}, {0, b, 0}));
  };
  expect_relative(upright(1, 1, 1), 0.0557341970026, 1e-11);
  expect_relative(upright(2, 1, 1), 0.0950679411924, 1e-11);
  expect_relative(upright(1, 1, 0.1), 0.22173867087, 1e-11);
}

// A regular polygon of many corners beside the disc: on its axis r^2/(r^2 + h^2), and off it (Howell, B-13).
TEST(ClosedForm, PointToDisc) {
  const auto disc = [](double offset, double r, double h, int corners) {
    Polygon polygon;  // of the disc's area
    const double out = r / std::sqrt(std::sin(2 * pi / corners) * corners / (2 * pi));
    for (int i = 0; i < corners; ++i) {
      const double t = -2 * pi * i / corners;
      polygon.push_back({offset + out * std::cos(t), out * std::sin(t), h});
    }
    return point_form_factor({0, 0, 0}, {0, 0, 1}, polygon);
  };
  EXPECT_NEAR(disc(0, 1, 1, 4000), 0.5, 1e-6);
  EXPECT_NEAR(disc(0.5, 1, 1, 4000), 0.437982632705, 1e-6);
  EXPECT_NEAR(disc(1, 1, 1, 4000), 0.27639320225, 1e-6);
  EXPECT_NEAR(disc(2, 1, 1, 4000), 0.0527864045, 1e-6);
  EXPECT_NEAR(disc(3, 0.5, 2, 4000), 0.00604023680589, 1e-7);
}

// A triangle's share is area cos cos'/(pi r^2) where it is tiny, to all digits: acos has none left at 1e-5.
TEST(ClosedForm, TinyTriangles) {
  for (const double e : {1e-2, 1e-3, 1e-5, 1e-8, 1e-12}) {
    const glm::dvec3 from(0.3, -0.2, 0.1), n = unit(glm::dvec3(0.2, 0.1, 1)), at(0.4, 0.1, 1.1);
    const glm::dvec3 u = unit(glm::dvec3(1, 0.2, 0.3)), v = unit(glm::dvec3(-0.3, 1, 0.2));
    // From differences that double holds exactly.
    const Polygon triangle{from + at, from + at + e * v, from + at + e * u};
    double flux = 0;  // Gauss points over the same triangle as it was rounded
    const glm::dvec3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0], area = glm::cross(a, b);
    for (const GaussPoint& s : gauss_legendre(8))
      for (const GaussPoint& t : gauss_legendre(8)) {
        const glm::dvec3 r = triangle[0] - from + s.x * a + s.x * t.x * (b - a);
        const double r2 = glm::dot(r, r);
        flux += s.weight * t.weight * s.x * glm::dot(n, r) * -glm::dot(area, r) / (pi * r2 * r2);
      }
    expect_relative(point_form_factor(from, n, triangle), flux, 3e-14);
  }
}

// What lies below the horizon, or shows its back, counts nothing.
TEST(ClosedForm, Horizon) {
  const Polygon wall = rectangle({1, -1, -5}, {0, 0, 10}, {0, 2, 0}),
                upper = rectangle({1, -1, 0}, {0, 0, 5}, {0, 2, 0});
  expect_relative(point_form_factor({0, 0, 0}, {0, 0, 1}, wall), point_form_factor({0, 0, 0}, {0, 0, 1}, upper), 1e-14);
  EXPECT_EQ(point_form_factor({2, 0, 0}, {0, 0, 1}, wall), 0);   // its back
  EXPECT_EQ(point_form_factor({1, 0, -1}, {0, 0, 1}, wall), 0);  // in its plane, inside
  EXPECT_EQ(point_form_factor({1, 0, 9}, {-1, 0, 0}, wall), 0);  // in its plane, outside
  EXPECT_EQ(point_form_factor({0, 0, 6}, {0, 0, 1}, wall), 0);   // below the horizon
  // Straight before a wall without end, all of the half that it takes.
  const Polygon endless = rectangle({1, -1e7, -1e7}, {0, 0, 2e7}, {0, 2e7, 0});
  EXPECT_NEAR(point_form_factor({0, 0, 0}, {1, 0, 0}, endless), 1, 1e-12);
  EXPECT_NEAR(point_form_factor({0, 0, 0}, {0, 0, 1}, endless), 0.5, 1e-6);
}

// A closed convex room: each row sums to 1, A_i F_ij = A_j F_ji.
void expect_closed(const std::vector<Polygon>& walls, double tolerance) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < walls.size(); ++j) {
      const double f = i == j ? 0 : polygon_form_factor(walls[i], walls[j]);
      sum += f;
      EXPECT_NEAR(f * glm::length(vector_area(walls[i])),
                  polygon_form_factor(walls[j], walls[i]) * glm::length(vector_area(walls[j])) * (i != j), tolerance);
    }
    EXPECT_NEAR(sum, 1, tolerance) << "wall " << i;
  }
}

// The walls of a hexahedron, seen from inside; corner i has the bits of i as its place.
std::vector<Polygon> walls_of(const std::array<glm::dvec3, 8>& c) {
  return {{c[0], c[1], c[3], c[2]}, {c[4], c[6], c[7], c[5]}, {c[0], c[4], c[5], c[1]},
          {c[2], c[3], c[7], c[6]}, {c[0], c[2], c[6], c[4]}, {c[1], c[5], c[7], c[3]}};
}

std::array<glm::dvec3, 8> box(const glm::dvec3& size) {
  std::array<glm::dvec3, 8> c;
  for (int i = 0; i < 8; ++i) c[i] = size * glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
  return c;
}

TEST(ClosedForm, BoxesAreClosed) {
  expect_closed(walls_of(box({1, 1, 1})), 1e-12);
  expect_closed(walls_of(box({1, 2, 3})), 1e-12);
  expect_closed(walls_of(box({10, 0.1, 0.3})), 1e-12);
  expect_closed(walls_of(box({100, 1, 1e-3})), 1e-12);
  const std::vector<Polygon> floor = walls_of(box({1, 2, 3}));
  expect_relative(polygon_form_factor(floor[0], floor[1]), 0.06033138537, 1e-9);
  expect_relative(polygon_form_factor(floor[0], floor[2]), 0.161694014333, 1e-9);
  expect_relative(polygon_form_factor(floor[0], floor[4]), 0.308140292982, 1e-9);
}

// Edges at any angle, all of them shared: a tetrahedron, a wedge, a frustum.
TEST(ClosedForm, SlantedRoomsAreClosed) {
  const std::array<glm::dvec3, 4> t{{{0, 0, 0}, {1, 0.1, 0}, {0.2, 0.9, 0.1}, {0.3, 0.2, 1.1}}};
  expect_closed({{t[0], t[1], t[2]}, {t[0], t[2], t[3]}, {t[0], t[3], t[1]}, {t[1], t[3], t[2]}}, 1e-12);
  const std::array<glm::dvec3, 4> thin{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.4, 0.01}}};
  expect_closed({{thin[0], thin[1], thin[2]},
                 {thin[0], thin[2], thin[3]},
                 {thin[0], thin[3], thin[1]},
                 {thin[1], thin[3], thin[2]}},
                1e-11);
  std::array<glm::dvec3, 8> frustum = box({1, 1, 1});
  for (int i = 4; i < 8; ++i) frustum[i] = {0.3 + 0.4 * frustum[i].x, 0.2 + 0.4 * frustum[i].y, 0.7};
  expect_closed(walls_of(frustum), 1e-12);
  // The same anywhere in space.
  const glm::dmat4 m = translation({3, -20, 7}) * rotation(0.7, {1, 2, 3}) * scaling({2, 2, 2});
  for (glm::dvec3& p : frustum) p = glm::dvec3(m * glm::dvec4(p, 1));
  expect_closed(walls_of(frustum), 1e-11);
}

// F_1(2+3) = F_12 + F_13, with pieces that touch, and whatever the order of magnitude of a piece.
TEST(ClosedForm, IsAdditive) {
  const Polygon from{{0, 0, 0}, {1, 0.2, 0}, {0.7, 1, 0}, {0.1, 0.8, 0}};
  const glm::dvec3 corner(0, -0.3, 0), u(0.3, 0.2, 2), v(0.1, 2, 0.1);
  const double whole = polygon_form_factor(from, rectangle(corner, v, u));
  EXPECT_GT(whole, 0.01);
  for (const double s : {0.5, 0.01, 1e-4, 1e-6}) {
    const double parts = polygon_form_factor(from, rectangle(corner, v, s * u)) +
                         polygon_form_factor(from, rectangle(corner + s * u, v, (1 - s) * u));
    EXPECT_NEAR(parts, whole, 1e-12) << s;
  }
}

// Two polygons that float beside each other, against Gauss points over both areas.
TEST(ClosedForm, AgreesWithTheDefinition) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> one(-1, 1);
  int both_ways = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto vector = [&] { return glm::dvec3(one(random), one(random), one(random)); };
    const Polygon a = rectangle(vector(), vector(), vector());
    const Polygon b = rectangle(glm::dvec3(0, 0, 5) + vector(), vector(), vector());
    const glm::dvec3 na = glm::cross(a[1] - a[0], a[3] - a[0]), nb = glm::cross(b[1] - b[0], b[3] - b[0]);
    const auto front = [](const Polygon& p, const Polygon& q, const glm::dvec3& n) {
      return std::all_of(p.begin(), p.end(), [&](const glm::dvec3& c) { return glm::dot(n, c - q[0]) > 0; });
    };
    if (!front(a, b, nb) || !front(b, a, na)) continue;
    ++both_ways;
    double sum = 0;
    const auto points = gauss_legendre(12);
    for (const GaussPoint& s : points)
      for (const GaussPoint& t : points)
        for (const GaussPoint& u : points)
          for (const GaussPoint& v : points) {
            const glm::dvec3 r =
                b[0] + u.x * (b[1] - b[0]) + v.x * (b[3] - b[0]) - a[0] - s.x * (a[1] - a[0]) - t.x * (a[3] - a[0]);
            const double r2 = glm::dot(r, r);
            sum += s.weight * t.weight * u.weight * v.weight * glm::dot(na, r) * -glm::dot(nb, r) / (r2 * r2);
          }
    const double expected = sum / (pi * glm::length(na));
    EXPECT_NEAR(polygon_form_factor(a, b), expected, 1e-11 + 1e-9 * expected);
  }
  EXPECT_GT(both_ways, 20);
}

TEST(ClosedForm, WhatSeesNothing) {
  const Polygon floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(polygon_form_factor(floor, floor), 0);
  EXPECT_EQ(polygon_form_factor(floor, rectangle({1, 0, 0}, {1, 0, 0}, {0, 1, 0})), 0);   // beside it
  EXPECT_EQ(polygon_form_factor(floor, rectangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0})), 0);   // its own back
  EXPECT_EQ(polygon_form_factor(floor, rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0})), 0);   // faces away
  EXPECT_EQ(polygon_form_factor(floor, rectangle({0, 0, -1}, {0, 1, 0}, {1, 0, 0})), 0);  // below
  EXPECT_EQ(polygon_form_factor(floor, Polygon{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}), 0);     // no area
  EXPECT_EQ(polygon_form_factor(Polygon{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, floor), 0);
  // A wall through the floor: half of each is behind the other.
  const Polygon through = rectangle({0.5, 0, -1}, {0, 1, 0}, {0, 0, 2});
  EXPECT_NEAR(polygon_form_factor(floor, through),
              0.5 * polygon_form_factor(rectangle({0.5, 0, 0}, {0.5, 0, 0}, {0, 1, 0}),
                                        rectangle({0.5, 0, 0}, {0, 1, 0}, {0, 0, 1})),
              1e-12);
  EXPECT_GT(polygon_form_factor(floor, through), 0.1);
}

// A patch of 1e-12 square metres on a wall, at its foot too.
TEST(ClosedForm, TinyBesideLarge) {
  const Polygon floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto wall_patch = [](double height) { return rectangle({0, 0.5, height}, {0, 1e-6, 0}, {0, 0, 1e-6}); };
  for (const double height : {0.5, 1e-2, 1e-4}) {
    const glm::dvec3 middle(0, 0.5 + 5e-7, height + 5e-7);
    expect_relative(polygon_form_factor(wall_patch(height), floor), point_form_factor(middle, {1, 0, 0}, floor), 2e-5);
  }
  // Towards the edge half of what it sees is floor.
  EXPECT_NEAR(polygon_form_factor(wall_patch(0), floor), 0.5, 1e-5);
  EXPECT_NEAR(polygon_form_factor(floor, wall_patch(0)) / 0.5e-12, 1, 1e-5);
}

}  // namespace
}  // namespace cg
