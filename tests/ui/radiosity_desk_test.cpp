// The solution of the scene in the window: what is asked for again, what is drawn meanwhile, and that nothing waits.
#include "ui/radiosity_desk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/coarse_box.h"

namespace cg {
namespace {

void settle(const RadiosityDesk& desk) {
  while (desk.state().busy) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

TEST(RadiosityDesk, SolvesOnceAndAgainWhereLightOrShapesChange) {
  RadiosityDesk desk(nullptr);
  Scene scene = coarse_box();
  EXPECT_EQ(desk.update(scene), nullptr);
  settle(desk);
  const RadiosityHandle first = desk.update(scene);
  ASSERT_NE(first, nullptr);
  EXPECT_FALSE(desk.state().busy);
  scene.camera.position.x += 0.5, scene.lights.emplace_back();
  EXPECT_EQ(desk.update(scene), first);
  EXPECT_FALSE(desk.state().busy);
  // Another reflectance: the light of before is drawn until the new one is there, its form factors are kept.
  scene.objects[0].material.k_d = {0.9, 0.1, 0.1};
  EXPECT_EQ(desk.update(scene), first);
  settle(desk);
  const RadiosityHandle second = desk.update(scene);
  EXPECT_NE(second, first);
  EXPECT_FALSE(desk.state().newest.solution->kept.empty());
  // Another shape: there is no light for it yet.
  scene.objects[5].transform.translate.x += 0.05;
  EXPECT_EQ(desk.update(scene), nullptr);
  settle(desk);
  EXPECT_NE(desk.update(scene), nullptr);
  scene.shading.ambient_source = AmbientSource::constant;
  EXPECT_EQ(desk.update(scene), nullptr);
}

TEST(RadiosityDesk, SaysWhyThereIsNone) {
  RadiosityDesk desk(nullptr);
  Scene scene = coarse_box();
  scene.objects[0].material.k_d = {1.5, 1.5, 1.5};
  desk.update(scene);
  settle(desk);
  EXPECT_EQ(desk.update(scene), nullptr);
  ASSERT_TRUE(desk.state().message);
  EXPECT_FALSE(desk.state().message->ja.empty());
}

// However long the form factors take: asking costs nothing, and closing the window does not wait for them.
TEST(RadiosityDesk, NeverWaits) {
  using Clock = std::chrono::steady_clock;
  const auto ms = [](Clock::time_point since) {
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
  };
  Scene scene = coarse_box();
  scene.radiosity.patch_size = 0.02, scene.radiosity.resolution = 512;
  Clock::time_point closing;
  {
    RadiosityDesk desk(nullptr);
    desk.update(scene);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    double most = 0;
    for (int i = 0; i < 20; ++i) {
      scene.camera.position.x += 0.01;
      const auto asked = Clock::now();
      desk.update(scene);
      desk.state();
      most = std::max(most, ms(asked));
    }
    EXPECT_TRUE(desk.state().busy);
    EXPECT_LE(most, 16);
    closing = Clock::now();
  }
  EXPECT_LE(ms(closing), 2000);
}

}  // namespace
}  // namespace cg
