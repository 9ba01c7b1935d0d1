// Where the lesson is, in one line: 03 Shading  2 / 6  Gouraud shading  ◀ ▶ Page Up / Page Down.
#include <algorithm>
#include <string>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/lesson_panel.h"
#include "ui/lesson_player.h"
#include "ui/widgets.h"

namespace cg {
namespace {

struct Piece {
  ImFont* font;
  ImU32 colour;
  std::string text;
};

// An arrow that goes one step; as wide as it is high.
void arrow(App& app, Do what, ImVec2 at, float side, bool enabled) {
  const Look& look = app.look;
  const bool forward = what == Do::next_step;
  ImGui::SetCursorScreenPos(at);
  const bool pressed = ImGui::InvisibleButton(forward ? "next step" : "previous step", {side, side});
  const bool hovered = ImGui::IsItemHovered() && enabled;
  if (wants_tooltip(app)) tooltip(app, {}, action(what).label.in(app.language()), action(what).keys);
  const float r = look.px(5), d = forward ? 1.0f : -1.0f;
  const ImVec2 c{at.x + 0.5f * side, at.y + 0.5f * side};
  const ImU32 colour = !enabled ? faded(look.palette.dim, 0.4f) : hovered ? look.palette.text : look.palette.dim;
  const ImVec2 a{c.x - d * r * 0.7f, c.y - r}, b{c.x - d * r * 0.7f, c.y + r}, tip{c.x + d * r, c.y};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  forward ? draw->AddTriangleFilled(a, b, tip, colour) : draw->AddTriangleFilled(a, tip, b, colour);
  if (pressed && enabled) perform(app, what);
}

}  // namespace

namespace {

constexpr std::string_view keys = "Page Up / Page Down";

float gap_of(const Look& look) { return look.px(14); }
float arrows_of(const Look& look) { return 2 * look.px(32) + look.px(2); }

// Title of the lesson, number of the step, title of the step.
std::vector<Piece> pieces_of_place(App& app) {
  const LessonPlayer& player = lessons_of(app);
  const LessonStep* step = player.current();
  if (!step) return {};
  const Look& look = app.look;
  const Language l = app.language();
  const std::string id = player.lesson()->id;
  const std::string number = id.substr(0, std::min(id.find_first_not_of("0123456789"), id.size()));
  const std::string where = std::to_string(player.step() + 1) + " / " + std::to_string(player.lesson()->steps.size());
  return {{look.fonts.text, look.palette.dim, (number.empty() ? "" : number + "  ") + player.lesson()->in(l).title},
          {look.fonts.mono, look.palette.text, where},
          {look.fonts.text, look.palette.text, step->in(l).title}};
}

float width_of(App& app, const std::vector<Piece>& pieces) {
  float w = 0;
  for (const Piece& p : pieces) w += text_width(p.font, noted(app, p.text)) + gap_of(app.look);
  return w;
}

}  // namespace

float lesson_place_width(App& app) {
  const std::vector<Piece> pieces = pieces_of_place(app);
  return pieces.empty() ? 0 : width_of(app, pieces) + arrows_of(app.look);
}

float draw_lesson_place(App& app, ImVec2 at, float room) {
  std::vector<Piece> pieces = pieces_of_place(app);
  Look& look = app.look;
  const float gap = gap_of(look), side = look.px(32), arrows = arrows_of(look);
  if (pieces.empty() || room < arrows + look.px(60)) return 0;
  // What does not fit goes: the lesson's title, then the step's.
  if (app.presenter.on) pieces.pop_back();  // it stands above the text
  if (width_of(app, pieces) + arrows > room) pieces.erase(pieces.begin());
  if (pieces.size() > 1 && width_of(app, pieces) + arrows > room) pieces.pop_back();
  const float taken = width_of(app, pieces), baseline = at.y + look.px(21.5f);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float x = at.x;
  for (const Piece& p : pieces) x += set_text(draw, p.font, {x, baseline}, p.colour, p.text) + gap;
  x -= gap * 0.4f;
  const LessonPlayer& player = lessons_of(app);
  arrow(app, Do::previous_step, {x, at.y}, side, player.has_previous());
  arrow(app, Do::next_step, {x + side + look.px(2), at.y}, side, player.has_next());
  x += arrows;
  if (taken + arrows + gap + text_width(look.fonts.small, keys) + look.px(24) <= room)
    x += set_text(draw, look.fonts.small, {x + look.px(4), baseline}, look.palette.dim, keys) + look.px(4);
  return x - at.x;
}

}  // namespace cg
