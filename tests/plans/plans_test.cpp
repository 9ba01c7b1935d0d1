// What really ran is what was planned: no pass more, none less, and the bytes that it held are the plan's. Every step
// of every lesson, the extreme scenes and odd ones, in every technique.
#include <gtest/gtest.h>

#include "measure/extreme.h"
#include "tests/all_techniques.h"
#include "tests/plans/plan_scenes.h"
#include "workbench/lesson.h"
#include "workbench/measured_plan.h"

namespace cg {
namespace {

class Plans : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const auto& why = technique().unavailable) GTEST_SKIP() << why->en;
  }
  const Technique& technique() const { return find(all_techniques(), GetParam()); }

  void check(const Scene& scene, const View& view) {
    if (technique().unsupported(scene)) return;
    const Plan plan = technique().plan(scene, view);
    Progress progress;
    const Frame frame = technique().render(scene, plan, view, progress);
    for (const Text& d : differences(plan, frame)) ADD_FAILURE() << d.en;
    for (const PassRun& run : frame.passes) EXPECT_TRUE(run.cpu_ms >= 0 && run.cpu_ms < 1e6) << run.id;
    for (const Pass& pass : plan.passes) {
      EXPECT_FALSE(pass.reason.en.empty() || pass.reason.ja.empty()) << pass.id;
      EXPECT_TRUE(pass.needed || pass.bytes == 0) << pass.id;
    }
    ++checked_;
  }

  void check_all(Scene scene) {
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
      for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
        if (precision == Precision::single_precision && technique().id != "software") continue;
        scene.shading.mode = mode, scene.shading.precision = precision;
        SCOPED_TRACE(std::string(names_of<ShadingMode>[std::size_t(mode)].id));
        check(scene, view_of(48, 32));
        check(scene, view_of(33, 47, true));
      }
  }

  int checked_ = 0;
};

TEST_P(Plans, OfEveryLessonStep) {
  for (const std::filesystem::path& folder : lesson_folders(std::filesystem::path(SHADEBENCH_SOURCE_DIR) / "lessons")) {
    const Lesson lesson = read_lesson(folder);
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      SCOPED_TRACE(lesson.id + ":" + std::to_string(step + 1));
      const Scene scene = scene_of_step(lesson, step);
      View view = view_of(160, 120);
      check(scene, view);
      view.threads = 2;
      check(scene, view);
    }
  }
  EXPECT_GT(checked_, 20);
}

TEST_P(Plans, OfOddScenes) {
  for (const OddScene& odd : odd_scenes()) {
    SCOPED_TRACE(odd.name);
    Scene scene = full_scene();
    odd.change(scene);
    check_all(scene);
  }
}

TEST_P(Plans, OfTheExtremes) {
  for (const ExtremeCase& c : extreme_cases()) {
    if (!c.scene) continue;
    SCOPED_TRACE(c.id);
    check_all(c.scene->make());
  }
}

TEST_P(Plans, OfPicturesOfAnySize) {
  for (const auto& [width, height] : {std::pair(0, 0), {0, 5}, {1, 1}, {7, 1}, {1, 9}, {9, 8}, {65, 17}, {64, 64}})
    for (const bool all : {false, true}) check(full_scene(), view_of(width, height, all));
}

TEST_P(Plans, OfSeveralSamplesAPixel) {
  for (const int samples : {2, 4, 1}) {
    View view = view_of(40, 30);
    view.samples = samples;
    if (technique().most_samples && technique().most_samples() < samples) continue;
    check(full_scene(), view);
    view.ids = true;
    check(full_scene(), view);
  }
}

// A smaller scene after a larger one: nothing of the larger one is held.
TEST_P(Plans, WhatIsNotNeededAnyMoreIsGivenBack) {
  for (int i = 0; i < 2; ++i) {
    check(full_scene(), view_of(128, 128, true));
    check(plain_scene(), view_of(16, 16));
  }
}

