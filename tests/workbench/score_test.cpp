// The score of a challenge: known pictures, and hints that name what was changed.
#include "workbench/score.h"

#include <gtest/gtest.h>

#include "raster/software.h"
#include "workbench/challenge.h"
#include "workbench/model_library.h"
#include "workbench/scene_differences.h"

namespace cg {
namespace {

Score score_of(const Scene& student, const Scene& target, int threads = 1) {
  Progress progress;
  return score(student, target, software_technique(), progress, threads);
}

// A plane that fills nothing but itself, lit by the ambient light alone: its colour is I_a k_a exactly.
Scene ambient_plane(double k_a) {
  Scene s = open_model("uv-sphere");
  s.lights.clear();
  s.shading.ambient = glm::dvec3(1);
  s.material.k_a = glm::dvec3(k_a);
  return s;
}

TEST(Score, OfKnownPictures) {
  const Score same = score_of(ambient_plane(0.5), ambient_plane(0.5));
  EXPECT_EQ(same.rmse, 0);
  EXPECT_EQ(same.value, 100);
  EXPECT_FALSE(same.hint);
  // Every covered pixel is off by 0.1, 0.25 and 0.5 in each channel.
  for (const auto& [k_a, points] : {std::pair(0.6, 60.0), {0.25, 0.0}, {0.55, 80.0}, {1.0, 0.0}}) {
    const Score s = score_of(ambient_plane(k_a), ambient_plane(0.5));
    EXPECT_NEAR(s.rmse, std::abs(k_a - 0.5), 1e-6);
    EXPECT_NEAR(s.value, points, 1e-4);
    EXPECT_EQ(s.hint, HintKind::ambient);
    EXPECT_NEAR(s.off[std::size_t(HintKind::ambient)], s.rmse, 1e-9);
  }
}

TEST(Score, DoesNotDependOnThreads) {
  Scene a = open_model("teapot"), b = a;
  b.material.n = 10, b.lights[0].position.x = 3;
  const Score one = score_of(a, b, 1), two = score_of(a, b, 2);
  EXPECT_EQ(one.rmse, two.rmse);
  EXPECT_EQ(one.off, two.off);
}

TEST(Score, TheHintNamesWhatWasChanged) {
  const Scene target = open_model("teapot");
  const auto hint = [&](auto change) {
    Scene s = target;
    change(s);
    const Score result = score_of(s, target);
    EXPECT_GT(result.rmse, 0);
    int kinds = 0;
    for (const double off : result.off) kinds += off > 0;
    EXPECT_EQ(kinds, 1);
    return result.hint;
  };
  EXPECT_EQ(hint([](Scene& s) { s.material.k_a = glm::dvec3(0.9); }), HintKind::ambient);
  EXPECT_EQ(hint([](Scene& s) { s.shading.ambient = glm::dvec3(0.5); }), HintKind::ambient);
  EXPECT_EQ(hint([](Scene& s) { s.material.k_d = {0.8, 0.1, 0.1}; }), HintKind::diffuse);
  EXPECT_EQ(hint([](Scene& s) { s.lights[0].diffuse = glm::dvec3(0.5); }), HintKind::diffuse);
  EXPECT_EQ(hint([](Scene& s) { s.material.n = 5; }), HintKind::specular);
  EXPECT_EQ(hint([](Scene& s) { s.material.emission = {0.1, 0, 0}; }), HintKind::emission);
  EXPECT_EQ(hint([](Scene& s) { s.lights[0].position = {-10, 10, 10}; }), HintKind::light);
  EXPECT_EQ(hint([](Scene& s) { s.lights.push_back(s.lights[0]); }), HintKind::light);
  EXPECT_EQ(hint([](Scene& s) { s.lights.clear(); }), HintKind::light);
  EXPECT_EQ(hint([](Scene& s) { s.objects[0].transform.rotate.y = 40; }), HintKind::object);
  EXPECT_EQ(hint([](Scene& s) { s.camera.fov = 30; }), HintKind::camera);
  EXPECT_EQ(hint([](Scene& s) { s.shading.mode = ShadingMode::flat; }), HintKind::shading);
  EXPECT_EQ(hint([](Scene& s) { s.display.background = {0, 0, 0.5}; }), HintKind::display);
  EXPECT_EQ(hint([](Scene& s) { s = open_model("torus"); }), HintKind::object);
}

TEST(Score, OfTwoChangesTheLargerIsTheHint) {
  const Scene target = open_model("teapot");
  Scene s = target;
  s.material.n = 30, s.material.k_d = {0.1, 0.1, 0.8};
  EXPECT_EQ(score_of(s, target).hint, HintKind::diffuse);
  s.material.n = 1, s.material.k_d = {0.79, 0.8, 0.8};
  EXPECT_EQ(score_of(s, target).hint, HintKind::specular);
}

TEST(Score, AMaterialOfTheObjectIsTheSameAsTheScenes) {
  Scene a = open_model("teapot"), b = a;
  a.material.k_d = {1, 0, 0}, a.objects[0].own_material = true;
  EXPECT_EQ(score_of(a, b).value, 100);
}

TEST(Challenge, OffersExactlyWhatDiffers) {
  Scene target = open_model("teapot");
  target.material.k_d = {1, 0, 0}, target.shading.mode = ShadingMode::flat, target.camera.fov = 30;
  const Challenge c = challenge_of(target);
  EXPECT_EQ(c.target, target);
  EXPECT_EQ(c.offered, (std::vector<std::string>{"material.k_d", "shading.mode"}));
  EXPECT_EQ(c.start.camera.fov, 30);
}

TEST(Challenge, MadeUpFromASeed) {
  const Scene scene = open_model("torus");
  for (int level = 1; level <= 3; ++level) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Challenge c = made_up_challenge(scene, seed, level), again = made_up_challenge(scene, seed, level);
      EXPECT_EQ(c.target, again.target);
      EXPECT_FALSE(c.offered.empty());
      if (seed > 3) continue;
      const Score s = score_of(c.start, c.target);
      EXPECT_LT(s.value, 99) << seed;
      EXPECT_TRUE(s.hint);
    }
    EXPECT_NE(made_up_challenge(scene, 1, level).target, made_up_challenge(scene, 2, level).target);
  }
}

}  // namespace
}  // namespace cg
