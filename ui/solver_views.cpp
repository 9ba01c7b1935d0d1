// What is seen of the solver: the error of all five, the matrix, the figures.
#include <algorithm>
#include <cmath>

#include "measure/verdict.h"
#include "params/numbers.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/lines.h"
#include "ui/radiosity_desk.h"
#include "ui/solver_panel.h"
#include "ui/solver_plot.h"
#include "ui/widgets.h"
#include "workbench/measured_plan.h"
#include "workbench/patch_lines.h"

namespace cg {
namespace {

void keep_plot(App& app, SolverPanel& panel, const SolverStateHandle& now) {
  const auto entries = panel.race.entries();
  if (panel.plot && panel.plotted == entries && panel.plotted_state == now &&
      panel.plotted_over_time == panel.over_time)
    return;
  panel.plot = std::make_shared<const Plot>(
      residual_plot(*entries, app.scene.radiosity.solver, now.get(), app.scene.radiosity.residual, panel.over_time));
  panel.plotted = entries, panel.plotted_state = now, panel.plotted_over_time = panel.over_time;
}

// Which of the five do not run, and why; that they still run.
void draw_race_remarks(App& app, SolverPanel& panel) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  if (panel.race.needs_leave()) {
    small_text(
        app,
        Words{"The other solvers do not run by themselves where there are many patches, or rows are computed anew.",
              "パッチが多いとき、行を計算し直すときは、ほかの解法は自動では実行しない。"}
            .in(l),
        p.dim);
    if (button(app, "race", {.label = Words{"Run all five", "5 つとも実行"}.in(l)})) panel.race.allow();
  }
  const auto entries = panel.race.entries();
  Text diverging;
  for (std::size_t k = 0; k < solver_count; ++k) {
    if (const auto& problem = (*entries)[k].problem) small_text(app, problem->in(l), p.dim);
    if ((*entries)[k].end != SolverEnd::diverges) continue;
    const Words& name = short_name(RadiositySolver(k));
    diverging.en += (diverging.en.empty() ? "Diverge: " : ", ") + std::string(name.en);
    diverging.ja += (diverging.ja.empty() ? "発散：" : "、") + std::string(name.ja);
  }
  if (!diverging.en.empty()) small_text(app, diverging.in(l), p.error);
}

std::string number(double v, int digits = 3) { return short_number(v, digits); }

std::string colour(const glm::dvec3& v) { return number(v.x, 2) + "  " + number(v.y, 2) + "  " + number(v.z, 2); }

const Object& object_of(const App& app, const Patch& patch) { return app.scene.objects[patch.object]; }

// The two patches of an entry light up in the pictures.
void point_at(App& app, const RadiositySolution& s, std::size_t i, std::size_t j) {
  const auto& patches = s.patches->patches;
  if (i < patches.size()) app.pointed_next.push_back(patch_lines(patches[i], Mark::patch));
  if (j < patches.size() && j != i) app.pointed_next.push_back(patch_lines(patches[j], Mark::other_patch));
}

std::string named(const App& app, const Patch& patch) {
  if (patch.object >= app.scene.objects.size()) return {};
  const std::string& name = object_of(app, patch).name;
  return name.empty() ? std::string() : "  " + name;
}

// The entry under the mouse; else the row of the next step.
void draw_entry(App& app, const SolverState& now, const MatrixCell* cell, MatrixChannel channel) {
  const RadiositySolution& s = *now.task->solution;
  const auto& patches = s.patches->patches;
  const Language l = app.language();
  const Palette& p = app.look.palette;
  const auto line = [&](const std::string& left, const std::string& right) {
    small_pair_line(app, left, right, p.text);
  };
  const auto rho = [&](std::size_t i) { return number(reflectance_of(patches[i].reflectance, channel)); };
  if (cell) {
    const std::size_t i = cell->i, j = cell->j;
    line("i = " + std::to_string(i) + named(app, patches[i]), "ρ " + rho(i));
    line("j = " + std::to_string(j) + named(app, patches[j]),
         "F " + number(i < s.matrix->kept_rows() ? s.matrix->at(i, j) : 0, 4));
    line(i == j ? "1 − ρF" : "−ρF", number(cell->value, 4));
    return point_at(app, s, i, j);
  }
  if (!now.active || *now.active >= patches.size()) {
    small_text(
        app,
        Words{"Rest the mouse on an entry: its two patches light up.", "要素にマウスを置くと 2 つのパッチが光る。"}.in(
            l),
        p.dim);
    return;
  }
  const std::size_t i = *now.active;
  const bool shot = now.task->options.solver == RadiositySolver::southwell ||
                    now.task->options.solver == RadiositySolver::progressive;
  line(std::string((shot ? Words{"Next: column ", "次は列 "} : Words{"Next: row ", "次は行 "}).in(l)) +
           std::to_string(i) + named(app, patches[i]),
       "ρ " + rho(i));
  if (i < s.matrix->kept_rows()) line("Σ F", number(s.matrix->row_sum(i), 7));
  point_at(app, s, i, i);
}

// From the faintest to the brightest magnitude: what is nothing, negative, positive.
void draw_legend(App& app, const MatrixPicture& p, float width) {
  Look& look = app.look;
  const MatrixColours c = matrix_colours(app.settings.theme);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const std::string low = p.least > 0 ? number(double(p.least), 1) : "0", high = "1";
  const float text = text_width(look.fonts.small_mono, low) + look.px(6),
              end = text_width(look.fonts.small_mono, high) + look.px(6);
  const float baseline = at.y + look.px(15), half = look.px(6);
  set_text(draw, look.fonts.small_mono, {at.x, baseline}, look.palette.dim, low);
  set_text(draw, look.fonts.small_mono, {at.x + width - end + look.px(6), baseline}, look.palette.dim, high);
  const float from = at.x + text, to = at.x + width - end;
  const auto ink = [&](const glm::u8vec3& full, float t) {
    const glm::vec3 v = glm::vec3(c.none) + t * (glm::vec3(full) - glm::vec3(c.none));
    return IM_COL32(int(v.x), int(v.y), int(v.z), 255);
  };
  const float faint = matrix_brightness(p.least > 0 ? p.least : 1e-6f, p.least > 0 ? p.least : 1e-6f);
  for (const auto& [full, y] : {std::pair{c.negative, at.y + look.px(4)}, {c.positive, at.y + look.px(4) + half}})
    draw->AddRectFilledMultiColor({from, y}, {to, y + half}, ink(full, faint), ink(full, 1), ink(full, 1),
                                  ink(full, faint));
  ImGui::Dummy({width, look.px(22)});
}

void choose_channel(App& app, MatrixChannel& channel) {
  constexpr std::array<Words, 4> names{{{"mean ρ", "ρ の平均"}, {"R", "R"}, {"G", "G"}, {"B", "B"}}};
  for (int i = 0; i < 4; ++i) {
    if (i > 0) ImGui::SameLine(0, app.look.px(3));
    ImGui::PushID(i);
    if (tab(app, "channel", names[std::size_t(i)].in(app.language()), channel == MatrixChannel(i)))
      channel = MatrixChannel(i);
    ImGui::PopID();
  }
}

Text rows_text(const FormFactorMatrix& m) {
  const std::string n = std::to_string(m.size()), kept = std::to_string(m.kept_rows());
  const bool dense = m.storage() == Storage::dense;
  if (m.whole()) return {n + (dense ? ", dense" : ", sparse"), n + (dense ? "、密" : "、疎")};
  return {kept + " of " + n + " kept" + (dense ? ", dense" : ", sparse"),
          n + " 行中 " + kept + " 行を保存" + (dense ? "、密" : "、疎")};
}

}  // namespace