// A scene that uses everything leaves no line of a plan out but those that exclude each other.
TEST_P(Plans, TheFullSceneUsesEverything) {
  std::vector<std::string> unused;
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
    Scene scene = full_scene_with_radiosity();
    scene.shading.mode = mode;
    if (technique().id != "gl-fixed") add_textures(scene);  // which has those of the lit colour alone
    scene.shading.color_material = ColorMaterial::ambient_and_diffuse;
    scene.mistakes.flipped_normals = mode == ShadingMode::flat;
    if (technique().unsupported(scene)) continue;
    View view = view_of(64, 64, true);
    view.threads = 2;
    const Plan plan = technique().plan(scene, view);
    if (unused.empty())
      for (const Pass& pass : plan.passes) unused.push_back(pass.id);
    view.ids = view.normals = false, view.samples = 4;
    const Plan several = technique().plan(scene, view);
    std::erase_if(unused, [&](const std::string& id) { return plan.runs(id) || several.runs(id); });
  }
  if (technique().id == "gl-fixed") std::erase(unused, "pixel-lighting");
  for (const std::string& id : unused) ADD_FAILURE() << id;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Plans, testing::Values("software", "gl", "gl-fixed"), [](const auto& id) {
  return std::string(id.param) == "gl-fixed" ? std::string("gl_fixed") : std::string(id.param);
});

// What is kept is said, and the picture is the same as one that was drawn anew.
TEST(Reuse, OnlyLightAndMaterialLeaveTheTrianglesWhereTheyAre) {
  const Technique kept = software_technique(), fresh = software_technique();
  const auto draw_both = [&](const Scene& scene, View view) {
    Progress progress;
    view.reuse = true;
    const Frame a = kept.render(scene, kept.plan(scene, view), view, progress);
    view.reuse = false;
    const Frame b = fresh.render(scene, fresh.plan(scene, view), view, progress);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_TRUE(differences(kept.plan(scene, view), a).empty());
    for (const PassRun& run : b.passes) EXPECT_FALSE(run.kept && run.id != "surfaces") << run.id;
    for (const PassRun& run : a.passes)
      if (run.id == "visibility") return run.kept;
    return false;
  };
  Scene scene = full_scene();
  scene.shading.transparency = Transparency::opaque;  // with holes, what is seen depends on the pictures
  const View view = view_of(64, 48);
  EXPECT_FALSE(draw_both(scene, view));
  EXPECT_TRUE(draw_both(scene, view));
  scene.lights[1].position = {3, 3, 3}, scene.material.k_d = {1, 0, 0};
  EXPECT_TRUE(draw_both(scene, view));
  scene.shading.mode = ShadingMode::phong, scene.shading.precision = Precision::single_precision;
  EXPECT_TRUE(draw_both(scene, view));
  scene.camera.position.x += 0.1;
  EXPECT_FALSE(draw_both(scene, view));
  EXPECT_TRUE(draw_both(scene, view));
  scene.objects[1].transform.rotate.y = 5;
  EXPECT_FALSE(draw_both(scene, view));
  EXPECT_FALSE(draw_both(scene, view_of(64, 49)));
  scene.shading.mode = ShadingMode::flat;  // faces have their own vertices
  EXPECT_FALSE(draw_both(scene, view_of(64, 49)));
  scene.objects.pop_back();
  EXPECT_FALSE(draw_both(scene, view_of(64, 49)));
  // Whoever does not ask for it gets a whole picture, whatever was there before.
  Progress progress;
  const Frame whole = kept.render(scene, kept.plan(scene, view_of(64, 49)), view_of(64, 49), progress);
  for (const PassRun& run : whole.passes) EXPECT_FALSE(run.kept && run.id != "surfaces") << run.id;
}

TEST(Differences, AreFound) {
  Plan plan;
  plan.passes = {{.id = "a", .name = {}, .needed = true, .reason = {}, .bytes = 3},
                 {.id = "b", .name = {}, .needed = true, .reason = {}},
                 {.id = "c", .name = {}, .needed = false, .reason = {}}};
  plan.code = {"X"};
  Frame frame;
  frame.passes = {{"a", 0, 3, false}, {"b", 0, 0, false}};
  frame.code = {{"X", 0, false}};
  EXPECT_TRUE(differences(plan, frame).empty());
  frame.passes[0].bytes = 4;
  EXPECT_EQ(differences(plan, frame).size(), 1u);
  plan.passes[0].bytes_open = true;
  EXPECT_EQ(differences(plan, frame).size(), 0u);
  frame.passes[1].id = "c";  // ran though it was left out, and what was needed did not run
  EXPECT_EQ(differences(plan, frame).size(), 2u);
  frame.code[0].parts = "Y";
  EXPECT_EQ(differences(plan, frame).size(), 4u);
}

}  // namespace
}  // namespace cg
