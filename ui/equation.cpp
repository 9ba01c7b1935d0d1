#include "ui/equation.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/solver_panel.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// One piece of the equation; with a quantity it is a term that can be isolated.
struct Piece {
  std::string markup;
  Part part = Part::sign;
  Quantity quantity = Quantity::none;
  const char* between = "";  // in a row of numbers
};

// The ambient term, where radiosity is drawn for it; of a part of its light alone nothing else is (draw_solver_state).
struct Drawn {
  bool radiosity = false;
  LightPart part = LightPart::total;
};
Drawn drawn_in(const App& app) {
  if (const SolverStateHandle state = drawn_solver_state(app)) return {true, state->part};
  return {app.scene.shading.ambient_source == AmbientSource::radiosity};
}

bool draws_emission(const App& app) {
  if (drawn_in(app).part != LightPart::total) return false;
  bool emits = app.scene.material.emission != glm::dvec3(0);
  for (const Object& object : app.scene.objects)
    emits = emits || (object.own_material && object.material.emission != glm::dvec3(0));
  return emits;
}

std::vector<Piece> light_model(const App& app, bool with_rays) {
  const bool blinn = app.scene.shading.reflection == Reflection::half_vector;
  std::vector<Piece> out{{"I", Part::sum}, {" = ", Part::sign, Quantity::none, "="}};
  if (draws_emission(app))
    out.insert(out.end(), {{"E", Part::emission, Quantity::emission}, {" + ", Part::sign, Quantity::none, "+"}});
  out.insert(out.end(), {{ambient_term(app), Part::ambient, Quantity::ambient},
                         {" + Σ I_i [ ", Part::sign, Quantity::none, "+"},
                         {"k_d(N·L)", Part::diffuse, Quantity::diffuse},
                         {" + ", Part::sign, Quantity::none, "+"},
                         {blinn ? "k_s(N·H)^n" : "k_s(R·V)^n", Part::specular, Quantity::specular},
                         {" ]"}});
  if (with_rays)
    out.insert(out.end(), {{" + "},
                           {"k_rI_r", Part::rays, Quantity::reflection},
                           {" + "},
                           {"k_tI_t", Part::rays, Quantity::transmission}});
  return out;
}

constexpr float height_in_em = 1.3f;

const About* about_of(const App& app, Quantity q) {
  const About* found = nullptr;
  if (q == Quantity::ambient && drawn_in(app).radiosity) {
    std::apply([&](const auto&... f) { ((found = f.about.name == "ambient_source" ? &f.about : found), ...); },
               fields_of<Shading>);
    return found;
  }
  std::apply([&](const auto&... f) { ((found = !found && f.about.quantity == q ? &f.about : found), ...); },
             fields_of<Material>);
  return found;
}

void explain_term(App& app, const Piece& piece) {
  const Language l = app.language();
  const About* about = about_of(app, piece.quantity);
  const Words click = app.isolated.term == piece.quantity
                          ? Words{"Click: all terms again", "クリックですべての項に戻す"}
                          : Words{"Click: this term alone", "クリックでこの項だけを描く"};
  tooltip(app, about ? about->label.in(l) : "", about ? about->help.in(l) : "",
          piece.part == Part::rays ? Words{"needs ray tracing", "レイトレーシングが必要"}.in(l) : click.in(l));
}

// How the equation and the rows are set, and where each piece stands.
struct Typesetting {
  std::vector<Piece> pieces;
  const std::vector<NumberRow>* rows = nullptr;
  TypeSize type{}, numbers{};
  ImFont* labels = nullptr;
  float label_width = 0;
  std::vector<float> widths;  // of the pieces' columns
  float total = 0;
};

const std::string* cell_of(const NumberRow& row, const Piece& piece) {
  return std::size_t(piece.part) < parts_with_numbers ? &row.cells[std::size_t(piece.part)] : nullptr;
}

Typesetting set_up(App& app, bool large, bool with_rays, const std::vector<NumberRow>& rows, float scale) {
  const Fonts& f = app.look.fonts;
  Typesetting s;
  s.pieces = light_model(app, with_rays);
  s.rows = &rows;
  s.type = large ? TypeSize{f.formula, f.formula_sub, scale} : TypeSize{f.math, f.math_sub, scale};
  s.numbers = {f.small_mono, f.small_mono, scale, 0.8f};
  s.labels = f.small;
  for (const NumberRow& row : rows)
    if (!row.label.empty())
      s.label_width = std::max(s.label_width, text_width(s.labels, noted(app, row.label), scale) + app.look.px(12));
  s.total = s.label_width;
  for (const Piece& piece : s.pieces) {
    float w = typeset_width(s.type, noted(app, piece.markup));
    for (const NumberRow& row : rows)
      if (const std::string* cell = cell_of(row, piece)) w = std::max(w, typeset_width(s.numbers, noted(app, *cell)));
    s.widths.push_back(w);
    s.total += w;
  }
  return s;
}

// The largest setting that fits.
Typesetting fitted(App& app, float width, bool may_be_large, const std::vector<NumberRow>& rows,
                   const std::vector<NumberRow>& narrow_rows) {
  for (const bool large : {true, false})
    for (const std::vector<NumberRow>* numbers : {&rows, &narrow_rows})
      for (const bool with_rays : {true, false}) {
        if (large && !may_be_large) continue;
        if (Typesetting s = set_up(app, large, with_rays, *numbers, 1); s.total <= width) return s;
      }
  const Typesetting smallest = set_up(app, false, false, narrow_rows, 1);
  const float scale = std::clamp(width / std::max(smallest.total, 1.0f), 0.2f, 1.0f);
  return set_up(app, false, false, narrow_rows, 0.98f * scale);
}

