// Form factors by hemicube and by rays, against closed forms (Howell, A Catalog of Radiation Heat Transfer
// Configuration Factors: B-3, C-11, C-14).
#include "radiosity/form_factors.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <random>

#include "radiosity/closed_form.h"
#include "tests/radiosity/patch_rooms.h"

namespace cg {
namespace {

const glm::dvec3 origin(0), x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);
const Progress not_cancelled;

double factor(const FormFactorRow& row, std::uint32_t patch) {
  for (const FormFactor& f : row.factors)
    if (f.patch == patch) return double(f.value);
  return 0;
}

FormFactorRow row_of(const Patches& patches, std::uint32_t patch, const Radiosity& options) {
  return form_factor_method(patches, options).row(patch, not_cancelled);
}

Radiosity hemicube(int resolution, int samples, Placement placement) {
  Radiosity r;
  r.resolution = resolution, r.samples = samples, r.placement = placement;
  return r;
}

Radiosity monte_carlo(int rays) {
  Radiosity r;
  r.form_factors = FormFactors::monte_carlo, r.rays = rays;
  return r;
}

// A tiny patch on the ground, facing up.
Patches ground_point(double size = 1e-9) {
  Patches p;
  add_rectangle(p, {-size / 2, -size / 2, 0}, size * x_axis, size * y_axis);
  return p;
}

TEST(FormFactors, PointToPlate) {
  Patches p = ground_point();
  add_rectangle(p, {-0.5, -0.5, 1}, y_axis, x_axis);
  Radiosity options = hemicube(64, 1, Placement::grid);
  for (const PixelWeight right : {PixelWeight::delta_form_factor, PixelWeight::integrated}) {
    options.weight = right;
    EXPECT_NEAR(factor(row_of(p, 0, options), 1), 0.239456470461, 1e-4);
  }
  for (const PixelWeight wrong : {PixelWeight::unweighted, PixelWeight::solid_angle, PixelWeight::r_squared}) {
    options.weight = wrong;
    const double f = factor(row_of(p, 0, options), 1);
    std::printf("wrong weight %d: %.4f\n", int(wrong), f);
    EXPECT_GT(std::abs(f - 0.2395), 0.03) << int(wrong);
  }
}

TEST(FormFactors, OcclusionIsExact) {
  const double known = 0.165978835649;
  for (const bool facing : {true, false}) {  // a back blocks too
    Patches p = ground_point();
    add_rectangle(p, {-1, -1, 2}, 2.0 * y_axis, 2.0 * x_axis);
    add_rectangle(p, {-0.25, -0.25, 1}, 0.5 * (facing ? y_axis : x_axis), 0.5 * (facing ? x_axis : y_axis));
    const FormFactorRow row = row_of(p, 0, hemicube(64, 1, Placement::grid));
    EXPECT_NEAR(factor(row, 1), known, 1e-4);
    EXPECT_NEAR(factor(row, 2), facing ? 0.0734776348125 : 0, 1e-4);
    const Radiosity rays = monte_carlo(100000);
    EXPECT_NEAR(factor(row_of(p, 0, rays), 1), known, 4 * std::sqrt(known * (1 - known) / rays.rays));
  }
}

// Opposite unit squares at distance 1, and perpendicular ones with a common edge.
Patches opposite() {
  Patches p;
  add_rectangle(p, origin, x_axis, y_axis);
  add_rectangle(p, z_axis, y_axis, x_axis);
  return p;
}
Patches perpendicular() {
  Patches p;
  add_rectangle(p, origin, x_axis, y_axis);
  add_rectangle(p, origin, y_axis, z_axis);
  return p;
}
constexpr double known_opposite = 0.199824895698, known_perpendicular = 0.200043776075;

double largest_error(const Patches& p, const Radiosity& options, double known) {
  return std::max(std::abs(factor(row_of(p, 0, options), 1) - known),
                  std::abs(factor(row_of(p, 1, options), 0) - known));
}

TEST(FormFactors, UnitSquares) {
  struct Goal {
    int resolution, samples;
    Placement placement;
    double error;
  };
  for (const Goal& goal : {Goal{64, 8, Placement::grid, 5e-4},  // 4.7e-4 of it are the positions'
                           Goal{64, 4, Placement::gauss, 1e-4}, Goal{256, 4, Placement::gauss, 1e-4},
                           Goal{256, 3, Placement::gauss, 1e-4}})
    for (const PixelWeight weight : {PixelWeight::delta_form_factor, PixelWeight::integrated}) {
      Radiosity options = hemicube(goal.resolution, goal.samples, goal.placement);
      options.weight = weight;
      EXPECT_LT(largest_error(opposite(), options, known_opposite), goal.error) << goal.resolution;
      EXPECT_LT(largest_error(perpendicular(), options, known_perpendicular), goal.error) << goal.resolution;
    }
}

// At one resolution pixels err by chance. Of all about 64 the root mean square is below 1e-4 with 4 x 4 Gauss points
// already, of both pairs, either way round; and nowhere is it far above.
TEST(FormFactors, SixteenGaussPointsReachTheGoalAtAllResolutionsAbout64) {
  for (const PixelWeight weight : {PixelWeight::delta_form_factor, PixelWeight::integrated})
    for (const int samples : {4, 6, 8}) {
      double squares[3] = {}, largest = 0;
      int count = 0;
      for (int resolution = 48; resolution <= 96; resolution += 2, ++count) {
        Radiosity options = hemicube(resolution, samples, Placement::gauss);
        options.weight = weight;
        const double errors[3] = {factor(row_of(opposite(), 0, options), 1) - known_opposite,
                                  factor(row_of(perpendicular(), 0, options), 1) - known_perpendicular,
                                  factor(row_of(perpendicular(), 1, options), 0) - known_perpendicular};
        for (int i = 0; i < 3; ++i)
          squares[i] += errors[i] * errors[i], largest = std::max(largest, std::abs(errors[i]));
      }
      std::printf("%d x %d Gauss points, R = 48..96: opposite %.1e, perpendicular %.1e and %.1e; at most %.1e\n",
                  samples, samples, std::sqrt(squares[0] / count), std::sqrt(squares[1] / count),
                  std::sqrt(squares[2] / count), largest);
      for (const double sum : squares) EXPECT_LT(std::sqrt(sum / count), 1e-4) << samples;
      EXPECT_LT(largest, 2e-4) << samples;
    }
}

// What pixels alone err, of rectangles that are parallel as most are in a room: of one position that sees them along
// its rows of pixels, and of as many as turn.
TEST(FormFactors, TurnedHemicubesAverageTheirPixels) {
  const auto error = [](int resolution, int samples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    constexpr int pairs = 60;
    for (int i = 0; i < pairs; ++i) {
      Patches p;
      add_rectangle(p, origin, x_axis, y_axis);
      add_rectangle(p, {2 * uniform(random) - 1, 2 * uniform(random) - 1, 0.4 + uniform(random)},
                    (0.2 + uniform(random)) * y_axis, (0.2 + uniform(random)) * x_axis);
      Radiosity options = hemicube(resolution, samples, Placement::gauss);
      options.weight = PixelWeight::integrated;
      const double seen = factor(row_of(p, 0, options), 1);
      options.form_factors = FormFactors::nusselt;  // of the same positions
      sum += std::pow(seen - factor(row_of(p, 0, options), 1), 2);
    }
    return std::sqrt(sum / pairs);
  };
  for (const int resolution : {32, 64, 128}) {
    const double one = error(resolution, 1), four = error(resolution, 2), sixteen = error(resolution, 4);
    std::printf("R = %3d: pixels err %.2e, of 2 x 2 positions %.2e, of 4 x 4 %.2e\n", resolution, one, four, sixteen);
    EXPECT_LT(four, one / 4) << resolution;
    EXPECT_LT(sixteen, one / 6) << resolution;
  }
}

TEST(FormFactors, ClosedFormAndNusselt) {
  Radiosity options = hemicube(64, 16, Placement::gauss);
  options.form_factors = FormFactors::closed_form;
  EXPECT_LT(largest_error(opposite(), options, known_opposite), 1e-7);
  EXPECT_LT(largest_error(perpendicular(), options, known_perpendicular), 1e-7);
  EXPECT_NEAR(row_of(closed_cube(3), 4, options).sum, 1, 1e-9);
  options.form_factors = FormFactors::nusselt;  // as a hemicube of endless resolution
  EXPECT_LT(largest_error(opposite(), options, known_opposite), 1e-7);
  EXPECT_LT(largest_error(perpendicular(), options, known_perpendicular), 2e-5);
}

TEST(FormFactors, ErrorFallsAsOneOverSSquared) {
  double last = 0;
  for (const int s : {1, 2, 4, 8, 16}) {
    const auto error = [&](const Patches& p, int resolution, Placement placement, double known) {
      return factor(row_of(p, 0, hemicube(resolution, s, placement)), 1) - known;
    };
    for (const int resolution : {64, 512})
      std::printf("S = %2d, R = %3d: opposite, grid %+.2e, Gauss %+.2e; perpendicular, grid %+.2e, Gauss %+.2e\n", s,
                  resolution, error(opposite(), resolution, Placement::grid, known_opposite),
                  error(opposite(), resolution, Placement::gauss, known_opposite),
                  error(perpendicular(), resolution, Placement::grid, known_perpendicular),
                  error(perpendicular(), resolution, Placement::gauss, known_perpendicular));
    const double grid = error(opposite(), 512, Placement::grid, known_opposite);
    if (s > 2) {
      EXPECT_NEAR(last / grid, 4, 0.4) << s;
    }
    last = grid;
  }
}

// Rectangles anywhere, from a point: what a hemicube of coarse pixels errs, relative to the closed form.
TEST(FormFactors, AliasingFallsWithResolution) {
  struct Known {
    int resolution;
    double mean;  // of F > 0.01
  };
  for (const Known& known : {Known{32, 0.019}, {64, 0.0063}, {128, 0.0022}, {256, 0.0007}, {512, 0.00023}}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    double sum = 0;
    int count = 0;
    while (count < 189) {
      const glm::dvec3 at(2 * uniform(random), 2 * uniform(random), 1 + 0.8 * uniform(random));
      const glm::dvec3 u = unit(glm::dvec3(uniform(random), uniform(random), uniform(random)));
      const glm::dvec3 v = unit(glm::cross(u, glm::dvec3(uniform(random), uniform(random), uniform(random))));
      Patches p = ground_point();
      add_rectangle(p, at, u, v);
      const double exact = point_form_factor(p.patches[0].centre, z_axis, std::span(p.patches[1].corner));
      if (exact < 0.01) continue;
      const double f = factor(row_of(p, 0, hemicube(known.resolution, 1, Placement::grid)), 1);
      sum += std::abs(f - exact) / exact;
      ++count;
    }
    std::printf("R = %3d: mean relative error of F > 0.01: %.2e\n", known.resolution, sum / count);
    EXPECT_LT(sum / count, 1.5 * known.mean);
  }
}

TEST(FormFactors, RowsOfAClosedCubeSumToOne) {
  const Patches cube = closed_cube(6);
  Radiosity options = hemicube(64, 1, Placement::grid);
  const auto sum_of = [](const FormFactorRow& row) {
    double sum = 0;
    for (const FormFactor& f : row.factors) sum += double(f.value);
    return sum;
  };
  for (std::uint32_t i = 0; i < cube.patches.size(); i += 7) {
    const FormFactorRow row = row_of(cube, i, options);
    EXPECT_NEAR(row.sum, 1, 2e-4);
    EXPECT_NEAR(sum_of(row), 1, 1e-6);  // normalised, in float
  }
  options.normalise = Normalise::none;
  EXPECT_NEAR(sum_of(row_of(cube, 3, options)), 1 + 1.32e-4, 2e-6);
  options.weight = PixelWeight::integrated;
  EXPECT_NEAR(row_of(cube, 3, options).sum, 1, 1e-7);
}

TEST(FormFactors, TouchingCoplanarBehindThinAndTiny) {
  const Radiosity options = hemicube(128, 4, Placement::gauss);
  Patches p;
  add_rectangle(p, origin, x_axis, y_axis);
  add_rectangle(p, x_axis, x_axis, y_axis);                         // 1: beside, in the same plane
  add_rectangle(p, {0, 0, -1}, x_axis, y_axis);                     // 2: behind
  add_rectangle(p, origin, y_axis, 1000.0 * z_axis);                // 3: touching, a wall
  add_rectangle(p, {0.5, 0.5, 0.5}, 1e-6 * y_axis, 1e-6 * x_axis);  // 4: 1e-12 square metres
  add_rectangle(p, {0.2, 0.9, 0.3}, 1e-7 * y_axis, 0.5 * x_axis);   // 5: thin
  const FormFactorRow row = row_of(p, 0, options);
  EXPECT_EQ(factor(row, 1), 0);
  EXPECT_EQ(factor(row, 2), 0);
  EXPECT_GT(factor(row, 3), 0.2);
  EXPECT_LE(factor(row, 3), 0.5);
  EXPECT_LT(factor(row, 4), 1e-3);
  EXPECT_LT(factor(row, 5), 1e-3);
  EXPECT_EQ(factor(row, 4), 0);  // smaller than a pixel, and said so; the line 5 may run through a pixel's sample
  EXPECT_EQ(row.missed, 1u + (factor(row, 5) > 0 ? 0u : 1u));
  for (const std::uint32_t from : {4u, 5u})
    for (const FormFactor& f : row_of(p, from, options).factors) {
      EXPECT_TRUE(std::isfinite(f.value));
      EXPECT_LE(f.value, 1.001f);
    }
}

// A point at the foot of an endless wall sees it with half of its hemisphere.
TEST(FormFactors, FootOfAWall) {
  Patches foot;
  add_rectangle(foot, {1e-6, 0, 0}, 1e-6 * x_axis, 1e-6 * y_axis);
  add_rectangle(foot, {0, -1, 0}, 2.0 * y_axis, z_axis);
  EXPECT_NEAR(factor(row_of(foot, 0, hemicube(128, 1, Placement::grid)), 1), 0.5, 1e-3);
}

TEST(FormFactors, APatchLyingOnAnotherTakesAllOfItsLight) {
  Patches p;
  add_rectangle(p, origin, x_axis, y_axis);
  add_rectangle(p, origin, y_axis, 0.5 * x_axis);  // face to face, on one half
  add_rectangle(p, {-10, -10, 1}, 20.0 * y_axis, 20.0 * x_axis);
  for (const Radiosity& options : {hemicube(64, 2, Placement::gauss), monte_carlo(10000)}) {
    const FormFactorRow row = row_of(p, 0, options);
    EXPECT_NEAR(factor(row, 1), 0.5, 1e-3);
    EXPECT_NEAR(factor(row, 2), 0.495, 5e-3);
  }
}

TEST(FormFactors, RaysAgreeWithClosedForms) {
  const Radiosity options = monte_carlo(200000);
  for (const auto& [patches, known] :
       {std::pair(opposite(), known_opposite), std::pair(perpendicular(), known_perpendicular)}) {
    const double sigma =
        std::sqrt(known * (1 - known) / options.rays);  // of independent rays: stratified ones err less
    EXPECT_NEAR(factor(row_of(patches, 0, options), 1), known, 3 * sigma);
  }
  const Patches sphere = closed_sphere(32, 16);
  const FormFactorRow row = row_of(sphere, 40, options),
                      by_hemicube = row_of(sphere, 40, hemicube(512, 4, Placement::gauss));
  EXPECT_NEAR(row.sum, 1, 1e-9);  // no ray is lost
  double chi_square = 0;
  for (const FormFactor& f : by_hemicube.factors)
    chi_square += std::pow(factor(row, f.patch) - double(f.value), 2) / double(f.value) * options.rays;
  std::printf("chi^2 / degrees of freedom, rays against hemicube: %.3f\n",
              chi_square / double(by_hemicube.factors.size()));
  EXPECT_LT(chi_square / double(by_hemicube.factors.size()), 1.2);
}

TEST(FormFactors, RowsDoNotDependOnThreads) {
  const Patches cube = closed_cube(8);
  for (const FormFactors method : {FormFactors::hemicube, FormFactors::monte_carlo}) {
    Radiosity options = hemicube(64, 2, Placement::gauss);
    options.form_factors = method;
    const FormFactorMethod alone = form_factor_method(cube, options), together = form_factor_method(cube, options);
    std::vector<FormFactorRow> rows(cube.patches.size());
    tbb::parallel_for(std::size_t(0), rows.size(),
                      [&](std::size_t i) { rows[i] = together.row(std::uint32_t(i), not_cancelled); });
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      const FormFactorRow one = alone.row(i, not_cancelled);
      ASSERT_EQ(one.sum, rows[i].sum);
      ASSERT_EQ(one.factors.size(), rows[i].factors.size());
      for (std::size_t k = 0; k < one.factors.size(); ++k) ASSERT_EQ(one.factors[k].value, rows[i].factors[k].value);
    }
  }
}

TEST(FormFactors, CoordinatesOfAnySize) {
  const Radiosity options = hemicube(64, 2, Placement::gauss);
  const double known = factor(row_of(perpendicular(), 0, options), 1);
  for (const double scale : {1e-20, 1.0, 1e20})
    for (const double offset : {0.0, 1e5}) {
      Patches p;
      const glm::dvec3 at(offset * scale);
      add_rectangle(p, at, scale * x_axis, scale * y_axis);
      add_rectangle(p, at, scale * y_axis, scale * z_axis);
      EXPECT_NEAR(factor(row_of(p, 0, options), 1), known, 1e-6) << scale << " " << offset;
    }
}

TEST(FormFactors, CancelledRowsThrow) {
  const Patches cube = closed_cube(2);
  Progress progress;
  progress.cancelled = true;
  for (const FormFactors method : {FormFactors::hemicube, FormFactors::monte_carlo}) {
    Radiosity options;
    options.form_factors = method;
    EXPECT_THROW(form_factor_method(cube, options).row(0, progress), Cancelled);
  }
}

}  // namespace
}  // namespace cg
