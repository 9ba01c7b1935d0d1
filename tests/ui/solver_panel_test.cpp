// The panel of the radiosity solver: every view of it in both languages, keys that step, and scenes that have nothing
// to solve or change under it.
#include "ui/solver_panel.h"

#include <algorithm>
#include <thread>

#include "raster/software.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "ui/equation.h"
#include "ui/radiosity_desk.h"
#include "ui/solver_plot.h"
#include "ui/state_dump.h"
#include "workbench/open.h"

namespace cg {
namespace {

class SolverPanelTest : public ImGuiTest {
 protected:
  SolverPanelTest() {
    app.techniques = {software_technique()};
    app.settings.side = Side::solver;
    app.scene = open_scene("models/cornell-box.json");
    app.scene.radiosity.patch_size = 0.5, app.scene.radiosity.resolution = 16, app.scene.radiosity.samples = 1;
    app.history.restart(app.scene);
  }
  void settle() {
    for (int i = 0; i < 4000; ++i) {
      window_frame();
      if (i > 2 && !solver_at_work(app) && !desk_of(app).state().busy) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "it does not come to rest";
  }
  SolverStateHandle now() { return solver_of(app).desk.state().newest; }
};

TEST_F(SolverPanelTest, EveryViewOfEverySolverInBothLanguages) {
  settle();
  for (int solver = 0; solver < int(solver_count); ++solver) {
    app.scene.radiosity.solver = RadiositySolver(solver);
    settle();
    ASSERT_NE(now(), nullptr);
    EXPECT_EQ(now()->task->options.solver, RadiositySolver(solver));
    solver_of(app).desk.step();
    settle();
    EXPECT_EQ(now()->step, 1u);
    for (const Language language : {Language::english, Language::japanese})
      for (const auto view : {SolverPanel::View::error, SolverPanel::View::matrix, SolverPanel::View::figures})
        for (const bool large : {false, true}) {
          app.settings.language = language;
          solver_of(app).view = view, solver_of(app).large = large;
          solver_of(app).over_time = large;
          settle();
        }
  }
}

TEST_F(SolverPanelTest, TheStateIsDrawnAndNeverKept) {
  settle();
  const Scene before = app.scene;
  solver_of(app).desk.go_to(7);
  settle();
  Scene drawn = scene_with_solution(app);
  EXPECT_EQ(drawn.radiosity_field, now()->field);
  EXPECT_EQ(app.scene, before);
  EXPECT_FALSE(app.history.can_undo());
  // One part of the light: nothing else shines.
  app.settings.solver_part = LightPart::received;
  settle();
  drawn = scene_with_solution(app);
  EXPECT_EQ(drawn.radiosity_field, now()->field);
  for (const Object& o : drawn.objects) EXPECT_EQ(o.material.emission, glm::dvec3(0));
  EXPECT_EQ(app.scene, before);
  // Another panel: the finished solution.
  app.settings.side = Side::plan;
  window_frame();
  drawn = scene_with_solution(app);
  EXPECT_EQ(drawn.radiosity_field, desk_of(app).state().newest.field);
  EXPECT_EQ(drawn.objects[0].material, before.objects[0].material);
}

TEST_F(SolverPanelTest, AScenesAmbientTermMayBeConstant) {
  app.scene.shading.ambient_source = AmbientSource::constant;
  settle();
  ASSERT_NE(now(), nullptr);
  EXPECT_EQ(scene_with_solution(app).shading.ambient_source, AmbientSource::radiosity);
  // The equation has the letters of what is drawn.
  EXPECT_EQ(ambient_term(app), "(B − E)");
  app.settings.solver_part = LightPart::unshot;
  settle();
  EXPECT_EQ(ambient_term(app), "ΔB");
  app.settings.solver_part = LightPart::indirect;
  settle();
  EXPECT_EQ(ambient_term(app), "B");
  app.settings.side = Side::none;
  EXPECT_EQ(scene_with_solution(app), app.scene);
  EXPECT_EQ(ambient_term(app), "I_ak_a");
}

// LU is one step: a line over time, and words where there are sweeps.
TEST_F(SolverPanelTest, LuIsDrawnOverTimeAndNamedOverSweeps) {
  const auto lines = [&](bool over_time) {
    const Plot plot = residual_plot(*solver_of(app).race.entries(), RadiositySolver::jacobi, nullptr,
                                    app.scene.radiosity.residual, over_time);
    std::size_t points = 0;
    for (const PlotPoint& p : plot.points) points += p.series == std::size_t(RadiositySolver::lu);
    return std::pair(plot.legend.size(), points);
  };
  EXPECT_FALSE(lu_note(*solver_of(app).race.entries()));
  settle();
  EXPECT_EQ(lines(true), (std::pair<std::size_t, std::size_t>(solver_count, 1)));
  EXPECT_EQ(lines(false), (std::pair<std::size_t, std::size_t>(solver_count - 1, 0)));
  EXPECT_TRUE(lu_note(*solver_of(app).race.entries()));
}

// What saves and opens a solution is to be seen without scrolling.
TEST_F(SolverPanelTest, FilesStandAboveTheFigures) {
  for (const Language language : {Language::english, Language::japanese}) {
    app.settings.language = language;
    solver_of(app).view = SolverPanel::View::figures;
    settle();
    app.dump = std::make_shared<StateDump>("");  // never written
    window_frame();
    for (const Words& label : {Words{"Save …", "保存…"}, Words{"Open …", "開く…"}}) {
      const Tree::List* corners = app.dump->placed("button:" + std::string(label.in(language)));
      ASSERT_TRUE(corners) << label.in(language);
      EXPECT_LT(*(*corners)[3].number(), 720);
    }
    app.dump = nullptr;
  }
}

// Presented, the panel stands where the lesson's text is, and its state is in the pictures.
TEST_F(SolverPanelTest, ItIsPresented) {
  app.presenter.on = true;
  settle();
  ASSERT_NE(now(), nullptr);
  solver_of(app).desk.step();
  settle();
  EXPECT_EQ(scene_with_solution(app).radiosity_field, now()->field);
  EXPECT_EQ(now()->step, 1u);
  perform(app, Do::solver);
  settle();
  EXPECT_NE(scene_with_solution(app).radiosity_field, now()->field);
}

TEST_F(SolverPanelTest, ScenesWithNextToNothing) {
  for (const char* model : {"plane", "cube"}) {
    app.scene = open_scene(model);
    set_parameter(app.scene, "objects.0.tessellation=1");
    load_meshes(app.scene);
    app.scene.radiosity.patch_size = 100;
    for (const auto view : {SolverPanel::View::error, SolverPanel::View::matrix, SolverPanel::View::figures}) {
      solver_of(app).view = view;
      settle();
      solver_of(app).desk.step();
      settle();
    }
    ASSERT_NE(now(), nullptr) << model;
  }
  app.scene.objects.clear();
  settle();
  EXPECT_EQ(now(), nullptr);
  EXPECT_TRUE(desk_of(app).state().message);
}

TEST_F(SolverPanelTest, TheSceneChangesUnderIt) {
  settle();
  SolverDesk& desk = solver_of(app).desk;
  desk.play();
  for (int i = 0; i < 40; ++i) {
    app.scene.objects[0].material.k_d = glm::dvec3(0.02 * i);
    if (i % 10 == 5) app.scene.objects[5].transform.translate.x += 0.01;
    if (i % 7 == 3) app.scene.radiosity.solver = RadiositySolver(i % int(solver_count));
    desk.finish();
    if (i % 3 == 0) desk.play();
    if (i % 5 == 0) desk.back();
    window_frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  desk.stop();
  settle();
  ASSERT_NE(now(), nullptr);
  EXPECT_TRUE(same_places(now()->task->scene, app.scene));
}

TEST_F(SolverPanelTest, ASolutionFromAFileHasNoFactors) {
  settle();
  SceneRadiosity solution = desk_of(app).state().newest;
  auto read = std::make_shared<RadiositySolution>(*solution.solution);
  read->matrix = nullptr;
  solution.solution = read;
  desk_of(app).take(app.scene, solution);
  for (int i = 0; i < 5; ++i) window_frame();
  EXPECT_EQ(now(), nullptr);
  EXPECT_EQ(desk_of(app).state().newest.solution, read);
  EXPECT_EQ(scene_with_solution(app).radiosity_field, solution.field);
  desk_of(app).solve_again();
  settle();
  EXPECT_NE(now(), nullptr);
}

}  // namespace
}  // namespace cg
