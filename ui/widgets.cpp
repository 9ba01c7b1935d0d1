#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "math/transform.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/formula_words.h"
#include "ui/rich_text.h"

namespace cg {
namespace {

// The baseline that centres the letters of `font` in a line of height `h` from `top`.
float centred_baseline(ImFont* font, float top, float h) {
  return std::floor(top + 0.5f * (h - font->FontSize) + font->Ascent);
}

// An arrow head that points down, or to the right.
void chevron(ImDrawList* draw, ImVec2 c, float r, bool down, ImU32 colour, float thickness) {
  const std::array<ImVec2, 3> points =
      down ? std::array<ImVec2, 3>{{{c.x - r, c.y - r * 0.5f}, {c.x, c.y + r * 0.5f}, {c.x + r, c.y - r * 0.5f}}}
           : std::array<ImVec2, 3>{{{c.x - r * 0.5f, c.y - r}, {c.x + r * 0.5f, c.y}, {c.x - r * 0.5f, c.y + r}}};
  draw->AddPolyline(points.data(), int(points.size()), colour, 0, thickness);
}

}  // namespace

bool begin_list(App& app, const char* id, const char* shown, float width) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(std::max(1.0f, width));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {look.px(11), std::max(0.0f, 0.5f * (look.px(32) - look.fonts.text->FontSize))});
  const bool open = ImGui::BeginCombo(id, "", ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
  ImGui::PopStyleVar();
  if (open) return true;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float text_end = at.x + width - look.px(24);
  draw->PushClipRect(at, {std::max(at.x, text_end), at.y + look.px(32)}, true);
  set_text(draw, look.fonts.text, {at.x + look.px(11), centred_baseline(look.fonts.text, at.y, look.px(32))},
           look.palette.text, shown);
  draw->PopClipRect();
  chevron(draw, {at.x + width - look.px(14), at.y + look.px(16)}, look.px(4), true, look.palette.dim, look.px(1.5f));
  return false;
}

void heading(App& app, std::string_view text) {
  Look& look = app.look;
  ImFont* font = look.fonts.small;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = look.px(24);
  set_text(ImGui::GetWindowDrawList(), font, {at.x, centred_baseline(font, at.y, h)}, look.palette.dim,
           noted(app, text));
  ImGui::Dummy({1, h - ImGui::GetStyle().ItemSpacing.y});
}

bool section(App& app, const char* id, const Words& title, bool open_at_first) {
  Look& look = app.look;
  ImGui::PushID(id);
  const ImGuiID key = ImGui::GetID("open");
  ImGuiStorage* store = ImGui::GetStateStorage();
  bool open = store->GetBool(key, open_at_first);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float w = std::max(1.0f, ImGui::GetContentRegionAvail().x), h = look.px(30);
  if (ImGui::InvisibleButton("fold", {w, h})) store->SetBool(key, open = !open);
  const ImU32 colour = ImGui::IsItemHovered() ? look.palette.text : look.palette.dim;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  chevron(draw, {at.x + w - look.px(9), at.y + h * 0.5f}, look.px(3.5f), open, colour, look.px(1.5f));
  set_text(draw, look.fonts.small, {at.x, centred_baseline(look.fonts.small, at.y, h)}, colour, noted(app, title));
  ImGui::PopID();
  return open;
}

float button_width(const App& app, std::string_view label) {
  return text_width(app.look.fonts.text, label) + 2 * app.look.px(11);
}

bool button(App& app, const char* id, const Press& press) {
  Look& look = app.look;
  const std::string_view label = noted(app, press.label);
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{button_width(app, label), look.px(32)};
  const bool pressed = ImGui::InvisibleButton(id, size) && press.enabled;
  note_place(app, "button", label);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 face = press.chosen               ? look.palette.accent
                     : hovered && press.enabled ? look.palette.raised_hover
                     : press.quiet              ? 0
                                                : look.palette.raised;
  const ImU32 ink = press.chosen ? look.palette.on_accent : look.palette.text;
  if (face) draw->AddRectFilled(at, {at.x + size.x, at.y + size.y}, face, look.px(4));
  set_text(draw, look.fonts.text, {at.x + look.px(11), centred_baseline(look.fonts.text, at.y, size.y)},
           press.enabled ? ink : faded(look.palette.dim, 0.6f), label);
  if (wants_tooltip(app) && (!press.tip.en.empty() || !press.shortcut.empty()))
    tooltip(app, {}, press.tip.in(app.language()), press.shortcut);
  return pressed;
}