void draw_solver_error(App& app, SolverPanel& panel, const SolverDesk::State& state, ImVec2 size) {
  const Language l = app.language();
  const float from = ImGui::GetCursorPosY();
  ImGui::PushID("axis");
  if (tab(app, "sweeps", Words{"Over sweeps", "スイープ"}.in(l), !panel.over_time)) panel.over_time = false;
  ImGui::SameLine(0, app.look.px(3));
  if (tab(app, "time", Words{"Over time", "計算時間"}.in(l), panel.over_time)) panel.over_time = true;
  ImGui::PopID();
  draw_race_remarks(app, panel);
  if (const auto note = lu_note(*panel.race.entries()); note && !panel.over_time)
    small_text(app, note->in(l), app.look.palette.dim);
  keep_plot(app, panel, state.newest);
  const float height = std::max(size.y - (ImGui::GetCursorPosY() - from), app.look.px(220));
  draw_plot(app, panel.plot_view, "solver plot", panel.plot, {size.x, height}, int(place_index));
}

void draw_solver_matrix(App& app, SolverPanel& panel, const SolverDesk::State& state, ImVec2 size) {
  if (!state.newest) return;
  const SolverState& now = *state.newest;
  const float from = ImGui::GetCursorPosY();
  choose_channel(app, panel.matrix.channel);
  const float room = size.y - (ImGui::GetCursorPosY() - from), gap = app.look.px(16), below = app.look.px(88);
  const bool wide = size.x - room > app.look.px(240);  // what is said stands beside it
  const float side = std::floor(std::min(size.x, std::max(wide ? room : room - below, app.look.px(150))));
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale, at = ImGui::GetCursorScreenPos();
  panel.matrix.want(now.task->solution, int(side * scale.x), panel.matrix.channel);
  const MatrixCell* cell = panel.matrix.draw(app, side, &now);
  const auto tell = [&](float width) {
    if (const auto picture = panel.matrix.picture()) draw_legend(app, *picture, width);
    draw_entry(app, now, cell, panel.matrix.channel);
  };
  if (!wide) return tell(side);
  const float width = size.x - side - gap;
  ImGui::SetCursorScreenPos({at.x + side + gap, at.y});
  if (ImGui::BeginChild("matrix words", {width, side})) tell(std::min(width, app.look.px(320)));
  ImGui::EndChild();
}

