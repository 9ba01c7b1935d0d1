// What is drawn and counted behind the panel of the hemicube: asked for again where it must be, never waited for.
#include "ui/hemicube_desk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gl/hemicube_items.h"
#include "params/input_error.h"
#include "workbench/open.h"

namespace cg {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// As the window does it: a frame after the other until nothing more comes.
void settle(HemicubeDesk& desk, const Scene& scene, Settings& settings, const SolutionHandle& solution = nullptr) {
  for (int calm = 0; calm < 3;) {
    desk.update(scene, solution, settings);
    calm = desk.busy() ? 0 : calm + 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// Unit squares opposite each other, one patch each.
Scene squares() {
  Scene s = open_scene("models/parallel-squares.json");
  for (Object& object : s.objects) object.transform = {};
  s.radiosity.patch_size = 1, s.radiosity.resolution = 64, s.radiosity.samples = 1;
  return s;
}

TEST(HemicubeDesk, ThePointUnderAPlateAndTheSquaresBesideTheirClosedForms) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  settings.patch = 0;
  Scene scene = squares();
  settle(desk, scene, settings);
  ASSERT_TRUE(desk.state().pair && desk.state().pair->whole);
  const HemicubePair* pair = desk.state().pair.get();
  ASSERT_EQ(pair->other(), 1u);
  EXPECT_NEAR(pair->sight->of(1)->sum, 0.239456470461, 1e-4);
  EXPECT_TRUE(pair->point.exact());
  EXPECT_NEAR(pair->point.value, 0.239456470461, 1e-11);
  EXPECT_NEAR(pair->whole->known.value, 0.199824895698, 1e-11);
  EXPECT_NEAR(pair->whole->there, 0.2395, 2e-4);  // from the middle alone
  EXPECT_NEAR(pair->shadow.form_factor, pair->point.value, 1e-12);
  // More positions come near the closed form, and F_ji is there too.
  scene.radiosity.samples = 4;
  settle(desk, scene, settings);
  pair = desk.state().pair.get();
  ASSERT_TRUE(pair->whole);
  EXPECT_EQ(pair->sight->positions, 16u);
  EXPECT_NEAR(pair->whole->there, 0.199824895698, 3e-4);
  // Each of the two is off by what single factors are at this resolution, 8.3e-4 at most.
  EXPECT_LT(pair->whole->relative, 2 * 8.3e-4 / 0.1998);
  // A wrong weight keeps the sum and misses.
  scene.radiosity.weight = PixelWeight::unweighted;
  settle(desk, scene, settings);
  EXPECT_LT(desk.state().pair->whole->there, 0.12);
  EXPECT_NEAR(desk.state().pair->weighted[std::size_t(PixelWeight::unweighted)].item,
              desk.state().pair->sight->of(1)->sum, 1e-6);
}

TEST(HemicubeDesk, OnlyWhatAChangeTouchesIsMadeAgain) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  Scene scene = open_scene("models/cornell-box.json");
  scene.radiosity.patch_size = 0.25, scene.radiosity.resolution = 32;
  settle(desk, scene, settings);
  ASSERT_GE(settings.patch, 0) << "the middle of the picture was chosen";
  const HemicubeDesk::State first = desk.state();
  ASSERT_TRUE(first.sight && first.row);
  scene.camera.position.x += 0.3, scene.lights.emplace_back(), scene.radiosity.solver = RadiositySolver::jacobi;
  settle(desk, scene, settings);
  EXPECT_EQ(desk.state().sight, first.sight);
  EXPECT_EQ(desk.state().row, first.row);
  settings.hemicube = HemicubeShow::weights;
  settle(desk, scene, settings);
  EXPECT_NE(desk.state().sight, first.sight);
  EXPECT_EQ(desk.state().row, first.row);
  scene.radiosity.resolution = 64;
  settle(desk, scene, settings);
  EXPECT_NE(desk.state().row, first.row);
  EXPECT_EQ(desk.state().ground, first.ground);
  EXPECT_EQ(desk.state().sight->picture.width(), 128);
}

// Patches have other numbers when the scene is divided in another way: the one that is looked at stays where it is.
TEST(HemicubeDesk, ThePatchStaysWhereItIs) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  Scene scene = open_scene("models/cornell-box.json");
  scene.radiosity.patch_size = 0.25, scene.radiosity.resolution = 16;
  settings.patch = 17;
  settle(desk, scene, settings);
  ASSERT_EQ(settings.patch, 17);
  const Patch before = desk.state().ground->patches.patches[17];
  scene.radiosity.patch_size = 0.1;
  settle(desk, scene, settings);
  const Patch now = desk.state().ground->patches.patches[std::size_t(settings.patch)];
  EXPECT_EQ(now.object, before.object);
  EXPECT_LT(glm::distance(now.centre, before.centre), 0.25);
  // A lesson's step means its number.
  desk.forget_place();
  settings.patch = 3;
  scene.radiosity.patch_size = 0.3;
  settle(desk, scene, settings);
  EXPECT_EQ(settings.patch, 3);
  // Another scene: one of its own patches.
  scene = squares();
  settings.other_patch = 4000;
  settle(desk, scene, settings);
  EXPECT_LT(settings.patch, 2);
  EXPECT_EQ(settings.other_patch, -1);
}

