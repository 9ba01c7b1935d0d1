// Random clicks, drags, wheel turns and keys on the whole window: nothing aborts, and the scene never holds a value
// that its description does not accept.
#include <filesystem>
#include <random>

#include "params/slots.h"
#include "tests/temporary_folder.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "workbench/open.h"

namespace cg {
namespace {

bool all_accepted(Scene& scene) {
  for (const Slot& slot : slots(scene)) {
    if (auto p = std::get_if<double*>(&slot.value); p && !slot.about->accepts(**p)) return false;
    if (auto p = std::get_if<glm::dvec3*>(&slot.value))
      for (int i = 0; i < 3; ++i)
        if (!slot.about->accepts((**p)[i])) return false;
    if (auto p = std::get_if<int*>(&slot.value); p && !slot.about->accepts(double(**p))) return false;
  }
  return true;
}

TEST_F(ImGuiTest, AMonkeyAtTheWindow) {
  const std::filesystem::path home = std::filesystem::current_path();
  const TemporaryFolder cage;
  std::filesystem::current_path(cage.path());  // what it saves, it saves here
  app.scene = open_scene("cube");
  app.history.restart(app.scene);
  std::mt19937 random(20240607);
  const auto dice = [&](int n) { return int(random() % unsigned(n)); };
  ImGuiIO& io = ImGui::GetIO();
  constexpr int keys[] = {GLFW_KEY_ENTER,     GLFW_KEY_TAB,     GLFW_KEY_ESCAPE, GLFW_KEY_BACKSPACE, GLFW_KEY_F1,
                          GLFW_KEY_L,         GLFW_KEY_D,       GLFW_KEY_1,      GLFW_KEY_3,         GLFW_KEY_P,
                          GLFW_KEY_M,         GLFW_KEY_Z,       GLFW_KEY_K,      GLFW_KEY_A,         GLFW_KEY_X,
                          GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_UP, GLFW_KEY_SPACE,  GLFW_KEY_B,         GLFW_KEY_F5,
                          GLFW_KEY_H,         GLFW_KEY_S};
  for (int i = 0; i < 6000; ++i) {
    if (dice(3) == 0) io.MousePos = {float(dice(1280)), float(dice(720))};
    if (dice(4) == 0) io.MousePos = {float(dice(320)), float(dice(720))};
    if (dice(3) == 0) io.MouseDown[0] = !io.MouseDown[0];
    io.MouseWheel = dice(6) == 0 ? float(dice(7) - 3) : 0;
    io.KeyShift = dice(5) == 0;
    for (int key : keys) io.KeysDown[key] = dice(60) == 0;
    if (dice(10) == 0) io.AddInputCharacter("0123456789.-e,nanインフ"[dice(20)]);
    if (dice(400) == 0) io.DisplaySize = {float(1 + dice(2000)), float(1 + dice(1200))};
    if (dice(100) == 0) io.DisplaySize = {1280, 720};
    io.KeyCtrl = false;
    std::vector<KeyPress> pressed;
    for (int key : keys)
      if (io.KeysDown[key]) pressed.push_back({key, false, io.KeyShift, false, dice(2) == 0});
    handle_keys(app, pressed);
    app.errands->finish(app);
    window_frame();
    ASSERT_TRUE(all_accepted(app.scene)) << "frame " << i;
  }
  while (app.errands->busy()) std::this_thread::yield();
  std::filesystem::current_path(home);
}

}  // namespace
}  // namespace cg
