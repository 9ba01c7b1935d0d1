// Each solver against systems whose light is known in closed form, given exact factors.
#include "params/input_error.h"
#include "tests/radiosity/systems.h"

namespace cg {
namespace {

class EachSolver : public testing::TestWithParam<RadiositySolver> {
 protected:
  std::vector<double> light(const RadiositySystem& system) {
    std::vector<double> out;
    for (const glm::dvec3& b : solve(system, with_solver(GetParam()))) {
      EXPECT_NEAR(b.x, b.y, 1e-10);
      EXPECT_NEAR(b.x, b.z, 1e-10);
      out.push_back(b.x);
    }
    return out;
  }
  void expect(const RadiositySystem& system, const std::vector<double>& expected, double tolerance = 1e-9) {
    const std::vector<double> b = light(system);
    ASSERT_EQ(b.size(), expected.size());
    for (std::size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(b[i], expected[i], tolerance) << i;
  }
};

TEST_P(EachSolver, CubeWithEmittingFloor) {
  struct Row {
    double rho, floor, ceiling, wall, black_ceiling, black_wall;
  };
  for (const Row& r : {Row{.2, 1.009615386, .0480445446, .04808501736, .04758697744, .04762706475},
                       {.5, 1.090909098, .1817458261, .1818362689, .1666003395, .1666832454},
                       {.8, 1.551724154, .6895510707, .6896811939, .4443773522, .4444612093},
                       {.9, 2.372881375, 1.525310551, 1.525452019, .6428094414, .6428690598},
                       {.99, 17.36227047, 16.52742513, 16.5275761, .9519161191, .9519248146}}) {
    const std::vector<double> emission{1, 0, 0, 0, 0, 0};
    expect(cube_system(emission, std::vector<double>(6, r.rho)), {r.floor, r.ceiling, r.wall, r.wall, r.wall, r.wall},
           1e-8);
    expect(cube_system(emission, {0, r.rho, r.rho, r.rho, r.rho, r.rho}),
           {1, r.black_ceiling, r.black_wall, r.black_wall, r.black_wall, r.black_wall}, 1e-8);
  }
}

TEST_P(EachSolver, ParallelPlates) {
  struct Row {
    double e1, rho1, e2, rho2;
  };
  for (const Row& r : {Row{1, .5, 0, .5}, {1, .5, 0, .8}, {1, .9, 2, .7}}) {
    const double d = 1 - r.rho1 * r.rho2;
    expect(system_with({0, 1, 1, 0}, {1, 1}, {r.e1, r.e2}, {r.rho1, r.rho2}),
           {(r.e1 + r.rho1 * r.e2) / d, (r.e2 + r.rho2 * r.e1) / d});
  }
}

TEST_P(EachSolver, TwoSquaresInTheOpen) {
  for (const double rho : {.5, .9}) {
    const double f = cube_opposite, b1 = 1 / (1 - rho * rho * f * f);
    expect(system_with({0, f, f, 0}, {1, 1}, {1, 0}, {rho, rho}), {b1, rho * f * b1});
  }
}

TEST_P(EachSolver, ConcentricSpheres) {
  const std::vector<double> f{0, 1, 0.25, 0.75}, area{4 * M_PI, 16 * M_PI};
  expect(system_with(f, area, {1, 0}, {.5, .5}), {10. / 9, 2. / 9});
  expect(system_with(f, area, {0, 1}, {.5, .5}), {8. / 9, 16. / 9});
  expect(system_with(f, area, {1, 0}, {.2, .8}), {10. / 9, 5. / 9});
}

// The irradiance of a sphere's inside is the same everywhere: <E> / (1 - <rho>).
TEST_P(EachSolver, SphereInterior) {
  for (const std::size_t n : {1u, 2u, 7u, 60u}) {
    const RadiositySystem s = sphere_system(n);
    const std::vector<double>& area = s.matrix->area();
    double e = 0, rho = 0;
    for (std::size_t i = 0; i < n; ++i) e += area[i] * s.emission[i].x, rho += area[i] * s.reflectance[i].x;
    const double h = e / (4 * M_PI - rho);
    std::vector<double> expected;
    for (std::size_t i = 0; i < n; ++i) expected.push_back(s.emission[i].x + s.reflectance[i].x * h);
    expect(s, expected);
  }
}

TEST_P(EachSolver, Ducts) {
  const auto triangle = [](double rho) {
    return system_with({0, .5, .5, .5, 0, .5, .5, .5, 0}, {1, 1, 1}, {1, 0, 0}, {rho, rho, rho});
  };
  expect(triangle(.5), {1.2, .4, .4});
  expect(triangle(.8), {2.142857142857143, 1.428571428571429, 1.428571428571429});
  const double opposite = std::sqrt(2) - 1, adjacent = 1 - std::sqrt(.5);
  std::vector<double> square;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) square.push_back(i == j ? 0 : (i - j) % 2 == 0 ? opposite : adjacent);
  const auto duct = [&](double rho) { return system_with(square, {1, 1, 1, 1}, {1, 0, 0, 0}, {rho, rho, rho, rho}); };
  expect(duct(.5), {1.144461419, .2697521434, .3160342942, .2697521434});
  expect(duct(.8), {1.845379691, 1.030173071, 1.094274167, 1.030173071});
}

TEST_P(EachSolver, Furnace) {
  for (const double rho : {0., .1, .5, .9, .99, .999}) {
    const double b = 1 / (1 - rho);
    expect(cube_system(std::vector<double>(6, 1), std::vector<double>(6, rho)), std::vector<double>(6, b), 1e-9 * b);
  }
}

// What arrives, H = (B - E) / rho, is absorbed by the share 1 - rho: in a closed scene all that is emitted.
TEST_P(EachSolver, WhatIsEmittedIsAbsorbed) {
  const RadiositySystem s = sphere_system(40);
  const std::vector<double> b = light(s);
  double emitted = 0, absorbed = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double rho = s.reflectance[i].x, area = s.matrix->area()[i];
    emitted += area * s.emission[i].x;
    absorbed += area * (1 - rho) * (b[i] - s.emission[i].x) / rho;
  }
  EXPECT_NEAR(absorbed, emitted, 1e-8 * emitted);
}

TEST_P(EachSolver, ChannelsDoNotMix) {
  RadiositySystem s = cube_system({1, 0, 0, 0, 0, 0}, std::vector<double>(6, .5));
  for (glm::dvec3& rho : s.reflectance) rho = {.2, .5, .8};
  s.emission[0] = {1, 2, 0};
  const auto b = solve(s, with_solver(GetParam()));
  EXPECT_NEAR(b[1].x, .0480445446, 1e-8);
  EXPECT_NEAR(b[1].y, 2 * .1817458261, 1e-8);
  EXPECT_EQ(b[1].z, 0);
}

TEST_P(EachSolver, ExtremesEnd) {
  expect(system_with({0}, {1}, {1}, {.9}), {1});  // one patch
  expect(system_with({0}, {1}, {0}, {.9}), {0});  // no emitter
  expect(cube_system(std::vector<double>(6, 0), std::vector<double>(6, .9)), std::vector<double>(6, 0));
  expect(system_with({0, 0, 0, 0}, {1, 0}, {1, 2}, {.9, .9}), {1, 2});  // nothing sees anything; no area
  // Two rooms that do not see each other, one dark.
  std::vector<double> f(16, 0);
  f[0 * 4 + 1] = f[1 * 4 + 0] = f[2 * 4 + 3] = f[3 * 4 + 2] = 1;
  expect(system_with(f, {1, 1, 1, 1}, {1, 0, 0, 0}, {.5, .5, .9, .9}), {4. / 3, 2. / 3, 0, 0});
  // rho = 1, but the scene is open.
  const double g = cube_opposite;
  expect(system_with({0, g, g, 0}, {1, 1}, {1, 0}, {1, 1}), {1 / (1 - g * g), g / (1 - g * g)});
}

TEST_P(EachSolver, DivergenceIsFoundAtOnce) {
  Progress progress;
  const auto ends = [&](const RadiositySystem& s) {
    Solver solver(s, with_solver(GetParam()));
    for (int i = 0; i < 10 && solver.end() == SolverEnd::none; ++i) solver.sweep(progress);
    EXPECT_FALSE(solver.message().en.empty());
    return solver.end();
  };
  std::vector<double> f(36);
  for (std::size_t i = 0; i < 36; ++i) f[i] = i / 6 == i % 6 ? 0 : (1 + 1.3e-4) / 5;
  const std::vector<double> all(6, 1), one{1, 0, 0, 0, 0, 0};
  for (const std::vector<double>& emission : {all, one}) {
    EXPECT_EQ(ends(system_with(f, all, emission, std::vector<double>(6, .9999))), SolverEnd::diverges);
    // One row absorbs, yet the others' light still grows.
    std::vector<double> rho(6, 1.0);
    rho[5] = .9995;
    EXPECT_EQ(ends(system_with(f, all, emission, rho)), SolverEnd::diverges);
  }
}

TEST_P(EachSolver, NotNormalisedRowsMissByTheirExcess) {
  const double delta = 1.3e-4;
  std::vector<double> f(36);
  for (std::size_t i = 0; i < 36; ++i) f[i] = i / 6 == i % 6 ? 0 : (1 + delta) / 5;
  for (const double rho : {.9, .99, .999}) {
    const double off = rho * delta / (1 - rho - rho * delta), b = 1 / (1 - rho);
    expect(system_with(f, std::vector<double>(6, 1), std::vector<double>(6, 1), std::vector<double>(6, rho)),
           std::vector<double>(6, b * (1 + off)), 1e-8 * b);
  }
}

std::string solver_name(const testing::TestParamInfo<RadiositySolver>& info) {
  return std::array{"Jacobi", "GaussSeidel", "Southwell", "Progressive", "Lu"}[std::size_t(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Solvers, EachSolver, testing::ValuesIn(all_solvers), solver_name);

// To 1e-6 in the max norm on the cube that emits from its floor. The start vector and what a solver stops on move the
// counts by up to a fifth.
TEST(SolverTest, SweepsToAMillionth) {
  struct Row {
    double rho;
    int jacobi, gauss_seidel;
  };
  for (const Row& r : {Row{.5, 18, 10}, {.8, 59, 31}, {.9, 127, 65}, {.99, 1370, 687}, {.999, 13804, 6904}})
    for (const bool jacobi : {true, false}) {
      Progress progress;
      Solver solver(cube_system({1, 0, 0, 0, 0, 0}, std::vector<double>(6, r.rho)),
                    with_solver(jacobi ? RadiositySolver::jacobi : RadiositySolver::gauss_seidel, 1e-6));
      solver.run(progress);
      const int expected = jacobi ? r.jacobi : r.gauss_seidel;
      EXPECT_NEAR(solver.sweeps(), expected, 0.2 * expected + 1) << r.rho << " " << jacobi;
    }
}

TEST(SolverTest, TheErrorIsBelowTheResidualAsked) {
  for (const RadiositySolver kind : all_solvers)
    for (const double residual : {1e-2, 1e-5, 1e-9})
      for (const double rho : {.5, .99}) {
        const RadiositySystem s = cube_system({1, 0, 0, 0, 0, 0}, std::vector<double>(6, rho));
        const auto exact = solve(s, with_solver(RadiositySolver::lu)), b = solve(s, with_solver(kind, residual));
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(b[i].x, exact[i].x, residual * exact[0].x) << int(kind) << " " << rho;
      }
}

TEST(SolverTest, WhatTheDigitsOfDoubleDoNotReachEndsToo) {
  for (const RadiositySolver kind : all_solvers) {
    if (kind == RadiositySolver::lu) continue;
    Progress progress;
    Solver solver(cube_system({1, 0, 0, 0, 0, 0}, std::vector<double>(6, .999)), with_solver(kind, 1e-15));
    solver.run(progress);
    EXPECT_EQ(solver.end(), SolverEnd::rounding) << int(kind);
    EXPECT_FALSE(solver.message().en.empty());
    EXPECT_NEAR(solver.radiosity()[0].x, 167.36, 0.05);
  }
}

// Every state that a step led to is found again, bit by bit, and the way forward from it is the same.
TEST(SolverTest, StepsGoBack) {
  for (const RadiositySolver kind : all_solvers) {
    Progress progress;
    Solver solver(sphere_system(13), with_solver(kind, 1e-7));
    std::vector<std::vector<glm::dvec3>> seen{solver.radiosity()};
    while (solver.end() == SolverEnd::none) {
      solver.step(progress);
      seen.push_back(solver.radiosity());
    }
    const std::size_t last = solver.steps();
    ASSERT_EQ(seen.size(), last + 1);
    for (const std::size_t step : {last - last / 3, last / 2, last / 7, std::size_t(0), last / 5, last}) {
      solver.go_to(step, progress);
      EXPECT_EQ(solver.steps(), step);
      EXPECT_TRUE(solver.radiosity() == seen[step]) << int(kind) << " " << step;
    }
    for (std::size_t step = last; step-- > 0;) {
      solver.go_to(step, progress);
      EXPECT_TRUE(solver.radiosity() == seen[step]);
      EXPECT_LE(solver.curve().back().step, step);
    }
    Solver swept(sphere_system(13), with_solver(kind, 1e-7));
    swept.run(progress);
    EXPECT_EQ(swept.steps(), last);
    EXPECT_TRUE(swept.radiosity() == seen.back());
  }
}

TEST(SolverTest, PartsOfTheLight) {
  Progress progress;
  const RadiositySystem s = cube_system({1, 0, 0, 0, 0, 0}, std::vector<double>(6, .5));
  for (const RadiositySolver kind : all_solvers) {
    Solver solver(s, with_solver(kind, 1e-12));
    solver.run(progress);
    const auto b = solver.part(LightPart::total, progress), received = solver.part(LightPart::received, progress);
    const auto indirect = solver.part(LightPart::indirect, progress), unshot = solver.part(LightPart::unshot, progress);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(b[i].x, s.emission[i].x + .5 * received[i].x, 1e-11);
      EXPECT_NEAR(unshot[i].x, 0, 1e-11);
      const double direct = i == 0 ? 0 : .5 * (i == 1 ? cube_opposite : cube_adjacent);
      EXPECT_NEAR(indirect[i].x, b[i].x - s.emission[i].x - direct, 1e-11);
      EXPECT_GT(indirect[i].x, 0);
    }
    EXPECT_LE(solver.residual(progress), 1e-12);
  }
}

// Before the first shot the estimate spreads all power evenly: in a furnace it is the answer.
TEST(SolverTest, TheAmbientEstimateIsExactInAFurnace) {
  Progress progress;
  Solver solver(cube_system(std::vector<double>(6, 1), std::vector<double>(6, .8)),
                with_solver(RadiositySolver::progressive));
  for (const glm::dvec3& b : solver.radiosity()) EXPECT_NEAR(b.x, 5, 1e-12);
  const double before = solver.ambient().x;
  for (int i = 0; i < 6; ++i) solver.step(progress);
  EXPECT_LT(solver.ambient().x, before);
  double mean = 0;  // the power of B and of what the estimate adds is all power at any time
  for (const glm::dvec3& b : solver.radiosity()) mean += b.x / 6;
  EXPECT_NEAR(mean, 5, 1e-12);
}

TEST(SolverTest, TheBrightestShootsFirst) {
  Progress progress;
  RadiositySystem s = cube_system({1, 2, 0, 3, 0, 0}, std::vector<double>(6, .5));
  Solver solver(s, with_solver(RadiositySolver::southwell));
  for (const std::size_t expected : {3u, 1u, 0u}) {
    EXPECT_EQ(solver.active(), expected);
    solver.step(progress);
  }
  EXPECT_EQ(solver.steps_a_sweep(), 6u);
}

TEST(SolverTest, LuRefusesWhatIsTooLarge) {
  FormFactorMethod method{[](std::uint32_t, const Progress&) { return FormFactorRow{}; }, {}};
  Progress progress;
  const std::size_t n = 8193;
  const auto matrix = FormFactorMatrix::make(plan_matrix(n, method, 1, progress), method, std::vector<double>(n, 1),
                                             false, 1, progress);
  EXPECT_THROW(
      Solver({matrix, std::vector<glm::dvec3>(n), std::vector<glm::dvec3>(n)}, with_solver(RadiositySolver::lu)),
      InputError);
}

}  // namespace
}  // namespace cg
