// Which pixels a triangle covers, and with which depth.
#include <gtest/gtest.h>

#include <random>

#include "raster/triangle_raster.h"
#include "tests/raster/pictures.h"

namespace cg {
namespace {

VisibilityBuffer cleared(int width, int height) {
  VisibilityBuffer buffer;
  buffer.clear(width, height);
  return buffer;
}

WindowVertex window_vertex(double x, double y, double z) {
  WindowVertex v{float(x), float(y), float(z), 1, 0, 0, 0};
  v.snapped_x = std::int32_t(std::lrint((v.x - 0.5f) * float(subpixels)));
  v.snapped_y = std::int32_t(std::lrint((v.y - 0.5f) * float(subpixels)));
  return v;
}

// How often each pixel of a picture is covered by the triangles of a fan around a point.
std::vector<int> coverage_of_fan(const WindowVertex& centre, const std::vector<WindowVertex>& rim, int size) {
  std::vector<int> count(std::size_t(size) * std::size_t(size));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    VisibilityBuffer buffer = cleared(size, size);
    draw_triangle({&buffer, 0, size}, centre, rim[i], rim[(i + 1) % rim.size()], 7);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) count[std::size_t(y * size + x)] += buffer.triangle(x, y) == 7;
  }
  return count;
}

// Neighbours share an edge: no pixel may belong to both or to neither, whatever the sub-pixel position, and
// however long the triangles are.
TEST(Visibility, NeighboursNeitherOverlapNorLeaveGaps) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> grid(0, 40 * 4);  // quarters of a pixel: many centres lie on edges
  for (int trial = 0; trial < 300; ++trial) {
    const int size = trial % 3 == 0 ? 200 : 40;
    const WindowVertex centre = window_vertex(grid(random) / 4.0 * size / 40, grid(random) / 4.0 * size / 40, 0.5);
    std::vector<WindowVertex> rim;
    const double s = size;
    for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(s, 0), glm::dvec2(s, s), glm::dvec2(0, s)})
      rim.push_back(window_vertex(p.x, p.y, 0.5));
    if (trial % 2) std::reverse(rim.begin(), rim.end());
    for (const int n : coverage_of_fan(centre, rim, size)) ASSERT_EQ(n, 1) << trial;
  }
}

TEST(Visibility, DepthIsLinearInTheWindow) {
  VisibilityBuffer buffer = cleared(64, 64);
  const auto depth = [](double x, double y) { return 0.1 + 0.004 * x + 0.007 * y; };
  const auto vertex = [&](double x, double y) { return window_vertex(x, y, depth(x, y)); };
  draw_triangle({&buffer, 0, 64}, vertex(-0.0, 0), vertex(64, 3), vertex(10, 60), 1);
  std::size_t covered = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (buffer.triangle(x, 63 - y) != 1) continue;
      ++covered;
      EXPECT_NEAR(buffer.depth(x, 63 - y), depth(x + 0.5, y + 0.5), 3e-7);
    }
  EXPECT_GT(covered, 1000u);
}

TEST(Visibility, OfEqualDepthsTheFirstStays) {
  VisibilityBuffer buffer = cleared(8, 8);
  const WindowVertex a = window_vertex(0, 0, 0.5), b = window_vertex(8, 0, 0.5), c = window_vertex(0, 8, 0.5);
  draw_triangle({&buffer, 0, 8}, a, b, c, 1);
  draw_triangle({&buffer, 0, 8}, b, a, c, 2);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_NE(buffer.triangle(x, y), 2u);
}

TEST(Visibility, BandsMakeOnePicture) {
  VisibilityBuffer whole = cleared(50, 50), bands = cleared(50, 50);
  const WindowVertex a = window_vertex(3.3, 1.7, 0.2), b = window_vertex(47.1, 20.2, 0.8),
                     c = window_vertex(11, 49, 0.4);
  draw_triangle({&whole, 0, 50}, a, b, c, 1);
  for (int top = 0; top < 50; top += 7) draw_triangle({&bands, top, std::min(top + 7, 50)}, a, b, c, 1);
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 50; ++x) {
      EXPECT_EQ(whole.triangle(x, y), bands.triangle(x, y));
      EXPECT_EQ(whole.depth(x, y), bands.depth(x, y));
    }
}

// Eight triangles set up together, of all sizes and some of no area or between the pixels, draw what each draws alone.
TEST(Visibility, EightAtOnceAsOneByOne) {
  constexpr int width = 1300, height = 40;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1), reach(0, 3.2);
  VisibilityBuffer together = cleared(width, height), alone = cleared(width, height);
  std::vector<std::array<WindowVertex, 3>> triangles;
  for (int i = 0; i < 1003; ++i) {
    const double size = std::pow(10, reach(random)), x = width * place(random), y = height * place(random);
    std::array<WindowVertex, 3> t;
    for (WindowVertex& v : t)
      v = window_vertex(std::min(x + size * place(random), double(width)),
                        std::min(y + size * place(random), double(height)), place(random));
    if (i % 50 == 0) t[2] = t[1];
    triangles.push_back(t);
  }
  const Band rows{&together, 5, 36};
  TriangleQueue queue(rows);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    queue.add(t[0], t[1], t[2], i);
    draw_triangle({&alone, 5, 36}, t[0], t[1], t[2], i);
  }
  queue.flush();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      ASSERT_EQ(together.triangle(x, y), alone.triangle(x, y)) << x << ' ' << y;
      ASSERT_EQ(together.depth(x, y), alone.depth(x, y)) << x << ' ' << y;
    }
}

}  // namespace
}  // namespace cg
