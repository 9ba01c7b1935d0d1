// Rows of a closed scene made reciprocal: what they keep, what they gain, and what they cost.
#include <chrono>

#include "radiosity/closed_form.h"
#include "radiosity/form_factors.h"
#include "radiosity/matrix_rows.h"
#include "tests/radiosity/patch_rooms.h"
#include "tests/radiosity/systems.h"

namespace cg {
namespace {

using Matrix = std::shared_ptr<const FormFactorMatrix>;

// The unit cube with a finer floor and a strip for a ceiling, so that patches of very different size see each other.
Patches uneven_cube() {
  const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Patches out;
  out.closed = true;
  add_rectangle(out, o, x, y, 7, 7);
  add_rectangle(out, z, y, x, 1, 16);
  add_rectangle(out, o, y, z, 3, 3);
  add_rectangle(out, x, z, y, 2, 2);
  add_rectangle(out, o, z, x, 1, 1);
  add_rectangle(out, y, x, z, 5, 5);
  return out;
}

std::vector<double> areas_of(const Patches& patches) {
  std::vector<double> out;
  for (const Patch& p : patches.patches) out.push_back(p.area);
  return out;
}

Matrix matrix_of(const Patches& patches, const Radiosity& options, bool reciprocal, Storage storage = Storage::dense,
                 int threads = 1) {
  Progress progress;
  const std::size_t n = patches.patches.size();
  return FormFactorMatrix::make({n, storage, n, n * n * 16}, form_factor_method(patches, options), areas_of(patches),
                                true, threads, progress, reciprocal);
}

Radiosity hemicube(int resolution, int samples) {
  Radiosity out;
  out.resolution = resolution, out.samples = samples;
  return out;
}

// What is emitted less what is absorbed, over what is emitted: the first patches emit, the walls' rho differ.
double energy_lost(const Patches& patches, const Matrix& matrix) {
  RadiositySystem s{matrix, {}, {}};
  for (std::size_t i = 0; i < patches.patches.size(); ++i) {
    s.emission.emplace_back(i < 5 ? 1 : 0);
    s.reflectance.emplace_back(0.3 + 0.06 * double(i % 10));
  }
  const auto b = solve(s, with_solver(RadiositySolver::gauss_seidel));
  double emitted = 0, absorbed = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double area = patches.patches[i].area, rho = s.reflectance[i].x;
    emitted += area * s.emission[i].x;
    absorbed += area * (1 - rho) * (b[i].x - s.emission[i].x) / rho;
  }
  return std::abs(1 - absorbed / emitted);
}

// Of A_i F_ij, root mean square against the closed form over all pairs.
double error_of(const Patches& patches, const Matrix& matrix) {
  double squares = 0, all = 0;
  for (std::size_t i = 0; i < patches.patches.size(); ++i)
    for (std::size_t j = 0; j < patches.patches.size(); ++j) {
      const double area = patches.patches[i].area;
      const double exact =
          i == j ? 0 : area * polygon_form_factor(patches.patches[i].corner, patches.patches[j].corner);
      squares += std::pow(area * matrix->at(i, j) - exact, 2);
      all += exact * exact;
    }
  return std::sqrt(squares / all);
}

TEST(Reciprocal, EnergyIsKeptAndFactorsAreNoWorse) {
  for (const bool uneven : {false, true})
    for (const int samples : {1, 2}) {
      const Patches cube = uneven ? uneven_cube() : closed_cube(5);
      const Radiosity options = hemicube(64, samples);
      const Matrix rows = matrix_of(cube, options, false), both = matrix_of(cube, options, true);
      Progress progress;
      const MatrixFigures before = rows->figures(1, progress), after = both->figures(1, progress);
      const double lost = energy_lost(cube, rows), left = energy_lost(cube, both);
      const double off = error_of(cube, rows), now = error_of(cube, both);
      std::printf(
          "%s, %zu patches, R = 64, %d x %d: energy off %.2e -> %.2e, A F off %.2e -> %.2e, reciprocity %.2e -> %.2e\n",
          uneven ? "uneven cube" : "cube", cube.patches.size(), samples, samples, lost, left, off, now,
          before.reciprocity_relative, after.reciprocity_relative);
      EXPECT_LT(left, 1e-6);
      EXPECT_LT(after.reciprocity_relative, 1e-6);
      EXPECT_LT(now, off);
      EXPECT_EQ(after.least_sum, before.least_sum);  // what the method gave, before all normalising
      for (std::size_t i = 0; i < both->size(); ++i) {
        ASSERT_NEAR(both->row_sum(i), 1, 1e-13);
        both->visit(i, [&](std::size_t j, double f) { ASSERT_TRUE(f >= 0 && j != i); });
      }
    }
}

TEST(Reciprocal, SparseAndThreadsChangeNothing) {
  const Patches cube = uneven_cube();
  const Radiosity options = hemicube(32, 1);
  const Matrix one = matrix_of(cube, options, true), two = matrix_of(cube, options, true, Storage::dense, 2),
               sparse = matrix_of(cube, options, true, Storage::sparse);
  for (std::size_t i = 0; i < one->size(); ++i)
    for (std::size_t j = 0; j < one->size(); ++j) {
      ASSERT_EQ(one->at(i, j), two->at(i, j));
      ASSERT_NEAR(one->at(i, j), sparse->at(i, j), 1e-7) << i << ' ' << j;
    }
}

FormFactorMethod method_of(const std::vector<double>& factors, std::size_t n) {
  return {[=](std::uint32_t i, const Progress&) {
            FormFactorRow out;
            for (std::uint32_t j = 0; j < n; ++j)
              if (const double f = factors[i * n + j]; f > 0) out.factors.push_back({j, float(f)}), out.sum += f;
            return out;
          },
          {}};
}

Matrix reciprocal_of(const std::vector<double>& factors, const std::vector<double>& area, Storage storage) {
  Progress progress;
  const std::size_t n = area.size();
  return FormFactorMatrix::make({n, storage, n, n * n * 64 + 4096}, method_of(factors, n), area, true, 1, progress,
                                true);
}

TEST(Reciprocal, WhatIsConsistentStaysAsItIs) {
  const std::vector<double> area{1, 1e-9, 3, 2.5, 0.5};
  double sum = 0;
  for (const double a : area) sum += a;
  std::vector<double> sphere;  // F_ij = A_j / A, a patch sees itself too
  for (std::size_t i = 0; i < 5; ++i)
    for (const double a : area) sphere.push_back(a / sum);
  for (const Storage storage : {Storage::dense, Storage::sparse}) {
    const Matrix m = reciprocal_of(sphere, area, storage);
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j) EXPECT_NEAR(m->at(i, j) / sphere[i * 5 + j], 1, 1e-6);
  }
}

