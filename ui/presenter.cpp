#include "ui/presenter.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/fill.h"
#include "ui/layout.h"
#include "ui/lesson_panel.h"
#include "ui/lesson_player.h"
#include "ui/recording.h"

namespace cg {
namespace {

// Running text of 17 units is then 1/36 of the screen's height, what a lecture hall's last row still reads.
constexpr double units_in_height = 620;

long overlap(GLFWmonitor* monitor, int x, int y, int w, int h) {
  int mx = 0, my = 0;
  glfwGetMonitorPos(monitor, &mx, &my);
  const GLFWvidmode* mode = glfwGetVideoMode(monitor);
  if (!mode) return 0;
  const long wide = std::min(x + w, mx + mode->width) - std::max(x, mx);
  const long high = std::min(y + h, my + mode->height) - std::max(y, my);
  return wide > 0 && high > 0 ? wide * high : 0;
}

// The monitor that shows the most of the window.
GLFWmonitor* monitor_of(int x, int y, int w, int h) {
  int count = 0;
  GLFWmonitor** all = glfwGetMonitors(&count);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  for (int i = 0; i < count; ++i)
    if (overlap(all[i], x, y, w, h) > overlap(best, x, y, w, h)) best = all[i];
  return best;
}

// A part of the presentation with a background of its own.
template <class Draw>
void area(App& app, const char* id, ImVec2 at, ImVec2 size, ImU32 colour, ImVec2 padding, Draw draw) {
  if (!(size.x >= 1) || !(size.y >= 1)) return;
  fill(ImGui::GetWindowDrawList(), at, {at.x + size.x, at.y + size.y}, colour);
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool visible = ImGui::BeginChild(
      id, size, false,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (visible) draw(app);
  ImGui::EndChild();
}

// The panels whose state is drawn in the pictures are presented too, in place of the lesson's text.
bool presents_panel(const App& app) { return app.settings.side == Side::solver || app.settings.side == Side::hemicube; }

void draw_panel(App& app) {
  lessons_of(app).reading = {};  // no text to be turned before the next step
  if (ImGui::BeginChild("presented panel", {0, 0}))
    app.settings.side == Side::solver ? draw_solver_panel(app) : draw_hemicube_panel(app);
  ImGui::EndChild();
}

void draw_lesson(App& app) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (lessons_of(app).is_open()) {
    draw_lesson_place(app, at, ImGui::GetContentRegionAvail().x);
    ImGui::SetCursorScreenPos({at.x, at.y + app.look.px(36)});
  }
  presents_panel(app) ? draw_panel(app) : draw_lesson_step(app, true);
}

}  // namespace

bool presenter_takes(App& app, const KeyPress& key) {
  Presenter& p = app.presenter;
  if (!p.on || key.ctrl || key.other) return false;
  switch (key.key) {
    case GLFW_KEY_B:
    case GLFW_KEY_PERIOD:  // what a clicker's black button sends
      p.black = !p.black;
      return true;
    case GLFW_KEY_ESCAPE:
      if (p.black)
        p.black = false;
      else if (app.sweep.item)
        stop_sweep(app);
      else
        p.on = false;
      return true;
    case GLFW_KEY_PAGE_DOWN:
    case GLFW_KEY_PAGE_UP:
      p.black = false;
      return false;
    default:
      return p.black;
  }
}

void fit_presenter(App& app, GLFWwindow* window) {
  Presenter& p = app.presenter;
  int w = 0, h = 0;
  if (p.on != p.full) {
    p.full = p.on;
    p.black = false;
    if (p.on) {
      glfwGetWindowPos(window, &p.x, &p.y);
      glfwGetWindowSize(window, &p.width, &p.height);
      GLFWmonitor* monitor = monitor_of(p.x, p.y, p.width, p.height);
      if (const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr)
        glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
      glfwSetWindowMonitor(window, nullptr, p.x, p.y, std::max(p.width, 1), std::max(p.height, 1), GLFW_DONT_CARE);
    }
    app.animating = true;
  }
  if (!p.on) return;
  glfwGetFramebufferSize(window, &w, &h);
  p.scale = std::clamp(std::round(20.0 * std::min(h, w * 3 / 4) / units_in_height) / 20, 0.5, 6.0);
}

void draw_presentation(App& app, ImVec2 size, void (*middle)(App&, ImVec2)) {
  const Palette& palette = app.look.palette;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (app.presenter.black) {
    draw->AddRectFilled({0, 0}, size, IM_COL32(0, 0, 0, 255));
    ImGui::SetMouseCursor(ImGuiMouseCursor_None);
    return;
  }
  LessonPlayer& player = lessons_of(app);
  const float strip = std::min(app.look.px(132), size.y * 0.25f), inner = app.look.px(10);
  const float text = player.is_open() || presents_panel(app) ? std::floor(size.x * 0.38f) : 0;
  const ImVec2 margin{app.look.px(20), app.look.px(14)};
  area(app, "presented pictures", {0, 0}, {size.x - text, size.y - strip}, palette.window, {inner, inner}, [&](App& a) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    middle(a, {std::max(room.x, 0.0f), std::max(room.y, 0.0f)});
  });
  area(app, "presented lesson", {size.x - text, 0}, {text, size.y}, palette.panel, margin, draw_lesson);
  area(app, "presented equation", {0, size.y - strip}, {size.x - text, strip}, palette.panel, margin, draw_strip);
  draw_recording_sign(app, {0.5f * (size.x - text), app.look.px(14)});
}

}  // namespace cg
