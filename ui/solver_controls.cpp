// How the solver is driven: which one, where it stops, a step forward and back, play, and what of the light is seen.
#include <algorithm>
#include <cmath>

#include "measure/verdict.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/lines.h"
#include "ui/number.h"
#include "ui/parameter.h"
#include "ui/solver_panel.h"
#include "ui/widgets.h"

namespace cg {
namespace {

bool shoots(RadiositySolver solver) {
  return solver == RadiositySolver::southwell || solver == RadiositySolver::progressive;
}

// A button in the small face: as many stand in a line as a recorder has.
bool key(App& app, const char* id, std::string_view label, const Words& tip, bool enabled, bool chosen = false) {
  Look& look = app.look;
  label = noted(app, label);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{text_width(look.fonts.small, label) + look.px(22), look.px(30)};
  const bool pressed = ImGui::InvisibleButton(id, size) && enabled;
  note_place(app, "button", id);
  const ImU32 face = chosen                              ? look.palette.accent
                     : enabled && ImGui::IsItemHovered() ? look.palette.raised_hover
                                                         : look.palette.raised;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + size.x, at.y + size.y}, face, look.px(4));
  set_text(draw, look.fonts.small, {at.x + look.px(11), at.y + look.px(20)},
           chosen    ? look.palette.on_accent
           : enabled ? look.palette.text
                     : faded(look.palette.dim, 0.6f),
           label);
  if (wants_tooltip(app)) tooltip(app, {}, tip.in(app.language()), {});
  ImGui::SameLine(0, look.px(4));
  return pressed;
}

void draw_keys(App& app, SolverDesk& desk, const SolverDesk::State& state) {
  const SolverState* now = state.newest.get();
  const bool before = now && now->step > 0, after = now && now->end == SolverEnd::none;
  const bool shot = now && shoots(now->task->options.solver);
  if (key(app, "solver reset", "|◀", {"Back to the beginning, B = E", "最初（B = E）に戻る"}, before)) desk.reset();
  if (key(app, "solver back", "◀", {"A step back", "1 ステップ戻る"}, before)) desk.back();
  const bool on = desk.playing();
  const Words play = on ? Words{"Pause", "停止"} : Words{"Play", "再生"};
  if (key(app, "solver play", play.in(app.language()),
          {"Steps on by itself; the light spreads in the pictures", "自動で進める。光の広がりが画像に出る"},
          after || on, on))
    on ? desk.stop() : desk.play();
  if (key(app, "solver step", "▶",
          shot ? Words{"One shot: the patch with the most unshot light lights all others",
                       "1 ステップ：未放出の光が最も多いパッチから放出する"}
               : Words{"One step: a row of the matrix, the light that one patch gathers",
                       "1 ステップ：行列の 1 行、1 つのパッチが光を集める"},
          after))
    desk.step();
  if (key(app, "solver sweep", "▶▶",
          {"To the end of the sweep: as many steps as there are patches",
           "スイープの終わりまで（パッチの数だけのステップ）"},
          after))
    desk.sweep();
  const bool running = now && state.busy && !on && now->end == SolverEnd::none;
  if (running && state.fraction < 1) app.next_frame = std::min(app.next_frame, app.now + 0.1);
  if (key(app, "solver end", "▶|", {"Until it ends", "終わりまで"}, after)) desk.finish();
  ImGui::NewLine();
}

// The step that the solver ends at, as far as it is known.
std::size_t last_step(const SolverPanel& panel, const SolverDesk::State& state) {
  if (!state.newest) return 1;
  const auto& entry = (*panel.race.entries())[std::size_t(state.newest->task->options.solver)];
  const std::size_t known = entry.curve.empty() ? 0 : entry.curve.back().step;
  return std::max({known, state.furthest, state.newest->step, std::size_t(1)});
}

// Shots count the less the later they are.
double position_of(std::size_t step, std::size_t last, bool logarithmic) {
  return logarithmic ? std::log1p(double(step)) / std::log1p(double(last)) : double(step) / double(last);
}
std::size_t step_at(double position, std::size_t last, bool logarithmic) {
  const double t = std::clamp(position, 0.0, 1.0);
  return std::size_t(std::round(logarithmic ? std::expm1(t * std::log1p(double(last))) : t * double(last)));
}

void draw_scrubber(App& app, SolverPanel& panel, const SolverDesk::State& state) {
  Look& look = app.look;
  const SolverState* now = state.newest.get();
  const bool logarithmic = now && shoots(now->task->options.solver);
  const std::size_t last = last_step(panel, state), step = now ? now->step : 0;
  const float room = ImGui::GetContentRegionAvail().x;
  double position = position_of(step, last, logarithmic);
  if (slider(app, "solver scrubber", position, look.palette.accent, false, {room, look.px(22)}) && now)
    panel.desk.go_to(step_at(position, last, logarithmic));
  note_place(app, "slider", "solver step");
  std::string left = std::string(Words{"Step ", "ステップ "}.in(app.language())) + std::to_string(step);
  if (now && now->task->options.solver != RadiositySolver::lu)
    left += "  " + Text("sweep " + rounded(now->sweeps, 2), "スイープ " + rounded(now->sweeps, 2)).in(app.language());
  small_pair_line(app, left, std::to_string(last), look.palette.dim);
}

