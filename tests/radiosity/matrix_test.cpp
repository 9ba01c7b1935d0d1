// What is kept of the form factors, and that nothing but time and memory depends on it.
#include <chrono>
#include <thread>

#include "radiosity/matrix_rows.h"
#include "tests/radiosity/systems.h"
#include "tests/sanitized.h"

namespace cg {
namespace {

// Row i sees `entries` patches spread over all, with weights of its own that sum to `sum`.
FormFactorMethod spread_rows(std::size_t n, std::size_t entries, double sum = 1) {
  const auto row = [=](std::uint32_t i, const Progress& progress) {
    if (progress.cancelled) throw Cancelled{};
    FormFactorRow out;
    double all = 0;
    const std::size_t step = n / entries;
    for (std::size_t k = 0; k < entries; ++k) {
      const std::size_t j = k * step + (i * 2654435761u + k * 40503u) % step;
      if (j == i) continue;
      out.factors.push_back({std::uint32_t(j), float(1 + (i * 7 + j * 13) % 11)});
      all += out.factors.back().value;
    }
    for (FormFactor& f : out.factors) f.value = float(f.value * sum / all);
    out.sum = sum;
    return out;
  };
  return {row, {}};
}

std::shared_ptr<const FormFactorMatrix> matrix_of(std::size_t n, const FormFactorMethod& method, double memory,
                                                  int threads = 1) {
  Progress progress;
  return FormFactorMatrix::make(plan_matrix(n, method, memory, progress), method, std::vector<double>(n, 1), true,
                                threads, progress);
}

RadiositySystem lit(std::shared_ptr<const FormFactorMatrix> matrix, double rho = .7) {
  const std::size_t n = matrix->size();
  RadiositySystem out{std::move(matrix), std::vector<glm::dvec3>(n), std::vector<glm::dvec3>(n, glm::dvec3(rho))};
  for (std::size_t i = 0; i < n; i += 10) out.emission[i] = glm::dvec3(1 + double(i % 3), 1, .5);
  return out;
}

TEST(MatrixTest, ThePlanDecidesByFillAndMemory) {
  Progress progress;
  const auto plan = [&](std::size_t n, std::size_t entries, double memory) {
    return plan_matrix(n, spread_rows(n, entries), memory, progress);
  };
  const MatrixPlan small = plan(100, 10, 1), full = plan(2000, 1900, 64), thin = plan(2000, 100, 64);
  EXPECT_EQ(small.storage, Storage::dense);
  EXPECT_EQ(full.storage, Storage::dense);
  EXPECT_EQ(full.kept_rows, 2000u);
  EXPECT_EQ(full.bytes, 2000u * 2000 * 4);
  EXPECT_EQ(thin.storage, Storage::sparse);
  EXPECT_EQ(thin.kept_rows, 2000u);
  EXPECT_LT(thin.bytes, full.bytes / 4);
  EXPECT_NEAR(thin.fill, .05, 1e-3);
  // Too full to be sparse, or too large for either: as many rows as fit.
  const MatrixPlan half = plan(2000, 1900, 8), little = plan(2000, 100, 1);
  EXPECT_EQ(half.storage, Storage::dense);
  EXPECT_EQ(half.kept_rows, 8u * 1024 * 1024 / 8000);
  EXPECT_EQ(little.storage, Storage::sparse);
  EXPECT_LE(little.bytes, 1u << 20);
  EXPECT_GT(little.kept_rows, 500u);
  EXPECT_NE(little.text().en.find("computed again"), std::string::npos);
}

TEST(MatrixTest, WhatIsKeptIsWithinWhatWasAnnounced) {
  Progress progress;
  for (const double memory : {1., 2., 8., 64.})
    for (const std::size_t entries : {20u, 200u, 1200u}) {
      const FormFactorMethod method = spread_rows(1500, entries);
      const MatrixPlan plan = plan_matrix(1500, method, memory, progress);
      const auto m = FormFactorMatrix::make(plan, method, std::vector<double>(1500, 1), true, 2, progress);
      EXPECT_LE(m->bytes(), plan.bytes);
      EXPECT_LE(plan.bytes, memory * 1024 * 1024);
      EXPECT_GE(double(m->kept_rows()), 0.99 * double(plan.kept_rows));
    }
}

TEST(MatrixTest, TheLightDoesNotDependOnWhatIsKept) {
  const std::size_t n = 1200;
  const FormFactorMethod thin = spread_rows(n, 60);
  const auto dense = FormFactorMatrix::make({n, Storage::dense, n, n * n * 4}, thin, std::vector<double>(n, 1), true, 1,
                                            *std::make_unique<Progress>());
  const auto sparse = matrix_of(n, thin, 64), some = matrix_of(n, thin, .3), none = matrix_of(n, thin, 1e-6);
  EXPECT_EQ(sparse->storage(), Storage::sparse);
  EXPECT_TRUE(sparse->whole());
  EXPECT_GT(some->kept_rows(), 100u);
  EXPECT_LT(some->kept_rows(), n);
  EXPECT_EQ(none->kept_rows(), 0u);
  const auto expected = solve(lit(dense), with_solver(RadiositySolver::gauss_seidel));
  for (const auto& matrix : {sparse, some, none})
    for (const RadiositySolver kind : {RadiositySolver::jacobi, RadiositySolver::gauss_seidel}) {
      const auto b = solve(lit(matrix), with_solver(kind));
      for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(b[i].x, expected[i].x, 1e-8) << i;
    }
  // Columns of the whole ones: the same system for the solvers that shoot.
  for (const auto& matrix : {dense, sparse}) {
    const auto b = solve(lit(matrix), with_solver(RadiositySolver::southwell, 1e-8));
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(b[i].x, expected[i].x, 1e-6) << i;
  }
}

TEST(MatrixTest, ThreadsChangeNoBit) {
  for (const std::size_t entries : {40u, 600u})
    for (const double memory : {.4, 64.}) {
      const FormFactorMethod method = spread_rows(1300, entries);
      const auto one = matrix_of(1300, method, memory, 1), many = matrix_of(1300, method, memory, 7);
      ASSERT_EQ(one->kept_rows(), many->kept_rows());
      const Channels x(lit(one).emission);
      for (std::size_t i = 0; i < one->kept_rows(); ++i) ASSERT_TRUE(one->times(i, x) == many->times(i, x));
      Progress progress;
      EXPECT_EQ(one->figures(1, progress).reciprocity_relative, many->figures(7, progress).reciprocity_relative);
    }
}

TEST(MatrixTest, RowSumsAndReciprocity) {
  Progress progress;
  const auto m = FormFactorMatrix::of(std::vector<double>{0, .5, .4, .2, 0, .7, .2, .35, 0}, {1, 2, 2});
  const MatrixFigures f = m->figures(1, progress);
  EXPECT_EQ(f.rows, 3u);
  EXPECT_NEAR(f.least_sum, .55, 1e-6);
  EXPECT_NEAR(f.greatest_sum, .9, 1e-6);
  EXPECT_NEAR(f.sum_error(), .45, 1e-6);
  EXPECT_NEAR(f.reciprocity_error, .7, 1e-12);  // 2 x 0.7 against 2 x 0.35
  EXPECT_NEAR(f.reciprocity_relative, std::sqrt((.01 + 0 + .49) / (.45 * .45 + .4 * .4 + 1.05 * 1.05)), 1e-12);
  // Sparse, with entries that have no counterpart.
  const std::size_t n = 1500;
  const FormFactorMethod method = spread_rows(n, 30);
  const auto sparse = matrix_of(n, method, 64);
  const auto dense =
      FormFactorMatrix::make({n, Storage::dense, n, n * n * 4}, method, std::vector<double>(n, 1), true, 1, progress);
  ASSERT_EQ(sparse->storage(), Storage::sparse);
  EXPECT_DOUBLE_EQ(sparse->figures(2, progress).reciprocity_error, dense->figures(2, progress).reciprocity_error);
  EXPECT_NEAR(sparse->figures(2, progress).reciprocity_relative, dense->figures(2, progress).reciprocity_relative,
              1e-12);
}

TEST(MatrixTest, TransposedIsTransposed) {
  for (const std::size_t entries : {30u, 900u}) {
    const std::size_t n = 1500;
    const auto m = matrix_of(n, spread_rows(n, entries), 64), t = m->transposed();
    for (std::size_t i = 0; i < n; i += 37)
      for (std::size_t j = 0; j < n; j += 11) ASSERT_EQ(t->at(i, j) * m->scale(j), m->at(j, i));
  }
}

// Floats round each factor, but rows that were normalised sum to 1 in double, and so does every sum of light.
TEST(MatrixTest, AFurnaceKeepsTheDigitsOfDouble) {
  const auto m = matrix_of(300, spread_rows(300, 250), 64);
  for (const double rho : {.9, .99, .999}) {
    RadiositySystem s = lit(m, rho);
    s.emission.assign(300, glm::dvec3(1));
    for (const glm::dvec3& b : solve(s, with_solver(RadiositySolver::gauss_seidel)))
      ASSERT_NEAR(b.x * (1 - rho), 1, 1e-9) << rho;
  }
}

// `work` is cancelled after a while by another thread: how long it goes on, ms.
template <class Work>
double ms_after_cancel(const Work& work) {
  using Clock = std::chrono::steady_clock;
  Progress progress;
  Clock::time_point cancelled;
  std::jthread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    cancelled = Clock::now();
    progress.cancelled = true;
  });
  EXPECT_THROW(work(progress), Cancelled);
  return std::chrono::duration<double, std::milli>(Clock::now() - cancelled).count();
}

constexpr double most_ms = sanitized ? 500 : 100;

TEST(MatrixTest, CancellingIsHeardAtOnce) {
  const auto slow = [](std::uint32_t, const Progress&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return FormFactorRow{};
  };
  EXPECT_LT(
      ms_after_cancel([&](Progress& p) {
        FormFactorMatrix::make({4000, Storage::dense, 4000, 0}, {slow, {}}, std::vector<double>(4000, 1), false, 2, p);
      }),
      most_ms);
  const auto m = matrix_of(2000, spread_rows(2000, 1900), 64);
  for (const RadiositySolver kind : all_solvers) {
    Solver solver(lit(m, .99999), with_solver(kind, 1e-14));
    EXPECT_LT(ms_after_cancel([&](Progress& p) { solver.run(p); }), most_ms) << int(kind);
    const auto before = solver.radiosity();
    if (kind == RadiositySolver::lu) continue;
    Progress again;  // it goes on from where it was
    solver.step(again);
    EXPECT_GT(solver.steps(), 0u);
    EXPECT_EQ(before.size(), 2000u);
  }
}

}  // namespace
}  // namespace cg
