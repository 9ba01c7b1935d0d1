#include "ui/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app.h"
#include "ui/fill.h"
#include "ui/quiz.h"
#include "ui/recording.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// A child window with the palette's background, its padding kept, that never gets a size below 1.
template <class Draw>
void area(App& app, const char* id, ImVec2 at, ImVec2 size, ImU32 colour, ImVec2 padding, bool scrolls, Draw draw) {
  if (!(size.x >= 1) || !(size.y >= 1)) return;
  fill(ImGui::GetWindowDrawList(), at, {at.x + size.x, at.y + size.y}, colour);
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const ImGuiWindowFlags flags =
      scrolls ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const bool visible = ImGui::BeginChild(id, size, false, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (visible) {
    draw();
    if (scrolls && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::GetIO().MouseWheel != 0 &&
        ImGui::GetScrollMaxY() > 0 && !ImGui::IsAnyItemHovered())
      app.scrolled_at = app.now;
  }
  ImGui::EndChild();
}

// A strip between two areas that is dragged; `amount` is the size of one of them in units, growing with `sign`.
void splitter(App& app, const char* id, ImVec2 at, ImVec2 size, bool horizontal, double& amount, double sign,
              const Range& range) {
  if (!(size.x >= 1) || !(size.y >= 1)) return;
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton(id, size);
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  ImGui::SetMouseCursor(horizontal ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y},
                                            faded(app.look.palette.accent, ImGui::IsItemActive() ? 0.5f : 0.25f));
  if (!ImGui::IsItemActive()) return;
  const ImVec2 d = ImGui::GetIO().MouseDelta;
  const double next = amount + sign * double(horizontal ? d.x : d.y) / double(app.look.scale);
  if (range.contains(next)) amount = next;
}

const Range& range_of_setting(double Settings::*member) {
  static const Range none{0, 1};
  const Range* found = &none;
  std::apply(
      [&](const auto&... f) {
        auto one = [&](const auto& field) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field.member)>, double Settings::*>)
            if (field.member == member) found = &field.about.range;
        };
        (one(f), ...);
      },
      fields_of<Settings>);
  return *found;
}

// Where the window is too narrow for both, the equation and the listing lie one behind the other.
void draw_strip_tabs(App& app) {
  Settings& s = app.settings;
  const auto tab = [&](const char* id, const Words& label, bool code) {
    if (button(app, id, {.label = label.in(app.language()), .chosen = s.code_in_front == code, .quiet = true}))
      s.code_in_front = code;
  };
  tab("equation", {"Light model", "光源計算の式"}, false);
  ImGui::SameLine(0, app.look.px(4));
  tab("listing", {"Program", "プログラム"}, true);
}

constexpr float least_equation = 540, least_code = 330;  // units

bool both_below(const App& app, float width) { return width >= app.look.px(least_equation) + app.look.px(least_code); }

// Whether the right side goes down to the window's lower edge: where what stands below the pictures keeps the room that
// it wants; beside a text that is read, also where it keeps what it needs.
bool side_goes_down(const App& app, float width) {
  const Settings& s = app.settings;
  if (!s.code) return width >= app.look.px(least_equation);
  const bool reads = s.side == Side::lesson || s.side == Side::challenge || s.side == Side::trade ||
                     s.side == Side::extremes || s.side == Side::solver || s.side == Side::hemicube;
  return width >= app.look.px(least_equation) + app.look.px(reads ? least_code : float(s.code_width));
}

