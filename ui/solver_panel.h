// What the window keeps for the panel of the radiosity solver.
#pragma once
#include <memory>

#include "ui/matrix_view.h"
#include "ui/plot_view.h"
#include "ui/solver_desk.h"
#include "ui/solver_race.h"

namespace cg {

struct App;

// Made and let go while the window's OpenGL context is there, where there is one.
struct SolverPanel {
  explicit SolverPanel(const std::function<void()>& wake) : desk(wake), race(wake), matrix(wake) {}

  enum class View { error, matrix, figures, settings } view = View::error;
  bool over_time = false;  // the plot
  bool large = false;      // plot or matrix in place of the pictures
  SolverDesk desk;
  SolverRace race;
  MatrixView matrix;
  PlotView plot_view;
  // The plot and what it was made of.
  std::shared_ptr<const Plot> plot;
  std::shared_ptr<const SolverRace::Entries> plotted;
  SolverStateHandle plotted_state;
  bool plotted_over_time = false;
};

// The window's own, made at the first call.
SolverPanel& solver_of(App& app);

// Whether the panel is open.
bool shows_solver(const App& app);
// What the panes draw in place of the solution; null where they do not.
SolverStateHandle drawn_solver_state(const App& app);
// The scene with the solver's state drawn in it instead of the solution: of one part of the light alone neither lamps
// nor what emits. As it was where there is no state of it.
void draw_solver_state(App& app, Scene& scene);
// Something of the panel is still being made: for tests and screenshots.
bool solver_at_work(const App& app);

// Once a frame while the panel is open: gives the newest solution to the solver, and goes on where it plays.
void update_solver(App& app, SolverPanel& panel);

// The parts of the panel, at ImGui's cursor.
void draw_solver_controls(App& app, SolverPanel& panel, const SolverDesk::State& state);
void draw_solver_error(App& app, SolverPanel& panel, const SolverDesk::State& state, ImVec2 size);
void draw_solver_matrix(App& app, SolverPanel& panel, const SolverDesk::State& state, ImVec2 size);
void draw_solver_settings(App& app, const SolverDesk::State& state);
void draw_solver_figures(App& app, SolverPanel& panel, const SolverDesk::State& state);

}  // namespace cg
