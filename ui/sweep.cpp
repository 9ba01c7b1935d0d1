#include "ui/sweep.h"

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr double gone_after = 0.5;  // seconds without its row

ImGuiID row_id() { return ImGui::GetID("sweep"); }

void begin(App& app, ImGuiID row, double position) {
  app.history.end_gesture();  // a step of undo of its own
  app.sweep.item = row;
  app.sweep.position = std::clamp(position, 0.0, 1.0);
  app.sweep.direction = position >= 1 ? -1 : 1;
  app.sweep.seen = app.now;
}

void draw_mark(const Look& look, bool moves, bool hovered, ImVec2 at, ImVec2 size) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 c{std::floor(at.x + 0.5f * size.x), std::floor(at.y + 0.5f * size.y)};
  const ImU32 colour = moves || hovered ? look.palette.text : look.palette.dim;
  const float r = look.px(5);
  if (moves) {
    const float bar = std::max(1.0f, look.px(3)), gap = look.px(1.5f);
    draw->AddRectFilled({c.x - gap - bar, c.y - r}, {c.x - gap, c.y + r}, colour);
    draw->AddRectFilled({c.x + gap, c.y - r}, {c.x + gap + bar, c.y + r}, colour);
  } else {
    draw->AddTriangleFilled({c.x - r * 0.7f, c.y - r}, {c.x - r * 0.7f, c.y + r}, {c.x + r, c.y}, colour);
  }
}

void explain(App& app) {
  const Language l = app.language();
  const std::string seconds = number_text(app.settings.sweep_seconds, 0, 6) + " s";
  tooltip(
      app, {},
      Words{"Moves from end to end and back; a click or Esc stops it", "両端の間を往復する。クリックか Esc で止まる"}
          .in(l),
      (l == Language::japanese ? "片道 " + seconds + "（ホイールで変更）"
                               : seconds + " one way; the wheel changes it") +
          "\nSpace");
}

// The wheel on the button changes the pace.
void turn_pace(App& app) {
  double steps = 0;
  if (!wheel(app, steps) || steps == 0) return;
  constexpr double paces[] = {0.5, 1, 2, 3, 4, 6, 8, 12, 20, 30, 60};
  const double now = app.settings.sweep_seconds;
  const auto* at = std::lower_bound(std::begin(paces), std::end(paces), now);
  const std::ptrdiff_t next = std::clamp<std::ptrdiff_t>(at - paces + (steps > 0 ? -1 : 1), 0, std::ssize(paces) - 1);
  app.settings.sweep_seconds = paces[next];
}

double advance(App& app) {
  Sweep& s = app.sweep;
  s.seen = app.now;
  s.position += s.direction * double(ImGui::GetIO().DeltaTime) / std::max(app.settings.sweep_seconds, 0.1);
  if (s.position >= 1) s.position = 1, s.direction = -1;
  if (s.position <= 0) s.position = 0, s.direction = 1;
  app.animating = true;
  return s.position;
}

}  // namespace

std::optional<double> sweep_row(App& app, double position, bool hovered, ImVec2 at, ImVec2 size) {
  Sweep& s = app.sweep;
  const ImGuiID row = row_id();
  if (s.start && s.chosen == row) {
    s.start = false;
    begin(app, row, position);
  }
  const bool moves = s.item == row;
  if (hovered || moves || s.chosen == row) {
    ImGui::SetCursorScreenPos(at);
    const bool pressed = ImGui::InvisibleButton("sweep", size);
    note_place(app, "button", "sweep");
    draw_mark(app.look, moves, ImGui::IsItemHovered(), at, size);
    if (wants_tooltip(app)) explain(app);
    turn_pace(app);
    if (pressed && s.released != row && !moves) begin(app, row, position);
    if (pressed) s.chosen = row;
  }
  if (s.item != row) return {};
  return advance(app);
}

void choose_for_sweep(App& app) { app.sweep.chosen = row_id(); }

void stop_sweep(App& app) {
  app.sweep.item = 0;
  app.sweep.start = false;
}

void toggle_sweep(App& app) {
  if (app.sweep.item)
    stop_sweep(app);
  else
    app.sweep.start = app.sweep.chosen != 0;
}

void watch_sweep(App& app) {
  Sweep& s = app.sweep;
  const bool down = ImGui::IsMouseDown(0) || ImGui::IsMouseReleased(0);
  if (!down) s.released = 0;
  if (s.item && (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2))) {
    s.released = s.item;
    stop_sweep(app);
  }
  if (s.item && app.now - s.seen > gone_after) stop_sweep(app);
  if (s.start && app.now - s.seen > 2 * gone_after) s.start = false;  // its row is not on the screen
}

}  // namespace cg