void draw_solver_figures(App& app, SolverPanel&, const SolverDesk::State& state) {
  const SolverState& now = *state.newest;
  const RadiositySolution& s = *now.task->solution;
  const Language l = app.language();
  const Palette& p = app.look.palette;
  const auto line = [&](Words words, const std::string& right) { small_pair_line(app, words.in(l), right, p.text); };
  line({"Patches", "パッチ"}, std::to_string(s.patches->patches.size()));
  if (s.patches->elements.size() != s.patches->patches.size())
    line({"Elements", "要素"}, std::to_string(s.patches->elements.size()));
  line({"Rows of F", "F の行"}, rows_text(*s.matrix).in(l));
  if (!s.matrix->whole())
    small_text(
        app,
        Words{"The other rows are computed anew whenever they are asked for.", "残りの行は必要になるたびに計算し直す。"}
            .in(l),
        p.dim);
  line({"Memory", "メモリ"}, size_text(s.matrix->bytes()));
  const MatrixFigures& m = s.figures.matrix;
  if (m.rows > 0) line({"Row sums", "行の和"}, number(m.least_sum, 5) + " – " + number(m.greatest_sum, 5));
  ImGui::Dummy({1, app.look.px(6)});
  line({"Step", "ステップ"}, std::to_string(now.step));
  line({"Sweep", "スイープ"}, number(now.sweeps, 4));
  const double brightest = std::max(now.brightest, 1e-300);
  line({"Residual / brightest B", "残差 ÷ B の最大値"}, now.residual ? number(*now.residual / brightest) : "…");
  line({"times 1/(1 − ρ_max)", "× 1/(1 − ρ_max)"}, number(now.error_factor));
  line({"Error bound, last sweep", "誤差の上限（前のスイープ）"},
       now.curve.empty() ? "…" : number(now.curve.back().error_bound));
  if (now.task->options.solver == RadiositySolver::progressive)
    line({"Ambient estimate", "環境光の推定"}, colour(now.ambient));
  ImGui::Dummy({1, app.look.px(6)});
  for (const Text& text : report_of(s)) small_text(app, text.in(l), p.dim);
}

}  // namespace cg
