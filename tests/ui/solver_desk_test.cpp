// The solver beside the window: it goes where it is sent, forward and back to the same light, says what it cannot, and
// nothing waits for it.
#include "ui/solver_desk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ui/solver_plot.h"
#include "ui/solver_race.h"
#include "workbench/model_library.h"
#include "workbench/open.h"
#include "workbench/scene_radiosity.h"

namespace cg {
namespace {

using Clock = std::chrono::steady_clock;

Scene coarse_box(RadiositySolver solver = RadiositySolver::gauss_seidel) {
  Scene s = open_scene("models/cornell-box.json");
  s.radiosity.patch_size = 0.25, s.radiosity.resolution = 16, s.radiosity.samples = 1;
  s.radiosity.solver = solver;
  return s;
}

SolutionHandle solved(const Scene& scene, const SolutionHandle& earlier = nullptr) {
  Progress progress;
  return solve_scene(scene, {earlier, nullptr}, progress, 1).solution;
}

class SolverDeskTest : public testing::Test {
 protected:
  void take(const Scene& scene) {
    solution = solved(scene, solution);
    inputs = radiosity_inputs(scene);
    desk.take(solution, inputs, scene.radiosity);
  }
  SolverStateHandle settled() {
    const auto end = Clock::now() + std::chrono::seconds(60);
    while (desk.state().busy && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(desk.state().busy);
    return desk.state().newest;
  }
  // The light of the part as a solver of one's own has it after so many steps, drawn.
  RadiosityField expected(std::size_t steps, const Radiosity& options) {
    Progress progress;
    Solver solver(system_of(*solution->patches, solution->matrix), options);
    solver.go_to(steps, progress);
    std::vector<glm::dvec3> b, of_patches = solver.radiosity();
    for (const Element& e : solution->patches->elements) b.push_back(of_patches[e.patch]);
    Scene loaded = inputs;
    load_meshes(loaded);
    return field_of(loaded, *solution->patches, b, solution->geometry);
  }
  static bool same_corners(const RadiosityField& a, const RadiosityField& b) {
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const auto& x, const auto& y) { return x.corners == y.corners; });
  }

