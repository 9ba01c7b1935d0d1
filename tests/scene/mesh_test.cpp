#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <tuple>

#include "math/transform.h"
#include "scene/polygon.h"

using namespace cg;

namespace {

// One polygon; its corners are the positions in their order.
MeshData one_face(std::vector<glm::dvec3> positions) {
  MeshData data;
  std::vector<Corner> corners(positions.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i].position = i;
  data.positions = std::move(positions);
  data.add_face(corners.data(), corners.data() + corners.size());
  return data;
}

std::vector<glm::dvec3> flat(std::initializer_list<glm::dvec2> points) {
  std::vector<glm::dvec3> out;
  for (const glm::dvec2& p : points) out.emplace_back(p, 0);
  return out;
}

struct Areas {
  double signed_sum = 0, absolute_sum = 0;
};

// Of the triangles, along the polygon's own normal. Equal sums: no triangle is turned over or overlaps.
Areas areas(const Mesh& mesh) {
  glm::dvec3 sum(0);
  Areas out;
  for (const Triangle& t : mesh.triangles()) {
    std::array<glm::dvec3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = mesh.data().positions[mesh.data().corners[t.corner[k]].position];
    const glm::dvec3 a = vector_area(p);
    sum += a;
    out.absolute_sum += glm::length(a);
  }
  out.signed_sum = glm::length(sum);
  return out;
}

void expect_covered(const std::vector<glm::dvec3>& polygon) {
  const MeshHandle mesh = Mesh::make(one_face(polygon));
  const double area = glm::length(vector_area(polygon));
  const Areas a = areas(*mesh);
  EXPECT_NEAR(a.absolute_sum, area, 1e-12 * area);
  EXPECT_NEAR(a.signed_sum, area, 1e-12 * area);
  EXPECT_EQ(mesh->report(), MeshReport{});
}

// A star with n points, n inner corners between them.
std::vector<glm::dvec3> star(int n, double inner) {
  std::vector<glm::dvec3> p;
  for (int i = 0; i < 2 * n; ++i) {
    const double r = i % 2 ? inner : 1, angle = pi * i / n;
    p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return p;
}

}  // namespace

TEST(Mesh, refuses_indices_out_of_range_and_positions_that_are_no_numbers) {
  MeshData data = one_face(flat({{0, 0}, {1, 0}, {0, 1}}));
  data.corners[1].position = 3;
  EXPECT_THROW(Mesh::make(data), std::invalid_argument);
  data.corners[1].position = 1;
  data.corners[1].normal = 0;
  EXPECT_THROW(Mesh::make(data), std::invalid_argument);
  data.corners[1].normal = no_index;
  data.corners[1].uv = 7;
  EXPECT_THROW(Mesh::make(data), std::invalid_argument);
  data.corners[1].uv = no_index;
  data.first_corner.back() = 2;
  EXPECT_THROW(Mesh::make(data), std::invalid_argument);
  data.first_corner.back() = 3;
  data.positions[0].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Mesh::make(data), std::invalid_argument);
}

TEST(Mesh, an_empty_mesh_is_a_mesh) {
  const MeshHandle mesh = Mesh::make({});
  EXPECT_TRUE(mesh->triangles().empty());
  EXPECT_EQ(mesh->low(), glm::dvec3(0));
  EXPECT_EQ(mesh->high(), glm::dvec3(0));
}

