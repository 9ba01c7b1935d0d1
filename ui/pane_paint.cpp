// The pictures in the panes: beside each other, as a wipe, one behind the other, and their difference.
#include <string>

#include "ui/app.h"
#include "ui/line_style.h"
#include "ui/panes.h"
#include "ui/widgets.h"

namespace cg {

namespace {

// Whether texels are shown as they are: magnified, or one to one (which is faster then, and the same).
bool shows_texels(const Place& place, const Drawing& drawing) {
  return drawing.coarseness == 1 && (place.magnification() >= 2 || place.magnification() == 1);
}

}  // namespace

void Panes::paint_picture(App& app, const Texture& texture, const Place& place, float from, float to) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto x_at = [&](float t) { return place.low.x + t * (place.high.x - place.low.x); };
  if (texture.empty()) {
    draw->AddRectFilled({x_at(from), place.low.y}, {x_at(to), place.high.y}, app.look.palette.pane);
    return;
  }
  const Region& r = place.region;
  const float u0 = float(r.low.x), v0 = float(r.low.y), e = float(r.extent());
  draw->AddImage(texture.id(), {x_at(from), place.low.y}, {x_at(to), place.high.y}, {u0 + from * e, v0},
                 {u0 + to * e, v0 + e});
}

void Panes::paint_pane(App& app, int side, const Place& place) {
  const PaneState& pane = jobs_.pane(side);
  if (place.empty()) return;
  const bool old = pane.message.has_value();
  if (!old && on_screen_[std::size_t(side)]) {
    pictures_[std::size_t(side)].magnify(shows_texels(place, *on_screen_[std::size_t(side)]));
    paint_picture(app, pictures_[std::size_t(side)], place, 0, 1);
    paint_lines(app, side, place);
    paint_handles(app, place);
    paint_probe(app, side, place);
    paint_cursor(app, place);
  }
  paint_message(app, side, place);
  paint_footer(app, side, {place.low.x, place.high.y + app.look.px(6)}, place.high.x - place.low.x);
}

void Panes::paint_wipe(App& app, const Place& place) {
  if (place.empty()) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float t = float(app.settings.wipe), edge = place.low.x + t * (place.high.x - place.low.x);
  for (int side = 0; side < 2; ++side) {
    const std::size_t i = std::size_t(side);
    if (on_screen_[i]) pictures_[i].magnify(shows_texels(place, *on_screen_[i]));
    if (jobs_.pane(side).message) continue;
    draw->PushClipRect({side == 0 ? place.low.x : edge, place.low.y}, {side == 0 ? edge : place.high.x, place.high.y},
                       true);
    paint_picture(app, pictures_[i], place, 0, 1);
    paint_lines(app, side, place);
    paint_probe(app, side, place);
    draw->PopClipRect();
  }
  paint_handles(app, place);
  paint_cursor(app, place);
  const bool held = pointing_.on_wipe || gesture_.kind == Gesture::wipe;
  const ImU32 colour = held ? on_picture : faded(on_picture, 0.75f);
  draw->AddRectFilled({edge - app.look.px(1), place.low.y}, {edge + app.look.px(1), place.high.y}, colour);
  const ImVec2 knob{edge, place.middle().y};
  draw->AddCircleFilled(knob, app.look.px(7), colour, 24);
  if (held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  paint_name(app, 0, {place.low.x + app.look.px(10), place.low.y + app.look.px(8)}, false);
  paint_name(app, 1, {place.high.x - app.look.px(10), place.low.y + app.look.px(8)}, true);
  for (int side = 0; side < 2; ++side) {
    Place half = place;
    (side == 0 ? half.high.x : half.low.x) = edge;
    paint_message(app, side, half);
  }
  paint_both_footers(app, place);
}

void Panes::paint_flip(App& app, const Place& place) {
  if (place.empty()) return;
  const bool typing = ImGui::GetIO().WantTextInput;
  if (!typing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false))
    flipped_ = 1 - flipped_, auto_flip_ = false;
  if (auto_flip_) {
    if (app.now - flipped_at_ > 0.7) flipped_ = 1 - flipped_, flipped_at_ = app.now;
    app.next_frame = std::min(app.next_frame, flipped_at_ + 0.71);
  }
  app.probing.side = flipped_;
  paint_pane(app, flipped_, place);
  paint_name(app, flipped_, {place.low.x + app.look.px(10), place.low.y + app.look.px(8)}, false);
  const Words label{"Auto", "自動"};
  const float w = button_width(app, label.in(app.language()));
  ImGui::SetCursorScreenPos({place.high.x - w - app.look.px(6), place.low.y + app.look.px(6)});
  if (button(app, "auto flip",
             {.label = label.in(app.language()),
              .tip = {"Changes by itself; Tab changes by hand", "自動で切り替える。Tab で手動"},
              .shortcut = "Tab",
              .chosen = auto_flip_}))
    auto_flip_ = !auto_flip_, flipped_at_ = app.now;
}

void Panes::paint_difference(App& app, const Place& place) {
  if (place.empty()) return;
  const bool there = shown_difference_ && !shown_difference_->picture.empty();
  if (there && !jobs_.pane(0).message && !jobs_.pane(1).message) {
    difference_.magnify(place.magnification() >= 2);
    paint_picture(app, difference_, place, 0, 1);
    paint_lines(app, 0, place);
    paint_handles(app, place);
    paint_probe(app, 0, place);
    paint_cursor(app, place);
    paint_worst(app, place);
  }
  for (int side = 0; side < 2; ++side) paint_message(app, side, place);
  paint_gain(app, place);
  if (app.settings.view == ViewMode::false_colour) paint_legend(app, place);
  paint_both_footers(app, place);
}

}  // namespace cg
