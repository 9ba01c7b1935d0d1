// Clipping in homogeneous space.
#include "raster/clip.h"

#include <gtest/gtest.h>

#include <random>

#include "raster/drawing.h"
#include "tests/raster/pictures.h"

namespace cg {
namespace {

// Every piece lies in the view volume, and its vertices are the named mixtures of the source's.
TEST(Clip, PiecesLieInsideAndFollowTheirWeights) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-3, 3);
  const Viewport viewport(512, 512);
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<glm::vec4, 3> clip;
    for (glm::vec4& c : clip) c = {coordinate(random), coordinate(random), coordinate(random), coordinate(random)};
    std::vector<ClippedTriangle> pieces;
    clip_triangle(clip, 5, viewport, pieces);
    for (const ClippedTriangle& t : pieces) {
      EXPECT_EQ(t.source, 5u);
      for (std::size_t k = 0; k < 3; ++k) {
        const WindowVertex& v = t.vertices[k];
        EXPECT_TRUE(v.x >= -0.01f && v.x <= 512.01f && v.y >= -0.01f && v.y <= 512.01f) << v.x << ' ' << v.y;
        EXPECT_TRUE(v.z >= -1e-4f && v.z <= 1.0001f) << v.z;
        const glm::vec3 w = t.weights[k];
        EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-5);
        const glm::vec4 c = w.x * clip[0] + w.y * clip[1] + w.z * clip[2];
        EXPECT_TRUE(c.w < 0.05f || std::abs((c.x / c.w * 0.5f + 0.5f) * 512 - v.x) < 0.05f);
      }
    }
  }
}

// A triangle that holds the whole view volume's cross-section covers every pixel, and one behind the eye none.
TEST(Clip, AroundTheEye) {
  Scene scene = testing::scene_of(testing::triangle({-1e4, -1e4, -5}, {1e4, -1e4, -5}, {0, 2e4, -5}));
  scene.camera.position = {0, 0, 0};
  scene.camera.target = {0, 0, -1};
  EXPECT_EQ(testing::covered(testing::draw(scene, {64, 48})), 64u * 48u);
  scene.camera.target = {0, 0, 1};
  EXPECT_EQ(testing::covered(testing::draw(scene, {64, 48})), 0u);
}

// A floor that runs from behind the eye to the horizon covers exactly the lower half of the picture.
TEST(Clip, FloorUpToTheHorizon) {
  Scene scene = testing::scene_of(testing::triangle({-1e6, -1, 10}, {1e6, -1, 10}, {0, -1, -1e6}));
  scene.camera.position = {0, 0, 0};
  scene.camera.target = {0, 0, -1};
  scene.camera.far_plane = 1e5;
  const Frame f = testing::draw(scene, {64, 64});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(f.covered.at(x, y), y >= 32) << x << ' ' << y;
}

// Threads clip parts of a mesh, and the pieces stand in the order of the mesh all the same: of its first and of its
// last triangles there are some, and the lists are equal.
TEST(Clip, PiecesStandInTheMeshsOrderForAnyNumberOfThreads) {
  Scene scene = testing::scene_of(testing::torus(300, 100));
  scene.camera.position = {0.9, 0.2, 0.5};
  Progress progress;
  Workers alone(1, progress);
  const Drawing one = drawing_of(scene, {64, 64}, alone);
  const std::vector<ClippedTriangle>& expected = one.objects[0].clipped;
  ASSERT_LT(expected.front().source, 16384u);
  ASSERT_GT(expected.back().source, 2u * 16384u);
  for (const int threads : {2, 3, 7}) {
    Workers workers(threads, progress);
    const Drawing drawing = drawing_of(scene, {64, 64}, workers);
    const std::vector<ClippedTriangle>& pieces = drawing.objects[0].clipped;
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i].source, expected[i].source) << threads;
      EXPECT_EQ(pieces[i].weights, expected[i].weights) << threads;
    }
  }
}

}  // namespace
}  // namespace cg