float tab_width(const App& app, std::string_view label) {
  return text_width(app.look.fonts.small, label) + 2 * app.look.px(7);
}

bool tab(App& app, const char* id, std::string_view label, bool chosen) {
  Look& look = app.look;
  label = noted(app, label);
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{tab_width(app, label), look.px(28)};
  const bool pressed = ImGui::InvisibleButton(id, size);
  note_place(app, "button", label);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 face = chosen ? look.palette.accent : ImGui::IsItemHovered() ? look.palette.raised_hover : 0;
  if (face) draw->AddRectFilled(at, {at.x + size.x, at.y + size.y}, face, look.px(4));
  set_text(draw, look.fonts.small, {at.x + look.px(7), centred_baseline(look.fonts.small, at.y, size.y)},
           chosen ? look.palette.on_accent : look.palette.text, label);
  return pressed;
}

bool choose(App& app, const char* id, std::span<const Name> names, int& chosen) {
  if (names.empty()) return false;
  const int old = chosen;
  chosen = std::clamp(chosen, 0, int(names.size()) - 1);
  const Language language = app.language();
  const float gap = app.look.px(6), room = ImGui::GetContentRegionAvail().x;
  float needed = -gap;
  for (const Name& n : names) needed += button_width(app, noted(app, n.label)) + gap;
  ImGui::PushID(id);
  if (needed <= room) {
    for (int i = 0; i < int(names.size()); ++i) {
      if (i > 0) ImGui::SameLine(0, gap);
      ImGui::PushID(i);
      if (button(app, "one", {.label = names[i].label.in(language), .chosen = i == chosen})) chosen = i;
      ImGui::PopID();
    }
  } else {
    const std::string shown(names[std::size_t(chosen)].label.in(language));
    if (begin_list(app, "##list", shown.c_str(), room)) {
      for (int i = 0; i < int(names.size()); ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(std::string(names[i].label.in(language)).c_str(), i == chosen)) chosen = i;
        ImGui::PopID();
      }
      ImGui::EndCombo();
    }
  }
  ImGui::PopID();
  return chosen != old;
}

bool toggle(App& app, const char* id, std::string_view label, bool& on) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float w = std::max(1.0f, ImGui::GetContentRegionAvail().x), h = look.px(30);
  const bool pressed = ImGui::InvisibleButton(id, {w, h});
  note_place(app, "toggle", label);
  if (pressed) on = !on;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.text, {at.x, centred_baseline(look.fonts.text, at.y, h)}, look.palette.text,
           noted(app, label));
  const float r = look.px(7.5f), track = look.px(30);
  const ImVec2 low{at.x + w - track, at.y + 0.5f * h - r}, high{at.x + w, at.y + 0.5f * h + r};
  draw->AddRectFilled(low, high,
                      on                       ? look.palette.accent
                      : ImGui::IsItemHovered() ? look.palette.raised_hover
                                               : look.palette.line,
                      r);
  draw->AddCircleFilled({on ? high.x - r : low.x + r, 0.5f * (low.y + high.y)}, r - look.px(2.5f),
                        on ? look.palette.on_accent : look.palette.text);
  return pressed;
}

bool slider(App& app, const char* id, double& position, ImU32 colour, bool lit, ImVec2 size) {
  Look& look = app.look;
  const float r = look.px(7);
  size = {std::max(size.x, 4 * r), std::max(size.y, 2 * r)};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(id, size);
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const float x0 = at.x + r, x1 = at.x + size.x - r, y = std::floor(at.y + 0.5f * size.y);
  bool moved = false;
  if (active && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0)) {
    const double t = std::clamp(double(ImGui::GetIO().MousePos.x - x0) / double(x1 - x0), 0.0, 1.0);
    moved = std::isfinite(t) && t != position;
    if (moved) position = t;
  }
  if (active) app.animating = true;
  const float t = float(position > 0 ? std::min(position, 1.0) : 0.0);  // NaN is 0
  const float x = x0 + t * (x1 - x0);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float thick = look.px((hovered || active || lit ? 4 : 3) * look.stroke) * 0.5f;
  draw->AddRectFilled({x0, y - thick}, {x1, y + thick}, look.palette.line, thick);
  draw->AddRectFilled({x0, y - thick}, {x, y + thick}, colour, thick);
  if (active || lit) draw->AddCircleFilled({x, y}, r + look.px(4), faded(colour, 0.35f));
  draw->AddCircleFilled({x, y}, r, look.palette.knob);
  if (look.palette.knob_edge) draw->AddCircle({x, y}, r, look.palette.knob_edge, 0, look.px(1));
  return moved;
}

