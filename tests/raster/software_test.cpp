// The software technique as a whole.
#include "raster/software.h"

#include <gtest/gtest.h>

#include "raster/visibility.h"
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

// Surfaces that lie in each other, cut by the view volume: at every pixel the first of equal depths must stay, in both
// ways in which threads share the triangles.
TEST(Software, OfEqualDepthsTheFirstStaysForAnyNumberOfThreads) {
  Scene scene = two_tori();
  for (const std::size_t twin : {0, 1, 0}) scene.objects.push_back(scene.objects[twin]);
  scene.camera.position = {0.2, 0.9, 1.6};
  std::size_t triangles = 0;
  for (const Object& o : scene.objects) triangles += o.mesh->triangles().size();
  std::array<int, 2> ways{};
  for (const glm::ivec2 size : {glm::ivec2(211, 143), glm::ivec2(900, 611)}) {
    View view{size.x, size.y, 1, true, false};
    const Frame one = draw(scene, view);
    const auto object = std::max_element(one.object.pixels().begin(), one.object.pixels().end());
    EXPECT_EQ(*object, 1);
    for (const int threads : {2, 3, 7}) {
      view.threads = threads;
      ++ways[draws_triangles_apart(triangles, size.x, size.y, threads)];
      EXPECT_TRUE(same_bits(one, draw(scene, view))) << threads << " threads, " << size.x;
    }
  }
  EXPECT_GT(ways[0], 0);
  EXPECT_GT(ways[1], 0);
}

// A triangle that the view volume cuts has a number after all others, but its place in the order of drawing: it is the
// first in its mesh, before others in the same plane.
TEST(Software, OfEqualDepthsOneThatIsCutStaysForAnyNumberOfThreads) {
  MeshData mesh;
  const auto add = [&](double x, double y, double size) {
    const std::uint32_t first = std::uint32_t(mesh.positions.size());
    for (const glm::dvec2 to : {glm::dvec2(0, 0), glm::dvec2(size, 0), glm::dvec2(0, size)})
      mesh.positions.push_back({x + to.x, y + to.y, 0});
    const std::array<Corner, 3> face{testing::corner(first), testing::corner(first + 1), testing::corner(first + 2)};
    mesh.add_face(face.data(), face.data() + 3);
  };
  add(-50, -50, 200);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) add(-0.4 + 0.02 * i, -0.4 + 0.02 * j, 0.02);
  Scene scene = testing::scene_of(Mesh::make(std::move(mesh)));
  scene.camera.position = {0, 0, 3};
  for (const int threads : {1, 2, 3, 7}) {
    const Frame f = draw(scene, {64, 64, threads, true, false});
    for (const std::int32_t triangle : f.triangle.pixels()) ASSERT_EQ(triangle, 0) << threads;
  }
}

TEST(Software, FewerTrianglesThanThreads) {
  const Scene scene = testing::scene_of(testing::triangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}));
  ASSERT_TRUE(draws_triangles_apart(1, 3, 3, 2));
  EXPECT_EQ(testing::covered(draw(scene, {3, 3, 2})), 9u);
  EXPECT_EQ(testing::covered(draw(scene, {2, 1, 7})), 2u);
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