TEST(HemicubeDesk, SolvedLightIsSeenWhereItIsOfTheseShapes) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  settings.hemicube = HemicubeShow::seen;
  Scene scene = open_scene("models/closed-cube.json");
  scene.radiosity.patch_size = 0.5, scene.radiosity.resolution = 16;
  settle(desk, scene, settings);
  EXPECT_FALSE(desk.state().sight->solved);
  Progress progress;
  const SolutionHandle solution = solve_radiosity(scene, scene.radiosity, nullptr, progress);
  settle(desk, scene, settings, solution);
  EXPECT_TRUE(desk.state().sight->solved);
  scene.radiosity.patch_size = 0.25;
  settle(desk, scene, settings, solution);
  EXPECT_FALSE(desk.state().sight->solved);
}

TEST(HemicubeDesk, SaysWhyThereAreNoPatches) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  Scene scene;
  settle(desk, scene, settings);
  ASSERT_TRUE(desk.state().message);
  EXPECT_FALSE(desk.state().message->ja.empty());
  EXPECT_FALSE(desk.state().ground);
  scene = squares();
  settle(desk, scene, settings);
  EXPECT_FALSE(desk.state().message);
  ASSERT_TRUE(desk.state().sight);
  // And again none: nothing of before is shown as if it were of this scene.
  scene.objects[0].visible = scene.objects[1].visible = false;
  settle(desk, scene, settings);
  EXPECT_TRUE(desk.state().message);
  EXPECT_FALSE(desk.current());
}

TEST(HemicubeDesk, WhatThePointerIsOnComesFirst) {
  HemicubeDesk desk(nullptr);
  Settings settings;
  settings.patch = 0;
  Scene scene = open_scene("models/closed-cube.json");
  scene.radiosity.patch_size = 0.5, scene.radiosity.resolution = 16;
  settle(desk, scene, settings);
  EXPECT_EQ(desk.item(settings), desk.state().row->by_size.front().patch);
  settings.other_patch = 9;
  EXPECT_EQ(desk.item(settings), 9u);
  desk.point_at(11);
  EXPECT_TRUE(desk.turn_pointed());
  EXPECT_EQ(desk.item(settings), 11u);
  EXPECT_TRUE(desk.turn_pointed());
  EXPECT_FALSE(desk.turn_pointed());
  EXPECT_EQ(desk.item(settings), 9u);
}

// However long rows take: asking costs nothing, a slider that moves sees its hemicube, and closing does not wait.
// As the scene asks: by OpenGL's item buffers, or by the software's where there are none.
TEST(HemicubeDesk, DrawsByOpenGl) {
  Scene scene = squares();
  scene.radiosity.samples = 2;
  Settings settings;
  settings.patch = 0;
  HemicubeDesk software(nullptr), both(nullptr, gl_draw_items());
  settle(software, scene, settings);
  scene.radiosity.item_buffer = ItemBuffer::gl;
  settle(both, scene, settings);
  ASSERT_FALSE(both.state().trouble);
  ASSERT_TRUE(both.state().row && both.state().pair && both.state().pair->whole);
  EXPECT_EQ(both.state().sight->options.item_buffer, ItemBuffer::gl);
  EXPECT_EQ(both.state().row->options.item_buffer, ItemBuffer::gl);
  EXPECT_NEAR(both.state().row->factor(1), software.state().row->factor(1), 1e-3);
  settle(software, scene, settings);
  EXPECT_EQ(software.state().sight->options.item_buffer, ItemBuffer::software);
}

// Where OpenGL cannot draw, it says why, and goes on when it is no more asked to.
TEST(HemicubeDesk, SaysWhyOpenGlDoesNotDraw) {
  const MakeDrawItems none = [](std::span<const ItemPolygon>) -> DrawItems {
    return [](const HemicubeFrame&, int, const std::vector<bool>&, ItemFaces&) {
      throw InputError("radiosity.item_buffer", {"there is no OpenGL", "OpenGL がない"}, {"software", "software"});
    };
  };
  Scene scene = squares();
  Settings settings;
  settings.patch = 0;
  HemicubeDesk desk(nullptr, none);
  scene.radiosity.item_buffer = ItemBuffer::gl;
  settle(desk, scene, settings);
  EXPECT_TRUE(desk.state().trouble);
  EXPECT_FALSE(desk.state().sight);
  scene.radiosity.item_buffer = ItemBuffer::software;
  settle(desk, scene, settings);
  EXPECT_FALSE(desk.state().trouble);
  EXPECT_TRUE(desk.state().sight && desk.state().row);
}

TEST(HemicubeDesk, NeverWaits) {
  Scene scene = open_scene("models/cornell-box.json");
  scene.radiosity.patch_size = 0.05, scene.radiosity.resolution = 1024, scene.radiosity.samples = 16;
  Settings settings;
  Clock::time_point closing;
  {
    HemicubeDesk desk(nullptr);
    const auto start = Clock::now();
    while (!desk.state().sight && ms_since(start) < 30000) {
      desk.update(scene, nullptr, settings);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(desk.state().sight);
    double most = 0;
    for (int i = 0; i < 100; ++i) {
      settings.patch = i;
      const auto asked = Clock::now();
      desk.update(scene, nullptr, settings);
      most = std::max(most, ms_since(asked));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_TRUE(desk.busy());
    EXPECT_LE(most, 16);
    closing = Clock::now();
  }
  EXPECT_LE(ms_since(closing), 2000);
}

}  // namespace
}  // namespace cg
