#include "ui/row.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

std::string exact_text(double v) { return number_text(v, 0, 40); }

double moved_by(const Row& row, double steps) {
  const bool fine = ImGui::GetIO().KeyShift;
  const double next = stepped(*row.about, row.value, steps, fine);
  if (!row.whole || steps == 0) return next;
  // At least to the next whole number.
  const double least = row.value + (steps > 0 ? 1 : -1), far = std::round(next);
  const Range& range = row.about->range;
  return std::clamp(steps > 0 ? std::max(far, least) : std::min(far, least), range.min, range.max);
}

double slid_to(const Row& row, double position, bool fine) {
  const double value = slider_value(*row.about, position, fine);
  return row.whole ? std::round(value) : value;
}

// The value itself: a click types it, a drag and the wheel move it.
void show_value(App& app, const Row& row, ImVec2 at, ImVec2 size, RowChange& change) {
  Look& look = app.look;
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("value", size);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  if (hovered)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + look.px(3)}, {at.x + size.x, at.y + size.y - look.px(3)},
                                              look.palette.raised, look.px(4));
  ImFont* font = look.fonts.mono;
  const std::string text = number_text(row.value, row.whole ? 0 : decimals(*row.about), 8);
  const float baseline = at.y + 0.5f * (size.y - font->FontSize) + font->Ascent;
  set_text(ImGui::GetWindowDrawList(), font, {at.x + size.x - look.px(4) - text_width(font, text), baseline},
           row.about->accepts(row.value) ? look.palette.text : look.palette.error, text);
  const float dragged = ImGui::GetIO().MouseDelta.x;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0) && dragged != 0)
    change.moved = moved_by(row, double(dragged) / double(look.scale) * 0.5);
  const bool clicked = ImGui::IsItemDeactivated() && !ImGui::IsMouseDragPastThreshold(0) && hovered;
  const bool enter = hovered && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  if (clicked || enter)
    app.editing = {ImGui::GetID("value"), row.exact.empty() ? exact_text(row.value) : row.exact, true};
}

void show_swatch(App& app, const ImVec4& colour, ImVec2 at, float side, RowChange& change) {
  ImGui::SetCursorScreenPos(at);
  change.swatch = ImGui::InvisibleButton("swatch", {side, side});
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + side, at.y + side};
  draw->AddRectFilled(at, end, ImGui::ColorConvertFloat4ToU32(colour), app.look.px(3));
  draw->AddRect(at, end, ImGui::IsItemHovered() ? app.look.palette.text : app.look.palette.line, app.look.px(3));
  if (wants_tooltip(app)) tooltip(app, {}, Words{"Choose a colour", "色を選ぶ"}.in(app.language()), {});
}

}  // namespace

RowChange number_row(App& app, const Row& row) {
  Look& look = app.look;
  RowChange change;
  ImGui::PushID(row.id);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = std::max(ImGui::GetContentRegionAvail().x, look.px(150)), h = look.px(30);
  const float reset_w = look.px(20), play_w = look.px(18), value_w = look.px(78),
              swatch_w = look.px(row.swatch ? 20 : 0);
  const float symbol_w = look.px(row.symbol.empty() ? -7 : 34);  // the knob's line begins at the edge
  const bool lit = app.lit != Quantity::none && app.lit == row.about->quantity;
  const ImU32 colour = look.of(row.about->quantity);
  const bool wholly_hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                              ImGui::IsMouseHoveringRect(at, {at.x + room, at.y + h});
  if (wholly_hovered && row.about->quantity != Quantity::none) app.lit_next = row.about->quantity;

  if (!row.symbol.empty()) {
    ImGui::InvisibleButton("symbol", {symbol_w, h});
    if (wants_tooltip(app)) describe(app, *row.about, row.exact.empty() ? exact_text(row.value) : row.exact);
    typeset(ImGui::GetWindowDrawList(), {look.fonts.math, look.fonts.math_sub}, {at.x, at.y + h * 0.5f + look.px(6.5f)},
            row.about->quantity == Quantity::none ? look.palette.text : colour, noted(app, row.symbol));
  }
  ImGui::SetCursorScreenPos({at.x + symbol_w, at.y});
  double position = slider_position(*row.about, row.value);
  const float slider_w = room - symbol_w - swatch_w - value_w - play_w - reset_w - look.px(6);
  if (slider(app, "slider", position, colour, lit, {slider_w, h}))
    change.moved = slid_to(row, position, ImGui::GetIO().KeyShift);
  note_place(app, "slider", row.about->name);
  if (wants_tooltip(app)) describe(app, *row.about, row.exact.empty() ? exact_text(row.value) : row.exact);
  double steps = 0;
  if (wheel(app, steps)) change.moved = moved_by(row, steps);

  const float value_x = at.x + room - reset_w - play_w - value_w;
  if (row.swatch)
    show_swatch(app, *row.swatch, {value_x - look.px(14), at.y + 0.5f * (h - look.px(16))}, look.px(16), change);
  if (app.editing.item == ImGui::GetID("value"))
    change.typed = type_value(app, look.fonts.mono, row.exact.empty() ? exact_text(row.value) : row.exact,
                              {value_x + look.px(2), at.y + look.px(1)}, value_w);
  else
    show_value(app, row, {value_x + (row.swatch ? look.px(8) : 0), at.y}, {value_w - (row.swatch ? look.px(8) : 0), h},
               change);
  if (wheel(app, steps)) change.moved = moved_by(row, steps);
  if (change.moved || change.typed) choose_for_sweep(app);
  if (const auto swept = sweep_row(app, position, wholly_hovered, {at.x + room - reset_w - play_w, at.y}, {play_w, h}))
    change.moved = slid_to(row, *swept, true);
  ImGui::SetCursorScreenPos({at.x + room - reset_w, at.y});
  change.reset = reset_arrow(app, "reset", row.differs, {reset_w, h});
  ImGui::SetCursorScreenPos({at.x, at.y + h});
  ImGui::PopID();
  return change;
}

std::optional<std::string> type_value(App& app, ImFont* font, const std::string& shown, ImVec2 at, float width) {
  Editing& e = app.editing;
  ImGui::SetCursorScreenPos(at);
  ImGui::SetNextItemWidth(width);
  ImGui::PushFont(font);
  if (e.fresh) ImGui::SetKeyboardFocusHere(), app.animating = true;  // which the field gets in the next frame
  const bool entered =
      ImGui::InputText("##type", &e.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopFont();
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  const bool tab = !e.fresh && ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false);
  if (tab) ImGui::ClearActiveID();
  std::optional<std::string> typed;
  if (entered || tab || (ImGui::IsItemDeactivated() && !escaped)) {
    if (e.text != shown) typed = e.text;
    e = {};
  } else if (escaped || (!e.fresh && !ImGui::IsItemActive())) {
    e = {};
  }
  e.fresh = false;
  return typed;
}

void describe(App& app, const About& about, std::string_view exact) {
  const Language language = app.language();
  std::string small;
  if (!exact.empty()) small = std::string(exact) + "\n";
  small += exact_text(about.range.min) + " … " + exact_text(about.range.max);
  if (about.also) small += ", " + exact_text(*about.also);
  if (about.unit != "1") small += " " + std::string(about.unit);
  if (!about.gl.empty()) small += "\n" + std::string(about.gl);
  tooltip(app, about.label.in(language), about.help.in(language), small);
}

}  // namespace cg
