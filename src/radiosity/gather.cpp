// Jacobi's and Gauss and Seidel's iteration: a patch gathers the light of all others, B_i = E_i + rho_i sum_j F_ij B_j,
// from the values of the sweep before or from the newest. This work is based on: Cindy Goral, Kenneth Torrance, Donald
// Greenberg, Bennett Battaile, Modeling the Interaction of Light Between Diffuse Surfaces, 1984; Michael Cohen, Donald
// Greenberg, The Hemi-Cube: A Radiosity Solution for Complex Environments, 1985 (Gauss-Seidel).
#include "radiosity/iteration.h"

namespace cg {

void Growth::see(const glm::dvec3& before, const glm::dvec3& now) {
  constexpr double rounding = 1e-12;
  for (int c = 0; c < 3; ++c) {
    fell_[c] = fell_[c] || !(now[c] >= before[c] * (1 - rounding));
    any_[c] = any_[c] || before[c] > 0;
  }
}

bool Growth::proven() const {
  for (int c = 0; c < 3; ++c)
    if (any_[c] && !fell_[c]) return true;
  return false;
}

namespace {

class Gather final : public Iteration {
 public:
  Gather(std::shared_ptr<const SolverData> data, bool gauss_seidel)
      : data_(std::move(data)),
        gauss_seidel_(gauss_seidel),
        b_(data_->emission),
        next_(gauss_seidel ? Channels() : Channels(b_.size())),
        change_(b_.size(), glm::dvec3(0)) {}

  std::unique_ptr<Iteration> copy() const override { return std::make_unique<Gather>(*this); }
  void become(const Iteration& other) override { *this = static_cast<const Gather&>(other); }
  std::size_t bytes() const override {
    return (gauss_seidel_ ? 1 : 2) * b_.bytes() + change_.size() * sizeof(glm::dvec3);
  }
  std::size_t steps_a_sweep() const override { return b_.size(); }
  std::optional<Standing> standing() const override { return standing_; }
  std::optional<std::size_t> active() const override { return row_; }
  std::vector<glm::dvec3> radiosity() const override { return b_.vectors(); }

  void step(RowSource& rows, Progress& progress) override {
    const std::size_t i = row_;
    const glm::dvec3 value = data_->emission[i] + data_->reflectance[i] * received(rows, progress);
    const glm::dvec3 change = value - b_[i];
    growth_.see(change_[i], change);
    change_[i] = change;
    largest_change_ = std::max(largest_change_, largest(glm::abs(change)));
    brightest_ = std::max(brightest_, largest(value));
    (gauss_seidel_ ? b_ : next_).set(i, value);
    standing_.reset();
    if (++row_ == b_.size()) end_sweep();
  }

 private:
  // sum_j F_ij b_j of the next row. Some rows are multiplied at once by the light that there is before the first of
  // them; what those among them have changed since is added.
  glm::dvec3 received(RowSource& rows, Progress& progress) {
    const FormFactorMatrix& m = rows.matrix();
    if (row_ >= m.kept_rows() || m.storage() == Storage::sparse) return rows.times(row_, b_, progress);
    const std::size_t k = row_ % at_once, first = row_ - k;
    if (k == 0) m.times(first, b_, ahead_);
    glm::dvec3 sum = ahead_[k];
    if (gauss_seidel_)
      for (std::size_t j = first; j < row_; ++j) sum += m.at(row_, j) * change_[j];
    return sum;
  }

  // What is left of the residual is rho F times changes of this sweep: at most row_bound times the largest of them.
  void end_sweep() {
    if (!gauss_seidel_) std::swap(b_, next_);
    standing_ = Standing{data_->row_bound * largest_change_, brightest_, true, swept_ && growth_.proven()};
    swept_ = true;
    growth_ = {};
    largest_change_ = brightest_ = 0;
    row_ = 0;
  }

  static constexpr std::size_t at_once = FormFactorMatrix::rows_at_once;

  std::shared_ptr<const SolverData> data_;
  bool gauss_seidel_;
  Channels b_, next_;               // next_: of the sweep that is under way, Jacobi's
  std::vector<glm::dvec3> change_;  // of each patch, when it was last computed
  std::size_t row_ = 0;
  std::array<glm::dvec3, at_once> ahead_{};    // of the rows that were multiplied at once
  double largest_change_ = 0, brightest_ = 0;  // of this sweep
  bool swept_ = false;
  Growth growth_;
  std::optional<Standing> standing_;
};

}  // namespace

std::unique_ptr<Iteration> make_gather(std::shared_ptr<const SolverData> data, bool gauss_seidel) {
  return std::make_unique<Gather>(std::move(data), gauss_seidel);
}

}  // namespace cg