TEST(Mesh, drops_repeated_corners_and_counts_them) {
  MeshData data = one_face(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const auto corner = [](std::uint32_t p) { return Corner{p, no_index, no_index}; };
  data.corners = {corner(0), corner(0), corner(1), corner(2), corner(2), corner(2), corner(3), corner(0)};
  data.first_corner = {0, 8};
  const MeshHandle mesh = Mesh::make(data);
  EXPECT_EQ(mesh->data().corners, (std::vector<Corner>{corner(0), corner(1), corner(2), corner(3)}));
  EXPECT_EQ(mesh->report().repeated_corners, 4u);
  EXPECT_EQ(mesh->triangles().size(), 2u);
}

TEST(Mesh, keeps_degenerate_faces_without_triangles) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.5, 1e-30, 0}, {0, 1, 0}};
  const auto face = [&](std::vector<std::uint32_t> indices) {
    std::vector<Corner> corners;
    for (const std::uint32_t i : indices) corners.push_back({i, no_index, no_index});
    data.add_face(corners.data(), corners.data() + corners.size());
  };
  face({0, 1, 2});  // a line
  face({0, 1, 3});  // a sliver of height 1e-30
  face({0, 1, 0});  // two corners
  face({0, 1});
  face({});
  face({0, 1, 4});  // the good one
  const MeshHandle mesh = Mesh::make(data);
  EXPECT_EQ(mesh->data().face_count(), 6u);
  EXPECT_EQ(mesh->report().degenerate_faces, 5u);
  ASSERT_EQ(mesh->triangles().size(), 1u);
  EXPECT_EQ(mesh->triangles()[0].face, 5u);
}

