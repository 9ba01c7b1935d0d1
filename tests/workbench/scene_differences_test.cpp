// What differs between two scenes, and in which order it is told.
#include "workbench/scene_differences.h"

#include <gtest/gtest.h>

#include <random>

#include "params/slots.h"
#include "tests/workbench/random_scene.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

TEST(SceneDifferences, NoneOfEqualScenes) {
  const Scene s = open_model("teapot");
  EXPECT_TRUE(scene_differences(s, s).empty());
  Scene t = s;
  t.material.k_r.x = -0.0;  // no one sees the sign of a zero
  EXPECT_TRUE(scene_differences(s, t).empty());
}

TEST(SceneDifferences, InTheOrderOfSlots) {
  const Scene a = open_model("teapot");
  Scene b = a;
  b.shading.mode = ShadingMode::flat, b.material.n = 64, b.lights[0].position.x = -10.5;
  b.objects[0].transform.scale.y = 2;
  b.lights.resize(3);
  b.lights[2].kind = LightKind::spot;
  std::string en, ja;
  for (const ParameterDifference& d : scene_differences(a, b)) en += text_of(d).en + "\n", ja += text_of(d).ja + "\n";
  EXPECT_EQ(en,
            "objects.0.transform.scale [1,1,1] → [1,2,1]\n"
            "material.n 32 → 64\n"
            "lights.0.position [10,10,10] → [-10.5,10,10]\n"
            "lights.1 none → added\n"
            "lights.2 none → added\n"
            "shading.mode gouraud → flat\n");
  EXPECT_NE(ja.find("lights.2 なし → あり\n"), ja.npos);
  const auto back = scene_differences(b, a);
  EXPECT_EQ(text_of(back[3]).en, "lights.1 present → removed");
  EXPECT_EQ(to_json(back[4].a, 0), "{\"kind\":\"spot\"}");
  EXPECT_TRUE(back[4].b.is_null());
}

// Assigning each difference to a gives b: nothing is missed.
TEST(SceneDifferences, AreAllThereIs) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    Scene a = random_scene(random);
    Scene b = a;
    const Slots now = slots(b);
    for (int k = 0; k < 5; ++k) randomize(random, now[random() % now.size()]);
    for (const ParameterDifference& d : scene_differences(a, b)) {
      const Slots all = slots(a);
      const Slot& slot = find_slot(all, d.path);
      EXPECT_EQ(slot_tree(slot), d.a);
      EXPECT_EQ(slot.about, d.about);
      assign(slot, d.b);
    }
    EXPECT_EQ(a, b);
  }
}

}  // namespace
}  // namespace cg
