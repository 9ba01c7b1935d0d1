// Shooting: the patch with the most unshot power sends it to all others. Southwell's relaxation shows what has been
// shot; progressive refinement also what has arrived, and an estimate of what is still under way. This work is based
// on: Michael Cohen, Shenchang Chen, John Wallace, Donald Greenberg, A Progressive Refinement Approach to Fast
// Radiosity Image Generation, 1988; Steven Gortler, Michael Cohen, Philipp Slusallek, Radiosity and Relaxation Methods,
// 1994.
#include "radiosity/iteration.h"

namespace cg {

namespace {

class Shooting final : public Iteration {
 public:
  Shooting(std::shared_ptr<const SolverData> data, bool progressive)
      : data_(std::move(data)),
        progressive_(progressive),
        b_(data_->emission.size()),
        unshot_(data_->emission),
        before_(data_->emission) {
    for (std::size_t i = 0; i < b_.size(); ++i) {
      total_area_ += areas()[i];
      mean_reflectance_ += data_->reflectance[i] * areas()[i];
      if (areas()[i] > 0) continue;
      b_.set(i, unshot_[i]);  // it has nothing to shoot
      unshot_.set(i, glm::dvec3(0));
    }
    mean_reflectance_ /= std::max(total_area_, 1e-300);
    choose();
  }

  std::unique_ptr<Iteration> copy() const override { return std::make_unique<Shooting>(*this); }
  void become(const Iteration& other) override { *this = static_cast<const Shooting&>(other); }
  std::size_t bytes() const override { return 3 * b_.bytes(); }
  std::size_t steps_a_sweep() const override { return b_.size(); }
  std::optional<Standing> standing() const override { return standing_; }
  std::optional<std::size_t> active() const override { return next_; }
  const Channels* unshot() const override { return &unshot_; }

  std::vector<glm::dvec3> radiosity() const override {
    std::vector<glm::dvec3> out = b_.vectors();
    if (progressive_)
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += unshot_[i];
    return out;
  }

  // The unshot light as if it were spread evenly: its mean, and all its bounces by the mean reflectance.
  glm::dvec3 ambient() const override {
    glm::dvec3 sum(0);
    if (!progressive_) return sum;
    for (std::size_t i = 0; i < b_.size(); ++i) sum += unshot_[i] * areas()[i];
    for (int c = 0; c < 3; ++c)
      sum[c] = mean_reflectance_[c] < 1 ? sum[c] / (total_area_ * (1 - mean_reflectance_[c])) : 0;
    return sum;
  }

  void step(RowSource& rows, Progress& progress) override {
    const std::size_t i = next_;
    const glm::dvec3 shot = unshot_[i];
    if (data_->columns)
      data_->columns->add_row(i, shot, data_->shot, unshot_);
    else
      rows.add(i, shot * areas()[i], data_->shot, unshot_, progress);
    unshot_.set(i, unshot_[i] - shot);
    b_.set(i, b_[i] + shot);
    brightest_ = std::max(brightest_, largest(b_[i]));
    const double most = choose();
    // What progressive refinement shows holds the unshot light too: of that only its next bounce is missing.
    const double residual = progressive_ ? data_->row_bound * most : most;
    standing_ = Standing{residual, brightest_, ++shots_ == b_.size(), false};
    if (standing_->swept) end_sweep();
  }

 private:
  const std::vector<double>& areas() const { return data_->system.matrix->area(); }

  // The patch with the most power, and the largest unshot radiosity of all.
  double choose() {
    double most_power = -1, most = 0;
    const double *r = unshot_.plane(0), *g = unshot_.plane(1), *b = unshot_.plane(2);
    for (std::size_t i = 0; i < unshot_.size(); ++i) {
      const double power = areas()[i] * (r[i] + g[i] + b[i]);
      if (power > most_power) most_power = power, next_ = i;
      most = std::max(most, std::max(r[i], std::max(g[i], b[i])));
    }
    return most;
  }

  // Where nothing became less in as many shots as there are patches, nothing ever will: what is still to come of B is
  // (1 - rho F)^-1 times the unshot light, and B did grow.
  void end_sweep() {
    Growth growth;
    for (std::size_t i = 0; i < b_.size(); ++i) growth.see(before_[i], unshot_[i]);
    standing_->grows = growth.proven();
    before_ = unshot_;
    shots_ = 0;
  }

  std::shared_ptr<const SolverData> data_;
  bool progressive_;
  Channels b_, unshot_;  // shot, and not
  Channels before_;      // unshot_ at the beginning of the sweep
  glm::dvec3 mean_reflectance_{0};
  double total_area_ = 0, brightest_ = 0;
  std::size_t next_ = 0, shots_ = 0;
  std::optional<Standing> standing_;
};

}  // namespace

std::unique_ptr<Iteration> make_shooting(std::shared_ptr<const SolverData> data, bool progressive) {
  return std::make_unique<Shooting>(std::move(data), progressive);
}

void prepare_shooting(SolverData& data, double memory, const Progress* progress) {
  constexpr double mebibyte = 1024.0 * 1024.0;
  const FormFactorMatrix& m = *data.system.matrix;
  if (m.whole() && 2 * double(m.bytes()) <= memory * mebibyte) data.columns = m.transposed(progress);
  data.shot = Channels(m.size());
  for (std::size_t j = 0; j < m.size(); ++j) {
    const double area = m.area()[j];
    const double factor = data.columns ? m.scale(j) : area > 0 ? 1 / area : 0;
    data.shot.set(j, data.reflectance[j] * factor);
  }
}

}  // namespace cg