// Below everything: the equation, and the listing beside it.
void draw_below(App& app, ImVec2 at, ImVec2 size) {
  Look& look = app.look;
  Settings& s = app.settings;
  const ImU32 back = look.palette.panel;
  const ImVec2 padding{look.px(16), look.px(10)};
  if (!s.code) return area(app, "strip", at, size, back, padding, false, [&] { draw_strip(app); });
  if (!both_below(app, size.x))
    return area(app, s.code_in_front ? "code" : "strip", at, size, back, padding, false, [&] {
      draw_strip_tabs(app);
      s.code_in_front ? draw_code_panel(app) : draw_strip(app);
    });
  const float code = std::clamp(look.px(float(s.code_width)), look.px(least_code), size.x - look.px(least_equation));
  area(app, "strip", at, {size.x - code, size.y}, back, padding, false, [&] { draw_strip(app); });
  area(app, "code", {at.x + size.x - code, at.y}, {code, size.y}, back, {look.px(8), look.px(10)}, false,
       [&] { draw_code_panel(app); });
  const float gap = look.px(4);
  splitter(app, "code edge", {at.x + size.x - code - gap, at.y + gap}, {gap, size.y - gap}, true, s.code_width, -1,
           range_of_setting(&Settings::code_width));
}

void draw_areas(App& app, ImVec2 size, void (*middle)(App&, ImVec2)) {
  Look& look = app.look;
  const Palette& p = look.palette;
  Settings& s = app.settings;
  const float bar = look.px(48), gap = look.px(4), inner = look.px(8);
  // The pictures keep at least half of the window.
  const float left = std::min(look.px(float(s.left_width)), size.x * 0.4f);
  const float right = s.side == Side::none ? 0 : std::min(look.px(float(s.right_width)), size.x * 0.34f);
  const float below = right > 0 && side_goes_down(app, size.x - right) ? size.x - right - 1 : size.x;
  const bool tabs = s.code && !both_below(app, below);
  const double needed = app.probing.at ? (tabs ? 238 : 200) : 0;  // by the numbers of a pixel
  const float strip = std::min(look.px(float(std::max(s.strip_height, needed))), size.y * 0.4f);
  const float middle_h = size.y - bar - strip, middle_w = size.x - left - right;

  area(app, "bar", {0, 0}, {size.x, bar}, p.panel, {look.px(16), look.px(8)}, false, [&] { draw_top_bar(app); });
  area(app, "parameters", {0, bar + 1}, {left, middle_h - 1}, p.panel, {look.px(14), look.px(8)}, true,
       [&] { draw_parameters(app); });
  area(app, "view", {left, bar}, {middle_w, middle_h}, p.window, {inner, inner}, false, [&] {
    draw_view_bar(app);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    middle(app, {std::max(room.x, 0.0f), std::max(room.y, 0.0f)});
  });
  const float side_h = below < size.x ? size.y - bar - 1 : middle_h - 1;
  area(app, "side", {size.x - right, bar + 1}, {right, side_h}, p.panel, {look.px(14), look.px(10)}, true,
       [&] { draw_side_panel(app); });
  draw_recording_sign(app, {left + 0.5f * middle_w, bar + look.px(52)});
  draw_below(app, {0, bar + middle_h + 1}, {below, strip - 1});

  splitter(app, "left edge", {left - gap * 0.5f, bar}, {gap, middle_h}, true, s.left_width, 1,
           range_of_setting(&Settings::left_width));
  if (right > 0)
    splitter(app, "right edge", {size.x - right - gap * 0.5f, bar}, {gap, side_h}, true, s.right_width, -1,
             range_of_setting(&Settings::right_width));
  splitter(app, "strip edge", {0, bar + middle_h - gap * 0.5f}, {below, gap}, false, s.strip_height, -1,
           range_of_setting(&Settings::strip_height));
}

}  // namespace

void draw_window(App& app, ImVec2 size, void (*middle)(App&, ImVec2)) {
  if (!(size.x >= 1) || !(size.y >= 1)) return;
  keep_quiz(app);
  app.lit = app.lit_next;
  app.lit_next = Quantity::none;
  app.pointed = std::exchange(app.pointed_next, {});
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("shadebench", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (app.presenter.on)
    draw_presentation(app, size, middle);
  else
    draw_areas(app, size, middle);
  draw_dialogues(app);
  draw_help(app);
  ImGui::End();
  draw_toasts(app, size);
  if (app.lit != app.lit_next) app.animating = true;  // one more frame shows it
}

}  // namespace cg
