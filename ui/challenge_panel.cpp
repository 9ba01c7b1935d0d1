// "Match this picture": the target, the score, the hint; and where to begin.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app.h"
#include "ui/challenge_game.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr std::array<Name, 3> levels{
    {{"1", {"Easy", "易しい"}}, {"2", {"Medium", "ふつう"}}, {"3", {"Hard", "難しい"}}}};

void space(const App& app, float units) { ImGui::Dummy({1, app.look.px(units)}); }

std::string rounded(double v, int places) {
  const double power = std::pow(10.0, places);
  return number_text(std::round(v * power) / power, places, 12);
}

void choose_level(App& app, ChallengeGame& game, const Words& label) {
  int index = std::clamp(game.wanted_level, 1, int(levels.size())) - 1;
  if (choose(app, "level", levels, index)) game.wanted_level = index + 1;
  space(app, 2);
  if (button(app, "make", {.label = label.in(app.language())})) game.make_up(app, game.seed() + 1, index + 1);
}

// A preset that the lecturer hands out.
void choose_file(App& app, ChallengeGame& game) {
  heading(app, Words{"A preset as the target", "目標にするプリセット"}.in(app.language()));
  const std::string hint(noted(app, Words{"target.json", "target.json"}));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::InputTextWithHint("##target", hint.c_str(), &game.typed,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll) &&
      !game.typed.empty())
    game.from_file(app, game.typed);
}

void draw_choice(App& app, ChallengeGame& game) {
  const Language l = app.language();
  small_text(app,
             Words{"A picture is shown, its numbers are hidden. Turn the parameters until yours looks the same.",
                   "見本の絵だけを見て、同じ絵になるようにパラメータを調整する。数値は隠されている。"}
                 .in(l),
             app.look.palette.dim);
  space(app, 6);
  choose_level(app, game, {"Make one up", "問題を作る"});
  space(app, 6);
  if (button(app, "this",
             {.label = Words{"This scene is the target", "今のシーンを目標にする"}.in(l),
              .tip = {"The student begins with its models and camera and the defaults for the rest",
                      "モデルとカメラだけを残し、ほかは既定値から始める"}}))
    game.from_scene(app);
  space(app, 2);
  choose_file(app, game);
}

void draw_picture(App& app, const ChallengeGame& game) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  // What stands below it keeps its place in a low window.
  const float side = std::floor(std::min(room.x, std::max(room.y - look.px(190), look.px(120))));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 low{at.x + std::floor(0.5f * (room.x - side)), at.y}, high{low.x + side, low.y + side};
  if (game.picture().empty())
    draw->AddRectFilled(low, high, look.palette.pane, look.px(2));
  else
    draw->AddImage(game.picture().id(), low, high);
  ImGui::Dummy({room.x, side + look.px(6)});
}

void draw_score(App& app, const ChallengeGame& game) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const double value = game.score() ? game.score()->value : 0;
  const std::string points = game.score() ? rounded(value, 1) : "–";
  const std::string rmse = "RMSE " + (game.score() ? rounded(game.score()->rmse, 4) : std::string("–"));
  set_text(draw, look.fonts.formula, {at.x, at.y + look.px(26)}, look.palette.text, points);
  set_text(draw, look.fonts.small, {at.x + text_width(look.fonts.formula, points) + look.px(6), at.y + look.px(26)},
           look.palette.dim, "/ 100");
  set_text(draw, look.fonts.small_mono, {at.x + room - text_width(look.fonts.small_mono, rmse), at.y + look.px(26)},
           look.palette.dim, rmse);
  const float y = at.y + look.px(38), thick = look.px(2);
  draw->AddRectFilled({at.x, y - thick}, {at.x + room, y + thick}, look.palette.line, thick);
  draw->AddRectFilled({at.x, y - thick}, {at.x + room * float(value / 100), y + thick}, look.palette.accent, thick);
  ImGui::Dummy({room, look.px(46)});
}

void draw_hint(App& app, ChallengeGame& game) {
  const Language l = app.language();
  if (game.solved()) {
    small_text(app, Words{"The pictures are alike.", "同じ絵になった。"}.in(l), app.look.palette.text);
    return;
  }
  if (!game.hint || !game.score() || !game.score()->hint) return;
  small_text(app, hint_text(*game.score()->hint).in(l), app.look.palette.text);
}

void draw_differences(App& app, const ChallengeGame& game) {
  heading(app, Words{"Yours → the target", "自分の値 → 目標"}.in(app.language()));
  ImGui::PushFont(app.look.fonts.small_mono);
  ImGui::PushTextWrapPos(0);
  for (const ParameterDifference& d : game.differences()) write(app, text_of(d));
  if (game.differences().empty()) write(app, Words{"No parameter differs", "違うパラメータはない"});
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

// Buttons in as many lines as they need.
class ButtonFlow {
 public:
  explicit ButtonFlow(App& app) : app_(app), right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}
  bool operator()(const char* id, const Words& label, const Words& tip = {}, bool chosen = false) {
    const std::string_view text = noted(app_, label);
    const float gap = app_.look.px(6);
    if (std::exchange(any_, true) && ImGui::GetItemRectMax().x + gap + button_width(app_, text) <= right_)
      ImGui::SameLine(0, gap);
    return button(app_, id, {.label = text, .tip = tip, .chosen = chosen});
  }

 private:
  App& app_;
  float right_;
  bool any_ = false;
};

void draw_buttons(App& app, ChallengeGame& game) {
  ButtonFlow flow(app);
  if (!game.solved() && !game.given_up()) {
    if (flow("hint", {"Hint", "ヒント"}, {"Which term is furthest off", "いちばん違う項を示す"}, game.hint))
      game.hint = !game.hint;
    if (flow("give up", {"Give up", "あきらめる"}, {"Shows which parameters differ", "違うパラメータを見せる"}))
      game.give_up(app);
  }
  if (game.seed() > 0 && flow("next", {"A new one", "次の問題"})) game.make_up(app, game.seed() + 1, game.level());
  if (flow("end", {"End", "終わる"})) game.end();
}

}  // namespace

void draw_challenge_panel(App& app) {
  ChallengeGame& game = game_of(app);
  if (!game.playing()) return draw_choice(app, game);
  draw_picture(app, game);
  draw_score(app, game);
  draw_buttons(app, game);
  if (!game.playing()) return;
  draw_hint(app, game);
  if (game.given_up()) draw_differences(app, game);
}

}  // namespace cg
