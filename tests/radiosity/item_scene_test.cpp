// Which patch each pixel of a hemicube sees.
#include "radiosity/item_scene.h"

#include <gtest/gtest.h>

#include "radiosity/hemicube_rows.h"
#include "radiosity/hemicube_view.h"
#include "radiosity/patch_tree.h"
#include "radiosity/sample_positions.h"
#include "tests/radiosity/patch_rooms.h"

namespace cg {
namespace {

// Pixels of a closed room's hemicubes that see nothing, or the back of something.
std::size_t missed_pixels(const Patches& patches, int resolution, std::size_t every) {
  const std::vector<ItemPolygon> polygons = item_polygons(patches);
  const ItemScene scene(polygons);
  std::size_t missed = 0;
  HemicubeItems items;
  for (std::size_t i = 0; i < polygons.size(); i += every) {
    const Patch& patch = patches.patches[i];
    std::size_t number = 0;
    for (const SamplePosition& at : sample_positions(patch, 2, i % 2 ? Placement::grid : Placement::gauss)) {
      RowSums sums;
      sums.begin(scene, patch, std::uint32_t(i));
      draw_items(scene, {}, hemicube_frame(at.position, patch.normal, number++, 2), resolution, sums, items);
      for (const HemicubeFace f : hemicube_faces)
        for (int y = 0; y < face_height(f, resolution); ++y)
          for (int x = 0; x < face_width(f, resolution); ++x) missed += items.item(f, x, y) >= from_behind;
    }
  }
  return missed;
}

TEST(ItemScene, NoPixelOfAClosedRoomIsMissed) {
  for (const int n : {13, 26, 52}) {  // 1k, 4k, 16k patches
    EXPECT_EQ(missed_pixels(closed_cube(n), 128, std::size_t(n) * 3 + 1), 0u) << n;
    EXPECT_EQ(missed_pixels(closed_sphere(2 * n, n * 3 / 2), 128, std::size_t(n) * 3 + 1), 0u) << n;
  }
  EXPECT_EQ(missed_pixels(closed_cube(7), 18, 5), 0u);  // tiles reach over the faces' borders
  EXPECT_EQ(missed_pixels(closed_cube(8), 1024, 97), 0u);
}

// Walls cut differently, so that corners lie within their neighbours' edges; turned, moved and of any size.
TEST(ItemScene, NoPixelIsMissedAtTJunctions) {
  for (const double size : {1.0, 550.0, 1e-3})
    for (const bool turned : {false, true}) {
      const glm::dvec3 z = turned ? unit(glm::dvec3(0.3, -0.5, 0.8)) : glm::dvec3(0, 0, 1);
      const glm::dvec3 x = turned ? unit(glm::cross(z, glm::dvec3(0.2, 0.9, 0.1))) : glm::dvec3(1, 0, 0);
      const glm::dvec3 u = size * x, v = size * glm::cross(z, x), w = size * z, o = size * glm::dvec3(1.7, -0.4, 2.9);
      Patches room;
      add_rectangle(room, o, u, v, 7, 9), add_rectangle(room, o + w, v, u, 11, 13);
      add_rectangle(room, o, v, w, 5, 17), add_rectangle(room, o + u, w, v, 19, 6);
      add_rectangle(room, o, w, u, 23, 8), add_rectangle(room, o + v, u, w, 10, 29);
      EXPECT_EQ(missed_pixels(room, 128, 23), 0u) << size << " " << turned;
    }
}

// What a ray meets first, of all patches, in double.
std::uint32_t met(const Patches& room, const glm::dvec3& o, const glm::dvec3& d, double& clear) {
  double nearest = 1e30;
  std::uint32_t item = no_item;
  clear = 1;  // of all planes through edges: how far
  for (std::uint32_t j = 0; j < room.patches.size(); ++j) {
    const Patch& p = room.patches[j];
    const double against = glm::dot(d, p.normal), t = glm::dot(p.centre - o, p.normal) / against;
    if (!(t > 1e-9) || !(std::abs(against) > 1e-9)) continue;
    double inside = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      const glm::dvec3 a = p.corner[k] - o, b = p.corner[(k + 1) % 4] - o;
      if (a != b) inside = std::min(inside, glm::dot(unit(glm::cross(b, a)), d) * (against < 0 ? 1 : -1));
    }
    clear = std::min(clear, std::abs(inside));
    if (inside >= 0 && t < nearest) nearest = t, item = j | (against < 0 ? 0 : from_behind);
  }
  return item;
}

Patches furnished_room() {
  Patches room = closed_cube(5);
  add_rectangle(room, {0.3, 0.3, 0.4}, {0.3, 0, 0}, {0, 0.25, 0}, 2, 2);
  add_rectangle(room, {0.6, 0.7, 0.1}, {0.2, 0.1, 0.3}, {-0.3, 0.1, 0.2}, 3, 1);
  return room;
}

TEST(ItemScene, PixelsAndRaysSeeWhatIsThere) {
  const Patches room = furnished_room();
  const std::vector<ItemPolygon> polygons = item_polygons(room);
  const ItemScene scene(polygons);
  const PatchTree tree(polygons);
  const HemicubeViewer viewer(room);
  Radiosity options;
  options.resolution = 32, options.samples = 2;
  std::size_t doubtful = 0, all = 0;
  for (std::uint32_t i = 0; i < polygons.size(); i += 3) {
    const HemicubeView view = viewer.view(i, i % 4, options);
    Horizon horizon;
    scene.find_above(room.patches[i].centre, room.patches[i].normal, horizon);
    for (int y = 0; y < view.items.height(); ++y)
      for (int x = 0; x < view.items.width(); ++x) {
        const auto pixel = cross_pixel(x, y, options.resolution);
        if (!pixel) continue;
        const glm::dvec3 d = pixel_direction(view, *pixel), o = view.frame.position;
        double clear = 0;
        const std::uint32_t item = met(room, o, d, clear);
        ++all;
        if (clear < 1e-5) ++doubtful;  // an edge runs through the sample
        if (clear >= 1e-5) {
          ASSERT_EQ(view.items.at(x, y), item) << i << ": " << x << ", " << y;
        }
        if (clear >= 1e-5) {
          ASSERT_EQ(tree.first_met(o, d, horizon.above), item) << i << ": " << x << ", " << y;
        }
      }
  }
  EXPECT_LT(double(doubtful), 0.01 * double(all));
}

TEST(ItemScene, ViewIsTheWholeCross) {
  const Patches room = closed_cube(4);
  Radiosity options;
  options.resolution = 32, options.samples = 1;
  const HemicubeView view = HemicubeViewer(room).view(5, 0, options);
  double sum = 0;
  int seen = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      sum += double(view.weights.at(x, y));
      const bool pixel = cross_pixel(x, y, 32).has_value();
      ASSERT_EQ(pixel, view.items.at(x, y) != no_item);
      seen += pixel;
    }
  EXPECT_EQ(seen, 3 * 32 * 32);
  EXPECT_NEAR(sum, 1 + 5.30e-4, 1e-5);
  // Above is the ceiling, to the right of the picture is where the frame's x points.
  EXPECT_EQ(view.items.at(32, 32) / 16, 1u);
  EXPECT_GT(glm::dot(pixel_direction(view, *cross_pixel(60, 32, 32)), view.frame.x), 0.9);
  EXPECT_GT(glm::dot(pixel_direction(view, *cross_pixel(32, 3, 32)), view.frame.y), 0.9);
}