  SolutionHandle solution;
  Scene inputs;
  SolverDesk desk{nullptr};
};

TEST_F(SolverDeskTest, GoesForwardAndBackToTheSameLight) {
  for (const RadiositySolver kind : {RadiositySolver::jacobi, RadiositySolver::gauss_seidel, RadiositySolver::southwell,
                                     RadiositySolver::progressive, RadiositySolver::lu}) {
    SCOPED_TRACE(names_of<RadiositySolver>[std::size_t(kind)].id);
    const Scene scene = coarse_box(kind);
    take(scene);
    SolverStateHandle s = settled();
    ASSERT_NE(s, nullptr);
    EXPECT_EQ(s->step, 0u);
    EXPECT_TRUE(same_corners(*s->field, expected(0, scene.radiosity)));
    if (kind == RadiositySolver::lu) {
      desk.step();
      s = settled();
      EXPECT_EQ(s->end, SolverEnd::converged);
      EXPECT_TRUE(same_corners(*s->field, expected(1, scene.radiosity)));
      desk.reset();
      EXPECT_EQ(settled()->step, 0u);
      continue;
    }
    for (int i = 0; i < 3; ++i) desk.step();
    s = settled();
    EXPECT_EQ(s->step, 3u);
    EXPECT_TRUE(s->residual);
    const RadiosityHandle third = s->field;
    EXPECT_TRUE(same_corners(*third, expected(3, scene.radiosity)));
    desk.sweep();
    s = settled();
    EXPECT_EQ(s->step, s->steps_a_sweep);
    desk.sweep();
    EXPECT_EQ(settled()->step, 2 * s->steps_a_sweep);
    desk.back();
    EXPECT_EQ(settled()->step, 2 * s->steps_a_sweep - 1);
    desk.go_to(3);
    s = settled();
    EXPECT_EQ(s->step, 3u);
    EXPECT_TRUE(same_corners(*s->field, *third));
    EXPECT_EQ(s->field->objects[0].mesh, third->objects[0].mesh);  // only the light is another
    desk.finish();
    s = settled();
    EXPECT_EQ(s->end, SolverEnd::converged);
    EXPECT_EQ(s->active, std::nullopt);
    EXPECT_LE(s->curve.back().error_bound, scene.radiosity.residual);
    desk.step();  // nowhere to go
    EXPECT_EQ(settled()->step, s->step);
    desk.back();
    EXPECT_EQ(settled()->step, s->step - 1);
  }
}

TEST_F(SolverDeskTest, OnlyAnotherSystemOrSolverBeginsAnew) {
  Scene scene = coarse_box();
  take(scene);
  desk.go_to(40);
  EXPECT_EQ(settled()->step, 40u);
  scene.camera.position.x += 1;
  take(scene);
  EXPECT_EQ(settled()->step, 40u);
  scene.radiosity.residual = 1e-3;
  take(scene);
  EXPECT_EQ(settled()->step, 40u);
  EXPECT_EQ(settled()->task->options.residual, 1e-3);
  scene.objects[0].material.k_d = {0.9, 0.1, 0.1};
  const auto matrix = solution->matrix;
  take(scene);
  EXPECT_EQ(solution->matrix, matrix);  // the form factors are kept
  EXPECT_EQ(settled()->step, 0u);
  desk.step();
  settled();
  scene.radiosity.solver = RadiositySolver::jacobi;
  take(scene);
  EXPECT_EQ(settled()->step, 0u);
  desk.take(nullptr, {}, {});
  EXPECT_EQ(settled(), nullptr);
  desk.step(), desk.back(), desk.sweep(), desk.finish(), desk.reset(), desk.stop();
  EXPECT_EQ(settled(), nullptr);
}

TEST_F(SolverDeskTest, PartsOfTheLight) {
  const Scene scene = coarse_box(RadiositySolver::progressive);
  take(scene);
  desk.go_to(5);
  settled();
  const auto most = [](const RadiosityField& f) {
    float out = 0;
    for (const ObjectRadiosity& o : f.objects)
      for (const glm::vec3& c : o.corners) out = std::max({out, c.x, c.y, c.z});
    return out;
  };
  desk.show(LightPart::unshot);
  SolverStateHandle s = settled();
  EXPECT_EQ(s->part, LightPart::unshot);
  EXPECT_GT(most(*s->field), 0);
  EXPECT_LE(most(*s->field), 1);  // brightened, never beyond
  EXPECT_EQ(std::exp2(std::round(std::log2(s->gain))), s->gain);
  desk.finish();
  s = settled();
  EXPECT_GT(s->gain, 1000);  // next to nothing is left
  desk.show(LightPart::received);
  const float received = most(*settled()->field);
  desk.show(LightPart::indirect);
  const float indirect = most(*settled()->field);
  desk.show(LightPart::total);
  const float total = most(*settled()->field);
  EXPECT_GT(received, total);  // a part of it is absorbed
  EXPECT_LT(indirect, total);
  EXPECT_GT(indirect, 0);
}

TEST_F(SolverDeskTest, PlaysByTheClockAndStops) {
  take(coarse_box());
  settled();
  desk.play();
  EXPECT_TRUE(desk.playing());
  double now = 10;
  for (int i = 0; i < 30; ++i) desk.advance(now += 1.0 / 60, 20), settled();
  // Half a second at 20 steps a second, whatever the computer's speed.
  EXPECT_NEAR(double(settled()->step), 10, 1);
  desk.stop();
  EXPECT_FALSE(desk.playing());
  const std::size_t there = settled()->step;
  for (int i = 0; i < 10; ++i) desk.advance(now += 1.0 / 60, 20);
  EXPECT_EQ(settled()->step, there);
  // To the end: then it does not play any more.
  desk.play();
  for (int i = 0; i < 1000 && desk.playing(); ++i) desk.advance(now += 1.0 / 60, 1e7), settled();
  EXPECT_FALSE(desk.playing());
  EXPECT_NE(settled()->end, SolverEnd::none);
}

TEST_F(SolverDeskTest, SaysWhatAMethodCannot) {
  // More patches than LU takes, each of which sees one other.
  constexpr std::size_t n = 8200;
  const FormFactorMethod method{[](std::uint32_t i, const Progress&) {
                                  FormFactorRow row;
                                  row.factors.push_back({std::uint32_t((i + 1) % n), 1});
                                  row.sum = 1;
                                  return row;
                                },
                                {}};
  Progress progress;
  auto patches = std::make_shared<Patches>();
  patches->patches.resize(n);
  for (Patch& p : patches->patches) p.area = 1, p.reflectance = glm::dvec3(.5), p.emission = glm::dvec3(1);
  auto made = std::make_shared<RadiositySolution>();
  made->patches = patches;
  made->matrix =
      FormFactorMatrix::make(plan_matrix(n, method, 512, progress), method, std::vector<double>(n, 1), {}, 1, progress);
  solution = made;
  Radiosity options;
  options.solver = RadiositySolver::lu;
  desk.take(solution, inputs, options);
  EXPECT_EQ(settled(), nullptr);
  const auto problem = desk.state().problem;
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->en.find("8192"), std::string::npos);
  EXPECT_FALSE(problem->ja.empty());
  options.solver = RadiositySolver::jacobi;
  desk.take(solution, inputs, options);
  ASSERT_NE(settled(), nullptr);
  EXPECT_FALSE(desk.state().problem);
  SolverRace race(nullptr);
  race.run(solution, options);
  EXPECT_TRUE(race.needs_leave());
  EXPECT_FALSE(race.busy());
  race.allow();
  while (race.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE((*race.entries())[std::size_t(RadiositySolver::lu)].problem);
  EXPECT_EQ((*race.entries())[std::size_t(RadiositySolver::southwell)].end, SolverEnd::converged);
}

// Rows that are computed anew at every step, many steps, the window closed in the middle of them.
TEST_F(SolverDeskTest, NeverWaits) {
  Scene scene = coarse_box(RadiositySolver::jacobi);
  scene.radiosity.patch_size = 0.1, scene.radiosity.memory = 1, scene.radiosity.residual = 0.1;
  take(scene);
  ASSERT_FALSE(solution->matrix->whole());
  const auto ms = [](Clock::time_point since) {
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
  };
  double most = 0;
  Clock::time_point closing;
  {
    SolverDesk own(nullptr);
    own.take(solution, inputs, scene.radiosity);
    own.finish();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    for (int i = 0; i < 20; ++i) {
      const auto asked = Clock::now();
      own.take(solution, inputs, scene.radiosity);
      i % 2 ? own.stop() : own.finish();
      own.advance(double(i), 100);
      (void)own.state();
      most = std::max(most, ms(asked));
    }
    own.finish();
    closing = Clock::now();
  }
  EXPECT_LE(most, 16);
  EXPECT_LE(ms(closing), 1000);
}

TEST(SolverRace, AllFiveComeDown) {
  const Scene scene = coarse_box();
  const SolutionHandle solution = solved(scene);
  SolverRace race(nullptr);
  race.run(solution, scene.radiosity);
  while (race.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto entries = race.entries();
  for (const SolverRace::Entry& e : *entries) {
    ASSERT_FALSE(e.curve.empty());
    EXPECT_EQ(e.end, SolverEnd::converged);
    EXPECT_LE(e.curve.back().error_bound, scene.radiosity.residual);
  }
  // The same system again, from another solution: nothing runs.
  race.run(solved(scene, solution), scene.radiosity);
  EXPECT_FALSE(race.busy());
  EXPECT_EQ(race.entries(), entries);

  const Plot over_sweeps = residual_plot(*entries, RadiositySolver::gauss_seidel, nullptr, 1e-6, false);
  const Plot over_time = residual_plot(*entries, RadiositySolver::gauss_seidel, nullptr, 1e-6, true);
  EXPECT_EQ(over_sweeps.lines.size(), 5u);  // LU has no sweeps; and where it stops
  EXPECT_EQ(over_time.lines.size(), 6u);
  EXPECT_TRUE(over_sweeps.x.linear);
  EXPECT_FALSE(over_time.x.linear);
  for (const Plot& plot : {over_sweeps, over_time}) {
    EXPECT_EQ(plot.legend.size(), plot.lines.size() - 1);
    for (const PlotLine& line : plot.lines) {
      EXPECT_TRUE(std::is_sorted(line.x.begin(), line.x.end()));
      EXPECT_TRUE(std::all_of(line.y.begin(), line.y.end(), [](double y) { return y >= 1e-7 && y < 10; }));
      EXPECT_TRUE(plot.x.linear || line.x[0] > 0);
    }
  }
  const auto sweeps_of = [&](RadiositySolver k) { return (*entries)[std::size_t(k)].curve.back().sweeps; };
  EXPECT_LT(sweeps_of(RadiositySolver::gauss_seidel), sweeps_of(RadiositySolver::jacobi));
}

}  // namespace
}  // namespace cg
