// The linear system of radiosity, (1 - rho F) B = E, solved step by step while the pictures show the light spread.
#include "ui/solver_panel.h"

#include <algorithm>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/radiosity_desk.h"
#include "ui/widgets.h"

namespace cg {
namespace {

void small_gap(const App& app) { ImGui::Dummy({1, app.look.px(4)}); }

void choose_view(App& app, SolverPanel& panel) {
  using View = SolverPanel::View;
  const Language l = app.language();
  const auto view = [&](const char* id, Words label, View v) {
    if (tab(app, id, label.in(l), panel.view == v)) panel.view = v;
    ImGui::SameLine(0, app.look.px(1));
  };
  view("error", {"Error", "誤差"}, View::error);
  view("matrix", {"Matrix", "行列"}, View::matrix);
  view("figures", {"Figures", "数値"}, View::figures);
  view("settings", {"Settings", "設定"}, View::settings);
  const std::string_view label = panel.large ? Words{"Small", "小さく"}.in(l) : Words{"Large", "大きく"}.in(l);
  const float wanted = ImGui::GetContentRegionMax().x - tab_width(app, label);
  if (panel.view == View::figures || panel.view == View::settings) return ImGui::NewLine();
  if (wanted < ImGui::GetCursorPosX()) ImGui::NewLine();
  ImGui::SetCursorPosX(wanted);
  if (tab(app, "large", label, panel.large)) panel.large = !panel.large;
}

// Why there is nothing to be stepped through.
void draw_nothing(App& app, const RadiosityDesk::State& radiosity) {
  const Language l = app.language();
  if (radiosity.busy) {
    small_text(app, Words{"Form factors are being computed.", "形態係数を計算している。"}.in(l), app.look.palette.dim);
    progress_bar(app, radiosity.fraction, ImGui::GetContentRegionAvail().x);
    app.next_frame = std::min(app.next_frame, app.now + 0.1);
  } else if (radiosity.newest.solution && !radiosity.newest.solution->matrix) {
    small_text(app,
               Words{"This solution was read from a file. It has no form factors to be solved with.",
                     "この解はファイルから読んだもので、解くための形態係数がない。"}
                   .in(l),
               app.look.palette.dim);
    if (button(app, "again", {.label = Words{"Compute them", "計算する"}.in(l), .chosen = true}))
      desk_of(app).solve_again();
  }
}

// Save the solution, open one.
void draw_files(App& app, bool there) {
  const Language l = app.language();
  small_gap(app);
  if (button(app, "save solution",
             {.label = Words{"Save …", "保存…"}.in(l),
              .tip = {"The solution as a PLY file, which other viewers show too",
                      "解を PLY ファイルに保存する。ほかのビューアでも見られる"},
              .enabled = there}) &&
      there)
    app.dialogue = {Dialogue::save_solution, "solution.ply", true};
  ImGui::SameLine(0, app.look.px(6));
  if (button(
          app, "open solution",
          {.label = Words{"Open …", "開く…"}.in(l),
           .tip = {"A solution of this scene from a file, in place of solving", "このシーンの解をファイルから読む"}}))
    app.dialogue = {Dialogue::open_solution, "solution.ply", true};
}

}  // namespace

SolverPanel& solver_of(App& app) {
  if (!app.solver) app.solver = std::make_shared<SolverPanel>(app.wake);
  return *app.solver;
}

bool shows_solver(const App& app) { return app.settings.side == Side::solver && app.solver; }

SolverStateHandle drawn_solver_state(const App& app) {
  if (!shows_solver(app)) return nullptr;
  SolverStateHandle state = app.solver->desk.state().newest;
  return state && same_places(state->task->scene, app.scene) ? state : nullptr;
}

void draw_solver_state(App& app, Scene& scene) {
  const SolverStateHandle state = drawn_solver_state(app);
  if (!state) return;
  scene.radiosity_field = state->field;
  scene.shading.ambient_source = AmbientSource::radiosity;
  if (state->part == LightPart::total) return;
  for (Light& light : scene.lights) light.enabled = false;
  scene.material.emission = glm::dvec3(0);
  for (Object& object : scene.objects) object.material.emission = glm::dvec3(0);
}

bool solver_at_work(const App& app) {
  if (!shows_solver(app)) return app.settings.side == Side::solver;
  const SolverPanel& panel = *app.solver;
  return (!panel.desk.playing() && panel.desk.state().busy) || panel.race.busy() || panel.matrix.busy();
}

void update_solver(App& app, SolverPanel& panel) {
  RadiosityDesk& radiosity = desk_of(app);
  radiosity.update(app.scene, true);
  const RadiosityDesk::State s = radiosity.state();
  const bool fits = s.newest.solution && s.newest.solution->matrix && same_places(s.solved, app.scene);
  const SolutionHandle solution = fits ? s.newest.solution : nullptr;
  panel.desk.take(solution, s.solved, app.scene.radiosity);
  panel.desk.show(app.settings.solver_part);
  panel.desk.advance(app.now, app.settings.solver_speed);
  panel.race.run(solution, app.scene.radiosity);
  if (panel.desk.playing()) app.animating = true;
}

bool draw_large_solver(App& app, ImVec2 size) {
  if (!shows_solver(app) || !app.solver->large) return false;
  SolverPanel& panel = *app.solver;
  if (panel.view != SolverPanel::View::error && panel.view != SolverPanel::View::matrix) return false;
  if (size.x < app.look.px(200) || size.y < app.look.px(160)) return false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, app.look.palette.panel);
  const SolverDesk::State state = panel.desk.state();
  const float inner = app.look.px(12);
  ImGui::SetCursorScreenPos({at.x + inner, at.y + inner});
  const ImVec2 room{size.x - 2 * inner, size.y - 2 * inner};
  if (ImGui::BeginChild("large solver", room, false, ImGuiWindowFlags_NoScrollbar)) {
    if (panel.view == SolverPanel::View::error)
      draw_solver_error(app, panel, state, room);
    else
      draw_solver_matrix(app, panel, state, room);
  }
  ImGui::EndChild();
  return true;
}

void draw_solver_panel(App& app) {
  SolverPanel& panel = solver_of(app);
  update_solver(app, panel);
  const RadiosityDesk::State radiosity = desk_of(app).state();
  const SolverDesk::State state = panel.desk.state();
  draw_solver_controls(app, panel, state);
  if (radiosity.message) small_text(app, radiosity.message->in(app.language()), app.look.palette.error);
  if (state.problem) small_text(app, state.problem->in(app.language()), app.look.palette.error);
  if (!state.newest) draw_nothing(app, radiosity);
  small_gap(app);
  choose_view(app, panel);
  if (panel.view == SolverPanel::View::settings) return draw_solver_settings(app, state);
  if (!state.newest) return draw_files(app, radiosity.newest.solution != nullptr);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float height = std::clamp(room.y, app.look.px(270), app.look.px(520));
  if (panel.view == SolverPanel::View::figures) {
    draw_files(app, true);
    small_gap(app);
    return draw_solver_figures(app, panel, state);
  }
  if (panel.large) return;
  if (panel.view == SolverPanel::View::error)
    draw_solver_error(app, panel, state, {room.x, height});
  else
    draw_solver_matrix(app, panel, state, {room.x, height});
}

}  // namespace cg