TEST(SamplePositions, RulesIntegratePolynomials) {
  const Patch triangle = make_patch({{0, 0, 0}, {3, 0, 0}, {0, 2, 0}});
  const Patch quad = make_patch({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}});
  const Patch trapezoid = make_patch({{0, 0, 0}, {4, 0, 0}, {3, 2, 0}, {1, 2, 0}});
  struct Case {
    const Patch& patch;
    double mean_y, mean_xx;
    bool even;  // the grid is exact for y too
  };
  for (const Case& c : {Case{triangle, 2.0 / 3, 1.5, true}, {quad, 1, 3, true}, {trapezoid, 8.0 / 9, 29.0 / 6, false}})
    for (const Placement placement : {Placement::grid, Placement::gauss})
      for (const int s : {1, 2, 3, 7, 16}) {
        double sum = 0, y = 0, xx = 0;
        for (const SamplePosition& at : sample_positions(c.patch, s, placement)) {
          sum += at.weight, y += at.weight * at.position.y, xx += at.weight * at.position.x * at.position.x;
          ASSERT_GT(at.weight, 0);
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        const bool gauss = placement == Placement::gauss;
        if (c.even || (gauss && s > 1)) {
          EXPECT_NEAR(y, c.mean_y, 1e-12) << s;
        }
        if (gauss && s > (c.even ? 1 : 2)) {
          EXPECT_NEAR(xx, c.mean_xx, 1e-12) << s;
        }
      }
}

}  // namespace
}  // namespace cg