void progress_bar(App& app, float fraction, float width) {
  const Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  width = std::max(width, 1.0f);
  const float y = at.y + look.px(16), thick = look.px(2), share = fraction > 0 ? std::min(fraction, 1.0f) : 0.0f;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({at.x, y - thick}, {at.x + width, y + thick}, look.palette.line, thick);
  draw->AddRectFilled({at.x, y - thick}, {at.x + share * width, y + thick}, look.palette.accent, thick);
  ImGui::Dummy({width, look.px(32)});
}

bool reset_arrow(App& app, const char* id, bool visible, ImVec2 size) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (!visible) {
    ImGui::Dummy(size);
    return false;
  }
  const bool pressed = ImGui::InvisibleButton(id, size);
  const ImU32 colour = ImGui::IsItemHovered() ? look.palette.text : look.palette.dim;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 c{at.x + 0.5f * size.x, at.y + 0.5f * size.y};
  const float r = look.px(10) * 0.45f, a0 = float(radians(-150.0)), a1 = float(radians(130.0));
  draw->PathArcTo(c, r, a0, a1, 20);
  draw->PathStroke(colour, 0, look.px(3) * 0.45f);
  const ImVec2 tip{c.x + r * std::cos(a0), c.y + r * std::sin(a0)};
  const float s = look.px(10) * 0.33f;
  draw->AddTriangleFilled({tip.x - s, tip.y - s * 0.7f}, {tip.x + s * 0.9f, tip.y + s * 0.1f},
                          {tip.x - s * 0.6f, tip.y + s * 1.1f}, colour);
  if (wants_tooltip(app)) tooltip(app, {}, Words{"Set back to the default", "既定値に戻す"}.in(app.language()), {});
  return pressed;
}

bool wants_tooltip(App& app) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsAnyMouseDown()) return false;
  constexpr double rest = 0.5;
  const double rested = double(ImGui::GetCurrentContext()->HoveredIdTimer);
  if (rested >= rest) return true;
  app.next_frame = std::min(app.next_frame, app.now + rest - rested + 0.01);
  return false;
}

void tooltip(App& app, std::string_view title, std::string_view help, std::string_view small_print) {
  Look& look = app.look;
  const std::vector<TextRun> runs = formula_runs(help);
  const float most = look.px(330);
  // Formulas are typeset, and long Japanese is broken where it may be: as wide as the room there is.
  const bool set = text_width(look.fonts.text, noted(app, help)) > most ||
                   std::any_of(runs.begin(), runs.end(), [](const TextRun& r) { return r.kind == TextRun::formula; });
  if (set) ImGui::SetNextWindowSize({look.px(24) + most, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look.px(12), look.px(9)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(most);
  auto line = [&](ImFont* font, ImU32 colour, std::string_view text) {
    if (text.empty()) return;
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    write(app, text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
  };
  line(look.fonts.bold, look.palette.text, title);
  if (set)
    set_runs(app, runs, body_style(app));
  else
    line(look.fonts.text, look.palette.text, help);
  line(look.fonts.small_mono, look.palette.dim, small_print);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

bool wheel(App& app, double& steps) {
  const float turned = ImGui::GetIO().MouseWheel;
  if (!ImGui::IsItemHovered() || app.now - app.scrolled_at < 0.4 || ImGui::GetIO().KeyCtrl) return false;
  ImGui::SetItemUsingMouseWheel();
  steps = double(turned);
  return turned != 0 && std::isfinite(turned);
}

}  // namespace cg
