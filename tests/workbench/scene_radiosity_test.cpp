// What a scene's radiosity depends on, and what is kept when something else changes.
#include "workbench/scene_radiosity.h"

#include <gtest/gtest.h>

#include "tests/coarse_box.h"

namespace cg {
namespace {

SceneRadiosity solve(const Scene& scene, const SceneRadiosity& earlier = {}) {
  Progress progress;
  return solve_scene(scene, earlier, progress, 1);
}

TEST(SceneRadiosity, DependsOnShapesReflectanceAndEmission) {
  const Scene box = coarse_box();
  EXPECT_TRUE(wants_radiosity(box));
  const auto same = [&](auto edit) {
    Scene other = box;
    edit(other);
    return radiosity_inputs(other) == radiosity_inputs(box);
  };
  EXPECT_TRUE(same([](Scene& s) { s.camera.position = {0, 0.1, 2}; }));
  EXPECT_TRUE(same([](Scene& s) { s.lights[0].enabled = true, s.lights.emplace_back(); }));
  EXPECT_TRUE(same([](Scene& s) { s.shading.mode = ShadingMode::phong, s.shading.ambient = {1, 0, 0}; }));
  EXPECT_TRUE(same([](Scene& s) { s.display.exposure = 2, s.objects[0].material.k_s = {1, 1, 1}; }));
  EXPECT_FALSE(same([](Scene& s) { s.objects[0].material.k_d = {1, 0, 0}; }));
  EXPECT_FALSE(same([](Scene& s) { s.objects[0].material.emission = {1, 0, 0}; }));
  EXPECT_FALSE(same([](Scene& s) { s.objects[0].transform.translate.x += 0.1; }));
  EXPECT_FALSE(same([](Scene& s) { s.objects[1].visible = false; }));
  EXPECT_FALSE(same([](Scene& s) { s.radiosity.resolution = 32; }));
  // The scene's own material counts where an object has it, and there alone.
  EXPECT_TRUE(same([](Scene& s) { s.material.k_d = {1, 0, 0}; }));
  EXPECT_FALSE(same([](Scene& s) { s.objects[0].own_material = false; }));
}

TEST(SceneRadiosity, KeepsTheFormFactorsWhereTheShapesStay) {
  Scene box = coarse_box();
  const SceneRadiosity first = solve(box);
  ASSERT_TRUE(first.solution && first.field);
  EXPECT_EQ(first.field->objects.size(), box.objects.size());
  EXPECT_TRUE(first.solution->kept.empty());
  box.objects[0].material.k_d = {0.9, 0.1, 0.1};
  const SceneRadiosity second = solve(box, first);
  EXPECT_EQ(second.solution->matrix, first.solution->matrix);
  ASSERT_FALSE(second.solution->kept.empty());
  EXPECT_NE(report_of(*second.solution)[0].en.find("form factors"), std::string::npos);
  EXPECT_NE(second.field, first.field);
  box.objects[5].transform.translate.x += 0.01;
  const SceneRadiosity third = solve(box, second);
  EXPECT_NE(third.solution->matrix, first.solution->matrix);
  EXPECT_TRUE(third.solution->kept.empty());
}

TEST(SceneRadiosity, IsDrawnWhereTheObjectsStandAsItHasThem) {
  const Scene box = coarse_box();
  Scene other = box;
  other.camera.position.x += 1, other.objects[0].material.k_d = {1, 0, 0};
  EXPECT_TRUE(same_places(box, other));
  other.objects[0].transform.rotate.x = 1;
  EXPECT_FALSE(same_places(box, other));
  other = box;
  other.objects[1].visible = false;
  EXPECT_FALSE(same_places(box, other));
  other = box;
  other.objects.pop_back();
  EXPECT_FALSE(same_places(box, other));
}

}  // namespace
}  // namespace cg
