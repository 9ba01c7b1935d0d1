// The strip below: the equation of the light model, each term in its colour; a click draws that term alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/app.h"
#include "ui/equation.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/number.h"
#include "ui/probe_strip.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// The lights as buttons: one alone, or all.
void draw_light_choice(App& app) {
  const int count = int(app.scene.lights.size());
  if (app.isolated.light >= count) app.isolated.light = -1;
  const Language l = app.language();
  if (count > 1) {
    if (button(app, "all", {.label = Words{"All lights", "全光源"}.in(l), .chosen = app.isolated.light < 0}))
      app.isolated.light = -1;
    for (int i = 0; i < std::min(count, 8); ++i) {
      ImGui::SameLine(0, app.look.px(4));
      ImGui::PushID(i);
      const std::string label = std::to_string(i);
      if (button(
              app, "light",
              {.label = label, .tip = {"This light alone", "この光源だけを描く"}, .chosen = app.isolated.light == i}))
        app.isolated.light = app.isolated.light == i ? -1 : i;
      ImGui::PopID();
    }
    ImGui::SameLine(0, app.look.px(10));
  }
  if (app.isolated != Isolated{} &&
      button(app, "everything",
             {.label = Words{"All terms", "すべての項"}.in(l), .tip = {"Everything again", "すべて描く"}}))
    app.isolated = {};
}

struct Figure {
  Words label;
  std::string value;
};

// In one line that ends at `right`; what does not fit beside the heading is left out, the last first.
void draw_figures(App& app, float left, float right, float baseline) {
  Look& look = app.look;
  const Figures& f = app.figures;
  const std::string none = "–";
  const std::array<Figure, 4> all{
      {{{"Max difference", "最大差"}, f.valid ? number_text(std::round(f.max_error * 2550) / 10, 1, 6) + "/255" : none},
       {{"RMSE", "RMSE"}, f.valid ? number_text(f.rmse, 0, 7) : none},
       {{"Coverage", "被覆差"}, f.valid ? std::to_string(f.coverage_mismatch) + " px" : none},
       {{"Over 1/255", "1/255 超"}, f.valid ? std::to_string(f.over_1_255) + " px" : none}}};
  const float gap = look.px(8), between = look.px(26), value_room = look.px(62);
  const auto width = [&](const Figure& figure) {
    return text_width(look.fonts.small, noted(app, figure.label)) + gap +
           std::max(value_room, text_width(look.fonts.small_mono, figure.value));
  };
  std::size_t shown = 0;
  float total = -between;
  while (shown < all.size() && left + total + between + width(all[shown]) <= right)
    total += between + width(all[shown++]);
  float x = right - total;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < shown; ++i) {
    const float label =
        set_text(draw, look.fonts.small, {x, baseline}, look.palette.dim, noted(app, all[i].label)) + gap;
    set_text(draw, look.fonts.small_mono, {x + label, baseline}, look.palette.text, noted(app, all[i].value));
    x += width(all[i]) + between;
  }
}

std::string title_of(const App& app, const Probe* probe) {
  if (probe) return probe_title(app, *probe);
  return std::string((app.isolated == Isolated{}
                          ? Words{"Light model", "光源計算の式"}
                          : Words{"Light model: one part alone", "光源計算の式（一部だけを表示中）"})
                         .in(app.language()));
}

// A small cross; true when it was pressed.
bool close_button(App& app, ImVec2 at) {
  Look& look = app.look;
  const float side = look.px(20), arm = look.px(4);
  ImGui::SetCursorScreenPos({at.x, at.y + look.px(2)});
  const bool pressed = ImGui::InvisibleButton("close", {side, side});
  const ImVec2 c{at.x + 0.5f * side, at.y + look.px(2) + 0.5f * side};
  const ImU32 colour = ImGui::IsItemHovered() ? look.palette.text : look.palette.dim;
  for (const float way : {1.0f, -1.0f})
    ImGui::GetWindowDrawList()->AddLine({c.x - arm, c.y - way * arm}, {c.x + arm, c.y + way * arm}, colour,
                                        look.px(1.5f));
  if (wants_tooltip(app)) tooltip(app, {}, Words{"No pixel (Esc)", "画素の選択をやめる（Esc）"}.in(app.language()), {});
  return pressed;
}

void draw_hint(App& app, float width) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Words hint{"Click a pixel in a picture: its numbers stand under the terms",
                   "画像の画素をクリックすると、各項の下に数値が出る"};
  if (text_width(look.fonts.small, noted(app, hint)) > width) return;
  set_text(ImGui::GetWindowDrawList(), look.fonts.small, {at.x, at.y + look.px(18)}, look.palette.dim,
           noted(app, hint));
}

}  // namespace

void draw_strip(App& app) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  if (!(room.x > 1)) return;
  const Probe* probe = shown_probe(app);
  const std::string title(noted(app, title_of(app, probe)));
  heading(app, title);
  float right = at.x + text_width(look.fonts.small, title) + look.px(10);
  if (app.probing.at && close_button(app, {right, at.y})) app.probing = {}, probe = nullptr;
  right += look.px(app.probing.at ? 30 : 14);
  // Two lines of results stand below the rows; the lowest may come near the edge.
  const float end = at.y + room.y + look.px(8), top = at.y + look.px(24), results = look.px(4 + 2 * 19);
  const auto rows_below = [&](bool large) {
    return (end - top - results - equation_height(app, large)) / row_height(app);
  };
  const ProbeRows rows = probe ? number_rows(app, *probe, std::size_t(std::max(rows_below(false), 0.0f))) : ProbeRows{};
  const bool large = !probe || rows_below(true) >= float(rows.wide.size());
  if (probe)
    draw_probe_choices(app, *probe, right, at.x + room.x, at.y + look.px(17));
  else
    draw_figures(app, right, at.x + room.x, at.y + look.px(17));
  float y = top;
  y += draw_equation(app, {at.x, y}, room.x, large, rows.wide, rows.narrow) + look.px(4);
  ImGui::SetCursorScreenPos({at.x, y + look.px(4)});
  if (probe) {
    draw_probe_results(app, *probe, {at.x, y}, {room.x, end - y});
  } else {
    draw_light_choice(app);
    if (!app.probing.at) draw_hint(app, room.x);
  }
}

}  // namespace cg