TEST(Mesh, counts_normals_of_no_direction) {
  MeshData data = one_face(flat({{0, 0}, {1, 0}, {0, 1}}));
  data.normals = {{0, 0, 0}, {0, 0, 2}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
  EXPECT_EQ(Mesh::make(data)->report().bad_normals, 2u);
}

TEST(Mesh, bounds_are_of_the_positions_that_faces_use) {
  MeshData data = one_face(flat({{-1, 0}, {1, 0}, {0, 3}}));
  data.positions.emplace_back(100, 100, 100);
  const MeshHandle mesh = Mesh::make(data);
  EXPECT_EQ(mesh->low(), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(mesh->high(), glm::dvec3(1, 3, 0));
}

TEST(Mesh, a_convex_face_is_a_fan_around_its_last_corner) {
  const MeshHandle mesh = Mesh::make(one_face(flat({{1, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 0}})));
  ASSERT_EQ(mesh->triangles().size(), 3u);
  for (const Triangle& t : mesh->triangles()) EXPECT_EQ(t.corner[2], 4u);
}

TEST(Mesh, a_concave_quad_is_covered_once_wherever_it_begins) {
  std::vector<glm::dvec3> arrow = flat({{0, 0}, {2, -1}, {0, 3}, {-2, -1}});
  for (int start = 0; start < 4; ++start) {
    expect_covered(arrow);
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
  }
}

TEST(Mesh, concave_polygons_are_covered_once) {
  expect_covered(star(5, 0.3));
  expect_covered(star(500, 0.01));
  // A U, whose corners are in line with one another.
  expect_covered(flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));
  // A square with a square hole, joined by a bridge that is walked in both directions.
  expect_covered(flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
  // Corners in the middle of straight edges.
  expect_covered(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
  // A comb at 45 degrees, whose thin teeth have large boxes.
  std::vector<glm::dvec3> comb;
  for (int i = 0; i < 400; ++i) comb.emplace_back(i / 2 + (i % 2) * 100.0, (i + 1) / 2 - (i % 2) * 100.0, 0);
  comb.emplace_back(199, 201, 0), comb.emplace_back(-1, 1, 0);
  const double turn = vector_area(comb).z;
  if (turn < 0) std::reverse(comb.begin(), comb.end());
  expect_covered(comb);
}

TEST(Mesh, a_spiral_is_covered_once) {
  std::vector<glm::dvec3> spiral;
  const int n = 2000;
  for (int i = 0; i < n; ++i) spiral.emplace_back(i * std::cos(i * 0.05), i * std::sin(i * 0.05), 0);
  for (int i = n - 1; i > 0; --i) spiral.emplace_back((i + 2) * std::cos(i * 0.05), (i + 2) * std::sin(i * 0.05), 0);
  if (vector_area(spiral).z < 0) std::reverse(spiral.begin(), spiral.end());
  expect_covered(spiral);
}

// Around the origin with random radii: very concave, never crossing.
TEST(Mesh, random_stars_are_covered_once) {
  std::mt19937 random(1);
  for (int k = 0; k < 2000; ++k) {
    const int n = 3 + int(random() % 60);
    std::vector<glm::dvec3> p;
    for (int i = 0; i < n; ++i) {
      const double r = 0.01 + double(random() % 1000) / 1000, angle = 2 * pi * i / n;
      p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    if (n > 3) expect_covered(p);
  }
}

// The outlines of cells of a grid joined at random into a tree: all corners in rows, most of them in the middle of
// an edge.
TEST(Mesh, outlines_of_random_mazes_are_covered_once) {
  std::mt19937 random(2);
  for (int k = 0; k < 200; ++k) {
    const int size = 2 + int(random() % 12);
    // Right-hand rule along a random spanning tree, drawn at twice the scale with walls of width 1.
    std::set<std::pair<int, int>> cells{{0, 0}};
    std::vector<std::pair<int, int>> open{{0, 0}};
    while (!open.empty()) {
      const std::size_t pick = random() % open.size();
      const auto [x, y] = open[pick];
      std::vector<std::pair<int, int>> ways;
      for (const auto& [dx, dy] : {std::pair{2, 0}, {-2, 0}, {0, 2}, {0, -2}})
        if (x + dx >= 0 && y + dy >= 0 && x + dx < 2 * size && y + dy < 2 * size && !cells.contains({x + dx, y + dy}))
          ways.push_back({dx, dy});
      if (ways.empty()) {
        open.erase(open.begin() + long(pick));
        continue;
      }
      const auto [dx, dy] = ways[random() % ways.size()];
      cells.insert({x + dx / 2, y + dy / 2}), cells.insert({x + dx, y + dy});
      open.push_back({x + dx, y + dy});
    }
    // Walk with the inside on the left, beginning along the bottom of the first cell.
    std::vector<glm::dvec3> p;
    int x = 0, y = 0, dx = 1, dy = 0;
    const auto inside = [&](int u, int v) { return cells.contains({u, v}); };
    do {
      p.emplace_back(x, y, 0);
      x += dx, y += dy;
      // The cells ahead to the left and to the right of the corner that was reached.
      const auto ahead = [&](bool left) {
        const int sx = dx - (left ? dy : -dy), sy = dy + (left ? dx : -dx);
        return inside(x + (sx - 1) / 2, y + (sy - 1) / 2);
      };
      if (ahead(false))
        std::tie(dx, dy) = std::pair{dy, -dx};
      else if (!ahead(true))
        std::tie(dx, dy) = std::pair{-dy, dx};
    } while (x != 0 || y != 0 || dx != 1 || dy != 0);
    ASSERT_EQ(vector_area(p).z, double(cells.size()));
    expect_covered(p);
  }
}

// Whatever the corners: an end, and no triangle too many.
TEST(Mesh, random_crossings_end) {
  std::mt19937 random(3);
  for (int k = 0; k < 2000; ++k) {
    const std::size_t n = 4 + random() % 40;
    std::vector<glm::dvec3> p;
    for (std::size_t i = 0; i < n; ++i) p.emplace_back(random() % 7, random() % 7, random() % 2);
    const MeshHandle mesh = Mesh::make(one_face(p));
    EXPECT_LE(mesh->triangles().size(), n - 2);
  }
}

TEST(Mesh, polygons_of_a_hundred_thousand_corners_are_covered_once) {
  expect_covered(star(50000, 1));
  expect_covered(star(50000, 0.5));
}

TEST(Mesh, a_polygon_may_stand_anywhere_at_any_size) {
  for (const double scale : {1e-300, 1e-20, 1.0, 1e20, 1e300}) {
    std::vector<glm::dvec3> p;
    for (const glm::dvec3& q : star(7, 0.4)) p.push_back(glm::dvec3(q.y * 0.6, q.x, q.y * 0.8) * scale);
    const MeshHandle mesh = Mesh::make(one_face(p));
    EXPECT_EQ(mesh->triangles().size(), 12u) << scale;
    EXPECT_EQ(mesh->report(), MeshReport{}) << scale;
  }
}

TEST(Mesh, edges_that_cross_end_in_some_triangles) {
  const MeshHandle mesh = Mesh::make(one_face(flat({{0, 0}, {4, 4}, {4, 0}, {0, 4}, {-2, 1}, {5, 2}})));
  EXPECT_LE(mesh->triangles().size(), 4u);
}
