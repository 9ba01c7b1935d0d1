// The strip below: the equation of the light model, each term in its colour; a click draws that term alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// One piece of the equation; with a quantity it is a term that can be isolated.
struct Piece {
  std::string markup;
  Quantity quantity = Quantity::none;
  bool needs_rays = false;
};

std::vector<Piece> light_model(const Scene& scene) {
  const bool blinn = scene.shading.reflection == Reflection::half_vector;
  const bool emits = scene.material.emission != glm::dvec3(0);
  std::vector<Piece> out{{"I = "}};
  if (emits) out.insert(out.end(), {{"E", Quantity::emission}, {" + "}});
  out.insert(out.end(), {{"I_ak_a", Quantity::ambient},
                         {" + Σ I_i [ "},
                         {"k_d(N·L)", Quantity::diffuse},
                         {" + "},
                         {blinn ? "k_s(N·H)^n" : "k_s(R·V)^n", Quantity::specular},
                         {" ] + "},
                         {"k_rI_r", Quantity::reflection, true},
                         {" + "},
                         {"k_tI_t", Quantity::transmission, true}});
  return out;
}

const About* about_of(Quantity q) {
  const About* found = nullptr;
  std::apply([&](const auto&... f) { ((found = !found && f.about.quantity == q ? &f.about : found), ...); },
             fields_of<Material>);
  return found;
}

void explain_term(App& app, const Piece& piece) {
  const Language l = app.language();
  const About* about = about_of(piece.quantity);
  const Words click = app.isolated.term == piece.quantity
                          ? Words{"Click: all terms again", "クリックですべての項に戻す"}
                          : Words{"Click: this term alone", "クリックでこの項だけを描く"};
  tooltip(app, about ? about->label.in(l) : "", about ? about->help.in(l) : "",
          piece.needs_rays ? Words{"needs ray tracing", "レイトレーシングが必要"}.in(l) : click.in(l));
}

void draw_equation(App& app, ImVec2 at, float baseline) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const TypeSize size{look.fonts.formula, look.fonts.formula_sub};
  const float top = at.y, h = look.px(52);
  float x = at.x;
  int index = 0;
  for (const Piece& piece : light_model(app.scene)) {
    const float w = typeset_width(size, noted(app, piece.markup));
    const bool term = piece.quantity != Quantity::none;
    const bool alone = app.isolated.term != Quantity::none;
    float alpha = 1;
    if (piece.needs_rays || (alone && app.isolated.term != piece.quantity)) alpha = 0.45f;
    if (term) {
      ImGui::PushID(index);
      ImGui::SetCursorScreenPos({x, top});
      const bool pressed = ImGui::InvisibleButton("term", {w, h});
      if (ImGui::IsItemHovered()) {
        app.lit_next = piece.quantity;
        if (!piece.needs_rays) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      }
      if (wants_tooltip(app)) explain_term(app, piece);
      if (pressed && !piece.needs_rays)
        app.isolated.term = app.isolated.term == piece.quantity ? Quantity::none : piece.quantity;
      ImGui::PopID();
      const bool lit = app.lit == piece.quantity;
      if (lit || app.isolated.term == piece.quantity)
        draw->AddRectFilled({x - look.px(3), top + look.px(4)}, {x + w + look.px(3), top + h},
                            faded(look.of(piece.quantity), lit ? 0.16f : 0.10f), look.px(5));
      if (lit) alpha = std::max(alpha, 0.7f);
    }
    const ImU32 colour = term ? look.of(piece.quantity) : look.palette.text;
    typeset(draw, size, {x, baseline}, faded(colour, alpha), piece.markup);
    if (piece.needs_rays && piece.quantity == Quantity::reflection)
      set_text(draw, look.fonts.small, {x, baseline + look.px(32)}, faded(look.palette.dim, 0.8f),
               noted(app, Words{"needs ray tracing", "レイトレーシングが必要"}));
    x += w;
    ++index;
  }
}

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

}  // namespace

void draw_strip(App& app) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const std::string_view title =
      noted(app, app.isolated == Isolated{} ? Words{"Light model", "光源計算の式"}
                                            : Words{"Light model: one part alone", "光源計算の式（一部だけを表示中）"});
  heading(app, title);
  draw_figures(app, at.x + text_width(look.fonts.small, title) + look.px(24), at.x + room.x, at.y + look.px(17));
  const float top = at.y + look.px(24);
  draw_equation(app, {at.x, top}, top + look.px(37));
  ImGui::SetCursorScreenPos({at.x, top + look.px(60)});
  draw_light_choice(app);
}

}  // namespace cg
