// (1 - rho F) B = E by LU decomposition with partial pivoting, the reference of the iterative solvers. Eigen's products
// and triangular solutions, in blocks of columns so that it can be cancelled between two of them (Gene Golub, Charles
// Van Loan, Matrix Computations, 1983: block LU).
#if defined(__GNUC__) && !defined(__clang__)
// GCC 12 takes the undefined registers of its own AVX-512 intrinsics for uninitialised values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <Eigen/Dense>

#include "params/input_error.h"
#include "radiosity/iteration.h"

namespace cg {

namespace {

using Matrix = Eigen::MatrixXd;

constexpr std::size_t most_patches = 8192;  // 512 MiB in double
constexpr Eigen::Index block = 64, strip = 512;

class Direct final : public Iteration {
 public:
  explicit Direct(std::shared_ptr<const SolverData> data) : data_(std::move(data)), b_(data_->emission) {}

  std::unique_ptr<Iteration> copy() const override { return std::make_unique<Direct>(*this); }
  void become(const Iteration& other) override { *this = static_cast<const Direct&>(other); }
  std::size_t bytes() const override { return b_.bytes(); }
  std::size_t steps_a_sweep() const override { return 1; }
  std::optional<Standing> standing() const override { return standing_; }
  std::optional<std::size_t> active() const override { return std::nullopt; }
  std::vector<glm::dvec3> radiosity() const override { return b_.vectors(); }

  // A channel with the reflectances of one before needs no decomposition of its own.
  void step(RowSource& rows, Progress& progress) override {
    Channels b(b_.size());
    for (int c = 0; c < 3; ++c) {
      if (same(c, 0) && c > 0) continue;
      if (c == 2 && same(2, 1)) continue;
      solve(c, rows, progress, b);
    }
    b_ = Channels(b.vectors());
    measure(rows, progress);
  }

 private:
  bool same(int c, int d) const {
    const double *a = data_->reflectance.plane(c), *b = data_->reflectance.plane(d);
    return std::equal(a, a + b_.size(), b);
  }

  // Of channel c and those after it with the same reflectances.
  void solve(int c, RowSource& rows, Progress& progress, Channels& b) {
    const auto n = Eigen::Index(b_.size());
    Matrix a = Matrix::Identity(n, n), light(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double rho = data_->reflectance.plane(c)[i];
      rows.visit(std::size_t(i), progress, [&](std::size_t j, double f) { a(i, Eigen::Index(j)) -= rho * f; });
      for (int d = 0; d < 3; ++d) light(i, d) = data_->emission.plane(d)[i];
    }
    decompose(a, light, progress);
    a.triangularView<Eigen::UnitLower>().solveInPlace(light);
    a.triangularView<Eigen::Upper>().solveInPlace(light);
    for (int d = c; d < 3; ++d)
      if (same(d, c)) std::copy(light.col(d).begin(), light.col(d).end(), b.plane_alone(d));
  }

  // P A = L U in place; `light` is permuted as the rows of A are.
  static void decompose(Matrix& a, Matrix& light, Progress& progress) {
    const Eigen::Index n = a.rows();
    for (Eigen::Index k = 0; k < n; k += block) {
      const Eigen::Index width = std::min(block, n - k), rest = n - k - width;
      decompose_panel(a, light, k, width);
      const auto below = a.block(k + width, k, rest, width);
      for (Eigen::Index j = k + width; j < n; j += strip) {
        if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
        const Eigen::Index columns = std::min(strip, n - j);
        auto right = a.block(k, j, width, columns);
        a.block(k, k, width, width).triangularView<Eigen::UnitLower>().solveInPlace(right);
        a.block(k + width, j, rest, columns).noalias() -= below * right;
      }
      const double left = double(rest) / double(n);
      progress.fraction.store(float(1 - left * left * left), std::memory_order_relaxed);
    }
  }

  static void decompose_panel(Matrix& a, Matrix& light, Eigen::Index k, Eigen::Index width) {
    const Eigen::Index n = a.rows();
    for (Eigen::Index p = k; p < k + width; ++p) {
      Eigen::Index pivot = 0;
      a.col(p).tail(n - p).cwiseAbs().maxCoeff(&pivot);
      if (pivot != 0) {
        a.row(p).swap(a.row(p + pivot));
        light.row(p).swap(light.row(p + pivot));
      }
      if (a(p, p) == 0) continue;  // singular: infinite light, which measure() finds
      a.col(p).tail(n - p - 1) /= a(p, p);
      const Eigen::Index columns = k + width - p - 1;
      a.block(p + 1, p + 1, n - p - 1, columns).noalias() -=
          a.col(p).tail(n - p - 1) * a.row(p).segment(p + 1, columns);
    }
  }

  // A negative or infinite B means that the series of bounces has no sum, whatever the equations' solution is.
  void measure(RowSource& rows, Progress& progress) {
    Standing s{0, 0, true, false};
    for (std::size_t i = 0; i < b_.size(); ++i) {
      const glm::dvec3 b = b_[i];
      s.residual = std::max(
          s.residual, largest(glm::abs(data_->emission[i] + data_->reflectance[i] * rows.times(i, b_, progress) - b)));
      s.brightest = std::max(s.brightest, largest(b));
      s.grows = s.grows || !(std::min(b.x, std::min(b.y, b.z)) >= -1e-9 * s.brightest) || !std::isfinite(largest(b));
    }
    standing_ = s;
  }

  std::shared_ptr<const SolverData> data_;
  Channels b_;
  std::optional<Standing> standing_;
};

}  // namespace

std::unique_ptr<Iteration> make_direct(std::shared_ptr<const SolverData> data) {
  const std::size_t n = data->emission.size();
  if (n > most_patches)
    throw InputError("radiosity.solver",
                     {"LU grows with the cube of the patches, and there are " + std::to_string(n),
                      "LU 分解の手間はパッチ数の 3 乗に比例する（いまは " + std::to_string(n) + " パッチ）"},
                     {"lu works up to 8192 patches, gauss-seidel with any number",
                      "lu は 8192 パッチまで。gauss-seidel なら制限はない"});
  return std::make_unique<Direct>(std::move(data));
}

}  // namespace cg