// A small patch that the large one's pixels missed is seen again.
TEST(Reciprocal, WhatOneSideMissedComesFromTheOther) {
  const std::vector<double> f{0, 1, 0, 0.5, 0, 0.5, 0.5, 0.5, 0};
  for (const Storage storage : {Storage::dense, Storage::sparse}) {
    const Matrix m = reciprocal_of(f, {1, 1, 0.2}, storage);
    EXPECT_GT(m->at(0, 2), 0.01);
    EXPECT_NEAR(m->at(0, 2), 0.2 * m->at(2, 0), 1e-7);
    EXPECT_NEAR(m->row_sum(2), 1, 1e-13);
  }
}

// No exchange can be right for both: sums stay, finite and not negative.
TEST(Reciprocal, WhatCannotBeConsistentKeepsItsSums) {
  const Matrix two = reciprocal_of({0, 1, 1, 0}, {1, 4}, Storage::dense);
  EXPECT_NEAR(two->at(0, 1), 1, 1e-12);
  EXPECT_NEAR(two->at(1, 0), 1, 1e-12);
  const Matrix none = reciprocal_of({0, 0, 0, 0, 0, 1, 0, 1, 0}, {1, 0, 1}, Storage::sparse);
  EXPECT_EQ(none->row_sum(0), 0);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_GE(none->at(i, j), 0);
}

}  // namespace
}  // namespace cg
