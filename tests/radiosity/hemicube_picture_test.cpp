// What the panel of the hemicube tells of pixels: sums, outlines, and the disc whose areas are form factors.
#include "radiosity/hemicube_picture.h"

#include <gtest/gtest.h>

#include <set>

#include "math/transform.h"
#include "patch_rooms.h"
#include "radiosity/closed_form.h"

namespace cg {
namespace {

// A point's patch below the middle of a unit square at distance 1.
Patches point_and_plate() {
  Patches out;
  add_rectangle(out, {-0.001, -0.001, 0}, {0.002, 0, 0}, {0, 0.002, 0});
  add_rectangle(out, {-0.5, -0.5, 1}, {0, 1, 0}, {1, 0, 0});
  return out;
}

Radiosity options_of(int resolution, PixelWeight weight = PixelWeight::delta_form_factor) {
  Radiosity r;
  r.resolution = resolution, r.samples = 1, r.weight = weight;
  return r;
}

TEST(HemicubePicture, ThePixelsOfAPatchAddUpToItsFormFactor) {
  const Patches patches = point_and_plate();
  const HemicubeView view = HemicubeViewer(patches).view(0, 0, options_of(64));
  const std::vector<PatchPixels> pixels = patch_pixels(view);
  ASSERT_EQ(pixels.size(), 2u);  // the plate and nothing
  EXPECT_EQ(pixels[0].item, 1u);
  EXPECT_NEAR(pixels[0].sum, 0.239456470461, 1e-4);
  EXPECT_EQ(pixels[1].item, no_item);
  EXPECT_EQ(pixels[0].pixels + pixels[1].pixels, 3u * 64 * 64);  // no corner counted
  EXPECT_NEAR(pixels[0].sum + pixels[1].sum, 1, 2e-4);
  EXPECT_EQ(pixels[0].pixels, 32u * 32);
  EXPECT_EQ(pixels[0].low, glm::ivec2(48, 48));
  EXPECT_EQ(pixels[0].high, glm::ivec2(79, 79));
}

// The published mistakes: sums near 1 and a third, or a quarter, of the factor gone.
TEST(HemicubePicture, WrongWeightsMissThePlateAndStillSumToOne) {
  const Patches patches = point_and_plate();
  const HemicubeView view = HemicubeViewer(patches).view(0, 0, options_of(64));
  const auto sums = weighted_sums(view, 1, all_weights(64));
  const auto of = [&](PixelWeight w) { return sums[std::size_t(w)].item; };
  EXPECT_NEAR(of(PixelWeight::delta_form_factor), 0.2394565, 1e-4);
  EXPECT_NEAR(of(PixelWeight::integrated), 0.2394565, 1e-7);
  EXPECT_NEAR(of(PixelWeight::unweighted), 1.0 / 12, 1e-6);
  // The plate's solid angle over that of the hemisphere: 4 asin(sin^2(a/2)) of a square of the angle a.
  EXPECT_NEAR(of(PixelWeight::solid_angle), 4 * std::asin(0.2) / (2 * pi), 1e-3);
  EXPECT_NEAR(of(PixelWeight::r_squared), 0.178, 5e-3);
  const HemicubeView chosen = HemicubeViewer(patches).view(0, 0, options_of(64, PixelWeight::solid_angle));
  EXPECT_NEAR(patch_pixels(chosen)[0].sum, of(PixelWeight::solid_angle), 1e-6);
}

TEST(HemicubePicture, WeightedSumsCountWhatIsSeen) {
  const Patches cube = closed_cube(2);
  const HemicubeView view = HemicubeViewer(cube).view(0, 0, options_of(32));
  for (const WeightedSum& s : weighted_sums(view, 5, all_weights(32))) EXPECT_NEAR(s.all, 1, 6e-4);
}

TEST(HemicubePicture, TheOutlineOfASquareIsFourLines) {
  const Patches patches = point_and_plate();
  const HemicubeView view = HemicubeViewer(patches).view(0, 0, options_of(64));
  const std::vector<PixelEdge> edges = item_outline(view, patch_pixels(view)[0]);
  const std::vector<PixelEdge> square{{48, 48, 80, 48}, {48, 80, 80, 80}, {48, 48, 48, 80}, {80, 48, 80, 80}};
  EXPECT_EQ(edges, square);
}

// Whatever shape it has: the lines, with the side on which the inside is, enclose as many pixels as it has.
TEST(HemicubePicture, OutlinesEncloseTheirPixels) {
  const Patches cube = closed_cube(3);
  const HemicubeView view = HemicubeViewer(cube).view(4, 0, options_of(24));
  for (const PatchPixels& p : patch_pixels(view)) {
    long length = 0, neighbours = 0;
    for (const PixelEdge& e : item_outline(view, p)) length += std::abs(e.x1 - e.x0) + std::abs(e.y1 - e.y0);
    const auto same = [&](int x, int y) {
      return x >= 0 && y >= 0 && x < 48 && y < 48 && cross_pixel(x, y, 24) && view.items.at(x, y) == p.item;
    };
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        if (same(x, y)) neighbours += !same(x - 1, y) + !same(x + 1, y) + !same(x, y - 1) + !same(x, y + 1);
    EXPECT_EQ(length, neighbours) << p.item;
  }
}

TEST(HemicubePicture, PatchesHaveColoursOfTheirOwn) {
  std::set<std::array<int, 3>> colours;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const glm::u8vec4 c = item_colour(i), next = item_colour(i + 1);
    colours.insert({c.r, c.g, c.b});
    EXPECT_EQ(c.a, 255);
    EXPECT_GT(std::abs(c.r - next.r) + std::abs(c.g - next.g) + std::abs(c.b - next.b), 60) << i;
  }
  EXPECT_GT(colours.size(), 195u);
}

TEST(HemicubePicture, ACrossHasNothingInItsCornersAndKeepsItsColoursWhenSmall) {
  const Patches patches = point_and_plate();
  const HemicubeView view = HemicubeViewer(patches).view(0, 0, options_of(64));
  for (const int most : {1024, 32}) {
    const Picture cross = cross_picture(view, item_colours(), most);
    const int size = std::min(most, 128);
    ASSERT_EQ(cross.width(), size);
    EXPECT_EQ(cross.at(0, 0).a, 0);
    EXPECT_EQ(cross.at(size - 1, size / 4 - 1).a, 0);
    EXPECT_EQ(cross.at(size / 2, 0), glm::u8vec4(0, 0, 0, 255));
    EXPECT_EQ(cross.at(size / 2, size / 2), item_colour(1));
  }
}

// Nusselt: the share of the base that a patch covers is its form factor.
TEST(HemicubePicture, AreasOfTheDiscAreFormFactors) {
  const Patches cube = closed_cube(2);
  const HemicubeView view = HemicubeViewer(cube).view(0, 0, options_of(256));
  const auto red_is = [](std::uint32_t which) {
    return [which](std::uint32_t item, float, const glm::dvec3&) {
      return item == which ? glm::u8vec4(255, 0, 0, 255) : glm::u8vec4(0, 0, 0, 255);
    };
  };
  for (std::uint32_t j = 4; j < cube.patches.size(); ++j) {
    const Picture disc = disc_picture(view, red_is(j), 400);
    long red = 0;
    for (const glm::u8vec4& p : disc.pixels()) red += p.r == 255;
    const double exact = point_form_factor(view.frame.position, view.frame.z, cube.patches[j].corner);
    EXPECT_NEAR(double(red) / (pi * 200 * 200), exact, 1.5e-3) << j;
  }
}

TEST(HemicubePicture, SeenColoursAreTheSolvedLightOrTheMaterial) {
  Patches patches = point_and_plate();
  patches.patches[1].reflectance = {0.8, 0.4, 0};
  const glm::dvec3 ahead(0, 0, 1);
  EXPECT_EQ(seen_colours(patches, {}, {})(1, 0, ahead), glm::u8vec4(204, 102, 0, 255));
  const std::vector<glm::dvec3> light{{0, 0, 0}, {0.2, 1, 3}};
  EXPECT_EQ(seen_colours(patches, light, {})(1, 0, ahead), glm::u8vec4(51, 255, 255, 255));
  patches.patches[1].emission = {1, 1, 1};
  EXPECT_EQ(seen_colours(patches, {}, {})(1, 0, ahead), glm::u8vec4(255, 255, 255, 255));
}

}  // namespace
}  // namespace cg
