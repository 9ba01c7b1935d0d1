// Every parameter as a row, with values that no slider would give: ImGui aborts on some of them if it ever sees them.
#include <cmath>
#include <limits>
#include <set>

#include "tests/ui/imgui_fixture.h"
#include "ui/number.h"
#include "ui/parameter.h"
#include "ui/widgets.h"
#include "ui/window.h"
#include "workbench/open.h"

namespace cg {
namespace {

const double strange[] = {0.0,      -0.0,      1e-300, 1e30,
                          -1e30,    1e308,     5e-324, std::numeric_limits<double>::quiet_NaN(),
                          HUGE_VAL, -HUGE_VAL, 180,    1.0 / 3};

// Overwrites all numbers, past every check.
void set_all(const Slots& all, double v) {
  for (const Slot& slot : all) {
    if (auto p = std::get_if<double*>(&slot.value)) **p = v;
    if (auto p = std::get_if<glm::dvec3*>(&slot.value)) **p = glm::dvec3(v, -v, v * 0.5);
    if (auto p = std::get_if<int*>(&slot.value)) **p = v > 1e9 ? 2147483647 : v < -1e9 ? -2147483647 : 0;
  }
}

Scene rich_scene() {
  Scene scene;
  scene.objects.resize(2);
  scene.objects[0].model = "teapot";
  scene.objects[1].own_material = true;
  scene.lights.resize(3);
  scene.lights[1].kind = LightKind::spot;
  scene.lights[2].kind = LightKind::directional;
  return scene;
}

TEST_F(ImGuiTest, EveryParameterWithEveryStrangeValue) {
  for (double v : strange) {
    Scene scene = rich_scene();
    const Slots all = slots(scene);
    set_all(all, v);
    for (int i = 0; i < 2; ++i)
      frame([&] {
        for (const Slot& slot : all) parameter(app, slot);
      });
  }
}

TEST_F(ImGuiTest, TheWholeWindowWithStrangeValuesAndSizes) {
  for (ImVec2 size : {ImVec2{0, 0}, {1, 1}, {200, 100}, {320, 240}, {1280, 720}, {3840, 2160}, {16384, 50}}) {
    ImGui::GetIO().DisplaySize = size;
    for (double v : strange) {
      app.scene = rich_scene();
      set_all(slots(app.scene), v);
      app.figures = {true, v, v, -1, -1, v, v};
      app.settings.side = Side::mesh;
      window_frame();
    }
  }
}

TEST_F(ImGuiTest, DraggingASliderMovesItsValueAndResetBringsItBack) {
  Scene scene;
  const Slots all = slots(scene);
  const Slot& n = find_slot(all, "material.n");
  const auto draw = [&] { parameter(app, n); };
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {200, 25};
  frame(draw), frame(draw);
  io.MouseDown[0] = true;
  frame(draw);
  io.MousePos = {1000, 25};
  frame(draw);
  io.MouseDown[0] = false;
  frame(draw);
  EXPECT_GT(scene.material.n, 32);
  EXPECT_TRUE(n.about->accepts(scene.material.n));
  io.MousePos = {1265, 25};  // the arrow at the right end
  frame(draw), frame(draw);
  io.MouseDown[0] = true;
  frame(draw);
  io.MouseDown[0] = false;
  frame(draw);
  EXPECT_EQ(scene.material.n, 32);
}

// A slider of 1..16 stops at whole numbers, and nothing is refused on the way; a turn of the wheel is at least one.
TEST_F(ImGuiTest, WholeNumbersMoveByWholeNumbers) {
  Scene scene;
  const Slots all = slots(scene);
  for (const char* path :
       {"radiosity.samples", "radiosity.resolution", "radiosity.adaptive_levels", "radiosity.rays"}) {
    const Slot& slot = find_slot(all, path);
    const int& value = **std::get_if<int*>(&slot.value);
    const auto draw = [&] { parameter(app, slot); };
    ImGuiIO& io = ImGui::GetIO();
    const float y = slot.about->symbol.empty() ? 50.0f : 25.0f;
    io.MousePos = {100, y};
    frame(draw), frame(draw);
    io.MouseDown[0] = true;
    std::set<int> seen;
    for (float x = 100; x < 1000; x += 7) io.MousePos = {x, y}, frame(draw), seen.insert(value);
    io.MouseDown[0] = false;
    frame(draw);
    EXPECT_GT(seen.size(), 5u) << path;
    io.MousePos = {500, y};
    frame(draw);
    const int before = value;
    io.MouseWheel = -1;
    app.now += 1;
    frame(draw);
    io.MouseWheel = 0;
    EXPECT_LT(value, before) << path;
  }
  EXPECT_TRUE(app.toasts.empty());
}

TEST_F(ImGuiTest, WhatIsTypedIsCheckedByTheDescription) {
  Scene scene;
  const Slots all = slots(scene);
  const Slot& cutoff = find_slot(all, "lights.0.cutoff");
  const auto type = [&](const char* text) {
    ImGuiIO& io = ImGui::GetIO();
    const auto draw = [&] { parameter(app, cutoff); };
    io.MousePos = {1220, 45};  // on the number
    frame(draw), frame(draw);
    io.MouseDown[0] = true;
    frame(draw);
    io.MouseDown[0] = false;
    frame(draw), frame(draw), frame(draw);
    EXPECT_NE(app.editing.item, 0u);
    io.AddInputCharactersUTF8(text);
    frame(draw);
    io.KeysDown[GLFW_KEY_ENTER] = true;
    frame(draw);
    io.KeysDown[GLFW_KEY_ENTER] = false;
    frame(draw);
  };
  type("45.5");
  EXPECT_EQ(scene.lights[0].cutoff, 45.5);
  type("180");
  EXPECT_EQ(scene.lights[0].cutoff, 180);
  type("120");
  EXPECT_EQ(scene.lights[0].cutoff, 180);
  ASSERT_EQ(app.toasts.size(), 1u);
  EXPECT_TRUE(app.toasts[0].error);
}

TEST(FrameTime, IsOneThatWidgetsSurvive) {
  EXPECT_EQ(frame_time(0.02f), 0.02f);
  for (const double measured : strange) {
    const float t = frame_time(float(std::clamp(measured, -3e38, 3e38)));
    EXPECT_TRUE(t >= 1e-4f && t <= 0.25f) << measured;
  }
  EXPECT_EQ(frame_time(HUGE_VALF), 0.25f);
}

TEST(Number, IsExactWhereItFitsAndShortElsewhere) {
  EXPECT_EQ(number_text(0.2, 2), "0.20");
  EXPECT_EQ(number_text(10, 1), "10.0");
  EXPECT_EQ(number_text(0.123456, 2), "0.123456");
  EXPECT_EQ(number_text(1.0 / 3, 2).size(), 8u);
  EXPECT_EQ(number_text(1e30, 1), "1e+30");
  EXPECT_EQ(number_text(-1.2345678e-200, 1), "-1e-200");
  EXPECT_EQ(number_text(std::nan(""), 1), "NaN");
}

TEST(Number, SliderPositionsComeBack) {
  Scene scene;
  for (const Slot& slot : slots(scene)) {
    if (!std::holds_alternative<double*>(slot.value)) continue;
    for (double t : {0.0, 0.25, 0.5, 1.0}) {
      const double v = slider_value(*slot.about, t, true);
      EXPECT_TRUE(slot.about->accepts(v)) << slot.path;
      EXPECT_NEAR(slider_position(*slot.about, v), t, 0.01) << slot.path;
    }
    for (double v : strange) {
      const double p = slider_position(*slot.about, v);
      EXPECT_TRUE(p >= 0 && p <= 1) << slot.path << ' ' << v;
    }
  }
}

}  // namespace
}  // namespace cg