// While the mouse rests on a term the pictures show it alone, where that costs next to nothing.
void peek(App& app, const Piece& piece) {
  constexpr double rest = 0.3, cheap_ms = 60;
  const double rested = double(ImGui::GetCurrentContext()->HoveredIdTimer);
  if (app.isolated.term != Quantity::none || app.figures.left_ms + app.figures.right_ms > cheap_ms) return;
  if (rested >= rest)
    app.peek = Isolated{piece.quantity, app.isolated.light};
  else
    app.next_frame = std::min(app.next_frame, app.now + rest - rested + 0.01);
}

void draw_term(App& app, const Piece& piece, ImVec2 low, ImVec2 high, float baseline, const TypeSize& type) {
  Look& look = app.look;
  ImGui::SetCursorScreenPos(low);
  const bool pressed = ImGui::InvisibleButton("term", {std::max(high.x - low.x, 1.0f), std::max(high.y - low.y, 1.0f)});
  const bool rays = piece.part == Part::rays;
  if (ImGui::IsItemHovered()) {
    app.lit_next = piece.quantity;
    if (!rays) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand), peek(app, piece);
  }
  if (wants_tooltip(app)) {
    ImGui::SetNextWindowPos({low.x, low.y - look.px(8)}, ImGuiCond_Always, {0, 1});  // not over the numbers
    explain_term(app, piece);
  }
  if (pressed && !rays) app.isolated.term = app.isolated.term == piece.quantity ? Quantity::none : piece.quantity;
  const bool lit = app.lit == piece.quantity, alone = app.isolated.term == piece.quantity;
  float alpha = rays || (app.isolated.term != Quantity::none && !alone) ? 0.45f : 1.0f;
  if (lit) alpha = std::max(alpha, 0.7f);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (lit || alone)
    draw->AddRectFilled({low.x - look.px(3), low.y}, {high.x + look.px(3), high.y},
                        faded(look.of(piece.quantity), lit ? 0.16f : 0.10f), look.px(5));
  const float x = low.x + 0.5f * (high.x - low.x - typeset_width(type, piece.markup));
  typeset(draw, type, {x, baseline}, faded(look.of(piece.quantity), alpha), piece.markup);
}

void draw_row(App& app, const Typesetting& s, const NumberRow& row, ImVec2 at, float baseline) {
  const Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, s.labels, {at.x, baseline}, look.palette.dim, row.label, s.type.scale);
  float x = at.x + s.label_width;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const Piece& piece = s.pieces[i];
    const std::string* cell = cell_of(row, piece);
    const std::string text = cell ? *cell : row.signs ? std::string(piece.between) : std::string();
    const ImU32 colour = piece.quantity != Quantity::none ? look.of(piece.quantity)
                         : cell                           ? look.palette.text
                                                          : look.palette.dim;
    typeset(draw, s.numbers, {x + 0.5f * (s.widths[i] - typeset_width(s.numbers, text)), baseline}, colour, text);
    x += s.widths[i];
  }
}

}  // namespace

// Of a radiosity solution all that the emission is not.
std::string ambient_term(const App& app) {
  const Drawn drawn = drawn_in(app);
  if (!drawn.radiosity) return "I_ak_a";
  if (drawn.part == LightPart::unshot) return "ΔB";
  return draws_emission(app) ? "(B − E)" : "B";
}

float equation_height(const App& app, bool large) {
  const Fonts& f = app.look.fonts;
  return height_in_em * (large ? f.formula : f.math)->FontSize;
}

float row_height(const App& app) { return app.look.px(18); }

float draw_equation(App& app, ImVec2 at, float width, bool large, const std::vector<NumberRow>& rows,
                    const std::vector<NumberRow>& narrow_rows) {
  const std::optional<Isolated> peeked = std::exchange(app.peek, std::nullopt);
  Look& look = app.look;
  const Typesetting s = fitted(app, width, large, rows, narrow_rows);
  const float em = s.type.base->FontSize * s.type.scale, line = row_height(app) * s.type.scale;
  const float height = std::floor(height_in_em * em), baseline = at.y + std::floor(0.94f * em);
  float x = at.x + s.label_width;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    const Piece& piece = s.pieces[i];
    const float w = s.widths[i];
    ImGui::PushID(int(i));
    if (piece.quantity != Quantity::none)
      draw_term(app, piece, {x, at.y}, {x + w, at.y + height + float(s.rows->size()) * line}, baseline, s.type);
    else
      typeset(ImGui::GetWindowDrawList(), s.type, {x + 0.5f * (w - typeset_width(s.type, piece.markup)), baseline},
              look.palette.text, piece.markup);
    ImGui::PopID();
    x += w;
  }
  for (std::size_t r = 0; r < s.rows->size(); ++r)
    draw_row(app, s, (*s.rows)[r], at, at.y + height + (float(r) + 0.78f) * line);
  if (app.peek != peeked) app.animating = true;  // the pictures follow in the next frame
  return height + float(s.rows->size()) * line;
}

}  // namespace cg
