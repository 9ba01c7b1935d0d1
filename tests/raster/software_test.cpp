// The software technique as a whole.
#include "raster/software.h"

#include <gtest/gtest.h>

#include "tests/raster/pictures.h"

namespace cg {
namespace {

using testing::draw;

bool same_bits(const Frame& a, const Frame& b) {
  return a.colour == b.colour && a.depth == b.depth && a.covered == b.covered && a.object == b.object &&
         a.triangle == b.triangle && a.normal == b.normal && a.nan_pixels == b.nan_pixels;
}

Scene two_tori() {
  Scene scene = testing::scene_of(testing::torus(60, 30));
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].transform = {{0.3, 0.2, 0.1}, {70, 20, 5}, {0.8, 0.8, -0.8}};
  scene.objects[1].own_material = true;
  scene.objects[1].material.k_d = {0.9, 0.2, 0.1};
  return scene;
}

TEST(Software, SameBitsForAnyNumberOfThreadsRunAfterRun) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (const Precision precision : {Precision::single_precision, Precision::double_precision})
      for (const glm::dvec3 eye : {glm::dvec3(0, 1, 3.4), glm::dvec3(0.9, 0.2, 0.5)}) {
        Scene scene = two_tori();
        scene.shading.mode = mode;
        scene.shading.precision = precision;
        scene.shading.two_sided = true;
        scene.camera.position = eye;
        View view{211, 143, 1, true, true};
        const Frame one = draw(scene, view);
        EXPECT_TRUE(same_bits(one, draw(scene, view)));
        for (const int threads : {2, 3, 7}) {
          view.threads = threads;
          EXPECT_TRUE(same_bits(one, draw(scene, view))) << threads;
        }
      }
}

TEST(Software, PrecisionChangesLittle) {
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    Scene scene = two_tori();
    scene.shading.mode = mode;
    const Frame d = draw(scene, {200, 200});
    scene.shading.precision = Precision::single_precision;
    const Frame f = draw(scene, {200, 200});
    EXPECT_EQ(d.covered, f.covered);
    for (std::size_t i = 0; i < d.colour.size(); ++i)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(d.colour.pixels()[i][c], f.colour.pixels()[i][c], 1e-4);
  }
}

TEST(Software, EmptyPicturesAndScenes) {
  const Scene scene = two_tori();
  EXPECT_TRUE(draw(scene, {0, 0}).colour.empty());
  EXPECT_TRUE(draw(scene, {0, 20}).colour.empty());
  EXPECT_EQ(draw(scene, {1, 1}).colour.size(), 1u);
  Scene none;
  none.display.background = {0.1, 0.2, 0.3};
  const Frame f = draw(none, {4, 4});
  EXPECT_EQ(f.colour.at(2, 2), glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(testing::covered(f), 0u);
}

TEST(Software, IdsNormalsAndDepthAgreeWithTheScene) {
  const Scene scene = two_tori();
  const Frame f = draw(scene, {160, 120, 1, true, true});
  std::array<int, 2> seen{};
  for (std::size_t i = 0; i < f.colour.size(); ++i) {
    const bool covered = f.covered.pixels()[i];
    EXPECT_EQ(covered, f.object.pixels()[i] != nothing);
    EXPECT_EQ(covered, f.triangle.pixels()[i] != nothing);
    EXPECT_EQ(covered, f.depth.pixels()[i] < 1);
    EXPECT_NEAR(glm::length(f.normal.pixels()[i]), covered ? 1 : 0, 1e-5);
    if (covered) ++seen[std::size_t(f.object.pixels()[i])];
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);
}

TEST(Software, CancelledWorkThrows) {
  const Technique software = software_technique();
  const Scene scene = two_tori();
  Progress progress;
  progress.cancelled = true;
  for (const int threads : {1, 2}) {
    const View view{64, 64, threads};
    EXPECT_THROW(software.render(scene, software.plan(scene, view), view, progress), Cancelled);
  }
}

TEST(SoftwarePlan, NamesWhatRunsAndWhy) {
  Scene scene = two_tori();
  scene.camera.position = {0, 1, 9};
  const Plan far = software_technique().plan(scene, {64, 64});
  EXPECT_FALSE(far.runs("clip"));
  EXPECT_TRUE(far.runs("vertex-lighting"));
  EXPECT_FALSE(far.runs("pixel-lighting"));
  EXPECT_FALSE(far.runs("ids"));
  scene.camera.position = {0, 0.1, 0.2};
  scene.shading.mode = ShadingMode::phong;
  const Plan near = software_technique().plan(scene, {64, 64, 1, true});
  EXPECT_TRUE(near.runs("clip"));
  EXPECT_TRUE(near.runs("pixel-lighting"));
  EXPECT_TRUE(near.runs("ids"));
  for (const Pass& p : near.passes) {
    EXPECT_FALSE(p.reason.en.empty() || p.reason.ja.empty()) << p.id;
    EXPECT_TRUE(p.needed || p.bytes == 0) << p.id;
  }
}

}  // namespace
}  // namespace cg
