// Classic errors, put in on purpose, and what they do; and the quiz that hides their names.
#include <chrono>
#include <cmath>

#include "params/slots.h"
#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/mistake_jobs.h"
#include "ui/number.h"
#include "ui/quiz.h"
#include "ui/widgets.h"

namespace cg {
namespace {

MistakeJobs& jobs_of(App& app) {
  if (!app.mistake_jobs) app.mistake_jobs = std::make_shared<MistakeJobs>();
  return *app.mistake_jobs;
}

void small_gap(const App& app) { ImGui::Dummy({1, app.look.px(4)}); }

void ask_for_effects(App& app, const std::vector<std::string>& names) {
  View view{320, 320};
  if (const DrawingHandle& drawing = app.drawings[0]; drawing && drawing->frame.colour.height() > 0)
    view.width = std::clamp(320 * drawing->frame.colour.width() / drawing->frame.colour.height(), 64, 1280);
  jobs_of(app).want(app.scene, names, view, app.wake);
}

// How far the pictures are apart, where one of them is drawn with the mistakes.
void draw_distance(App& app) {
  const Language l = app.language();
  const auto is_fixed = [&](int i) {
    return i >= 0 && i < int(app.techniques.size()) && app.techniques[std::size_t(i)].id == "gl-fixed";
  };
  if (is_fixed(app.left) == is_fixed(app.right)) {
    small_text(app,
               Words{"Mistakes show in OpenGL's fixed function alone; beside it stands the right picture.",
                     "間違いは OpenGL 固定機能の絵だけに現れる。隣に正しい絵を並べること。"}
                   .in(l),
               app.look.palette.dim);
    if (button(app, "show fixed", {.label = Words{"Show both", "並べて表示"}.in(l)})) show_gl_fixed(app);
    return;
  }
  const Figures& f = app.figures;
  pair_line(app, Words{"Both pictures: RMSE", "二枚の絵の RMSE"}.in(l), f.valid ? number_text(f.rmse, 0, 7) : "–",
            app.look.palette.text);
}

void draw_effect(App& app, const std::string& name) {
  const Language l = app.language();
  const std::optional<MistakeEffect> effect = jobs_of(app).of(name);
  if (!effect) return small_text(app, "…", app.look.palette.dim);
  small_text(app, effect->text.in(l), app.look.palette.text);
  if (effect->shows) return;
  if (button(app, "let it show",
             {.label = Words{"Let it show", "見えるようにする"}.in(l),
              .tip = {"Changes the scene as little as needed", "シーンを必要なだけ変える"}}))
    let_it_show(app.scene, name);
  ImGui::SameLine(0, app.look.px(4));
}

void draw_mistake(App& app, const Slot& slot) {
  const Language l = app.language();
  bool& on = **std::get_if<bool*>(&slot.value);
  ImGui::PushID(slot.path.c_str());
  if (toggle(app, "on", slot.about->label.in(l), on) && on) {
    show_gl_fixed(app);
    show_guilty_line(app, slot.path);
  }
  if (!on && wants_tooltip(app)) tooltip(app, {}, slot.about->help.in(l), slot.about->gl);
  if (on) {
    small_text(app, slot.about->help.in(l), app.look.palette.dim);
    draw_effect(app, slot.path);
    if (button(app, "line", {.label = Words{"Show the line", "その行を見る"}.in(l), .quiet = true}))
      show_guilty_line(app, slot.path);
    small_gap(app);
  }
  ImGui::PopID();
}

void draw_switches(App& app) {
  const Language l = app.language();
  if (button(app, "quiz",
             {.label = Words{"Quiz: which line is wrong?", "クイズ：どの行が間違い？"}.in(l),
              .tip = {"A mistake is put in without its name", "名前を隠して間違いを一つ入れる"}}))
    begin_quiz(app, std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count()));
  if (app.quiz) return;
  small_gap(app);
  const Slots all = slots(app.scene.mistakes);
  std::vector<std::string> on;
  for (const Slot& slot : all)
    if (**std::get_if<bool*>(&slot.value)) on.push_back(slot.path);
  ask_for_effects(app, on);
  draw_distance(app);
  for (const Slot& slot : all) draw_mistake(app, slot);
  small_gap(app);
  if (button(app, "reset", {.label = Words{"All right again", "すべて元に戻す"}.in(l), .enabled = !on.empty()}))
    app.scene.mistakes = {};
}

// The names to pick from, folded: the line is the better answer.
void draw_names(App& app) {
  if (!section(app, "names", {"Or pick its name", "名前で答える"}, false)) return;
  const Language l = app.language();
  Mistakes names;
  for (const Slot& slot : slots(names)) {
    ImGui::PushID(slot.path.c_str());
    if (button(app, "name", {.label = slot.about->label.in(l), .tip = slot.about->help})) answer_name(app, slot.path);
    ImGui::PopID();
  }
}

void draw_question(App& app) {
  const Language l = app.language();
  write(app, Words{"Which line is wrong?", "どの行が間違い？"});
  small_text(app,
             Words{"The left picture has one mistake, the right one none. Click the line in the program below.",
                   "左の絵には間違いが一つある（右は正しい）。下のプログラムで、その行をクリックすること。"}
                 .in(l),
             app.look.palette.dim);
  small_gap(app);
  if (button(app, "missing",
             {.label = Words{"A line is missing", "足りない行がある"}.in(l),
              .tip = {"The mistake is that a line is not there", "あるべき行がないのが間違い"}}))
    answer_missing(app);
  draw_names(app);
}

void draw_answer(App& app) {
  const Language l = app.language();
  MistakeQuiz& quiz = app.quiz->quiz;
  const std::string name(quiz.mistake());
  ImGui::PushFont(app.look.fonts.bold);
  write(app, *quiz.answered() ? Words{"✓ Right", "✓ 正解"} : Words{"✗ Not that one", "✗ 不正解"});
  ImGui::PopFont();
  const Slots all = slots(app.scene.mistakes);
  const About& about = *find_slot(all, name).about;
  small_gap(app);
  write(app, about.label);
  small_text(app, about.help.in(l), app.look.palette.text);
  ask_for_effects(app, {name});
  draw_effect(app, name);
  small_gap(app);
  if (button(app, "next", {.label = Words{"Next", "次の問題"}.in(l), .chosen = true})) next_question(app);
}

void draw_quiz(App& app) {
  const Language l = app.language();
  const MistakeQuiz& quiz = app.quiz->quiz;
  const int done = quiz.asked() - (quiz.answered() ? 0 : 1);
  pair_line(app, Words{"Right answers", "正解数"}.in(l), std::to_string(quiz.right()) + " / " + std::to_string(done),
            app.look.palette.text);
  draw_distance(app);
  small_gap(app);
  ImGui::PushTextWrapPos(0);
  quiz.answered() ? draw_answer(app) : draw_question(app);
  ImGui::PopTextWrapPos();
  small_gap(app);
  if (button(app, "leave", {.label = Words{"Leave the quiz", "クイズを終える"}.in(l)})) leave_quiz(app);
}

}  // namespace

void draw_mistakes_panel(App& app) { app.quiz ? draw_quiz(app) : draw_switches(app); }

}  // namespace cg