void draw_speed(App& app) {
  Look& look = app.look;
  const Slots all = slots(app.settings);
  const Slot& slot = find_slot(all, "solver_speed");
  double& speed = app.settings.solver_speed;
  const float room = ImGui::GetContentRegionAvail().x, height = look.px(24);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string_view label = noted(app, Words{"Speed", "速さ"});
  const std::string shown = short_number(speed) + (app.language() == Language::japanese ? " /秒" : " /s");
  const float left = text_width(look.fonts.small, label) + look.px(10), right = look.px(84);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.small, {at.x, at.y + look.px(17)}, look.palette.dim, label);
  ImGui::SetCursorScreenPos({at.x + left, at.y});
  double position = slider_position(*slot.about, speed);
  if (slider(app, "solver speed", position, look.of(Quantity::none), false, {room - left - right, height}))
    speed = slider_value(*slot.about, position, false);
  if (wants_tooltip(app)) tooltip(app, slot.about->label.in(app.language()), slot.about->help.in(app.language()), {});
  const float w = text_width(look.fonts.small_mono, noted(app, shown));
  set_text(draw, look.fonts.small_mono, {at.x + room - w, at.y + look.px(17)}, look.palette.text, shown);
}

void choose_solver(App& app) {
  RadiositySolver& solver = app.scene.radiosity.solver;
  const auto label = [&](std::size_t i) { return std::string(noted(app, names_of<RadiositySolver>[i].label)); };
  if (!begin_list(app, "##solver", label(std::size_t(solver)).c_str(), ImGui::GetContentRegionAvail().x)) return;
  for (std::size_t i = 0; i < names_of<RadiositySolver>.size(); ++i)
    if (ImGui::Selectable(label(i).c_str(), solver == RadiositySolver(int(i)))) solver = RadiositySolver(int(i));
  ImGui::EndCombo();
}

// Words that stand side by side in a narrow panel.
constexpr std::array<Words, names_of<LightPart>.size()> part_names{
    {{"Total", "全体"}, {"Unshot", "未放出"}, {"Received", "受光"}, {"Indirect", "間接光"}}};

void choose_part(App& app) {
  const float gap = app.look.px(3), right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < names_of<LightPart>.size(); ++i) {
    const std::string_view label = noted(app, part_names[i]);
    if (i > 0 && ImGui::GetItemRectMax().x + gap + tab_width(app, label) <= right) ImGui::SameLine(0, gap);
    ImGui::PushID(int(i));
    if (tab(app, "part", label, app.settings.solver_part == LightPart(int(i))))
      app.settings.solver_part = LightPart(int(i));
    ImGui::PopID();
  }
}

// How far it is or why it ended, on one line from its first step on: what lies below stays where it is.
void draw_progress(App& app, const SolverState& now) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  if (!now.message.en.empty())
    return small_text(app, now.message.in(l), now.end == SolverEnd::diverges ? p.error : p.text);
  if (now.end == SolverEnd::converged)
    return small_text(
        app, Words{"Converged: the error is below the residual.", "収束した（誤差は残差の指定以下）。"}.in(l), p.text);
  const std::string error = now.curve.empty() ? "…" : number_text(now.curve.back().error_bound, 0, 7);
  const std::string wanted = number_text(now.task->options.residual, 0, 7);
  small_text(
      app,
      Text("Error at most " + error + ", wanted " + wanted, "誤差 " + error + " 以下（指定 " + wanted + "）").in(l),
      p.dim);
}

// That what is seen is brighter than it is.
void draw_remarks(App& app, const SolverState& now) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  draw_progress(app, now);
  if (now.brightest == 0)
    small_text(app, Words{"Nothing in the scene emits light.", "このシーンには発光するものがない。"}.in(l), p.dim);
  if (now.gain > 1) {
    const std::string gain = number_text(now.gain, 0, 12);
    small_text(app, Text("Shown " + gain + " times as bright", gain + " 倍の明るさで表示").in(l), p.dim);
  }
}

}  // namespace

void draw_solver_controls(App& app, SolverPanel& panel, const SolverDesk::State& state) {
  choose_solver(app);
  draw_keys(app, panel.desk, state);
  draw_scrubber(app, panel, state);
  draw_speed(app);
  choose_part(app);
  if (state.newest) draw_remarks(app, *state.newest);
}

void draw_solver_settings(App& app, const SolverDesk::State& state) {
  const Slots all = slots(app.scene);
  parameters(app, all, "radiosity.", {"residual", "normalise", "memory"});
  small_text(
      app,
      Words{
          "Rows of a closed scene sum to 1. Where they sum to 1 + δ, a bounce returns ρ(1 + δ) of the light: the "
          "error grows to ρδ/(1 − ρ − ρδ), and at ρ(1 + δ) ≥ 1 no solver converges. Leave the rows as they are "
          "and bring ρ near 1 to see it.",
          "閉じたシーンの行の和は 1。和が 1 + δ だと 1 回の反射で光の ρ(1 + δ) が返り、誤差は ρδ/(1 − ρ − ρδ) に増え、"
          "ρ(1 + δ) ≥ 1 ではどの解法も収束しない。行をそのままにして ρ を 1 に近づけると確かめられる。"}
          .in(app.language()),
      app.look.palette.dim);
  if (!state.newest) return;
  const MatrixFigures& m = state.newest->task->solution->figures.matrix;
  if (m.rows > 0)
    small_pair_line(app, Words{"Row sums", "行の和"}.in(app.language()),
                    short_number(m.least_sum, 6) + " – " + short_number(m.greatest_sum, 6), app.look.palette.text);
}

}  // namespace cg
