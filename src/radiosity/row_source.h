// Rows of F for one solver: those that are kept as they are, the others computed when they are needed, several ahead by
// several threads where they are asked for in order.
#pragma once
#include "radiosity/matrix_rows.h"

namespace cg {

class RowSource {
 public:
  RowSource(std::shared_ptr<const FormFactorMatrix> matrix, int threads)
      : matrix_(std::move(matrix)), threads_(threads > 1 ? threads : 1) {}

  const FormFactorMatrix& matrix() const { return *matrix_; }
  // sum_j F_ij x_j. Throws Cancelled.
  glm::dvec3 times(std::size_t i, const Channels& x, Progress& progress);
  // y_j += F_ij x factor_j for every j. Throws Cancelled, and then y is as it was.
  void add(std::size_t i, const glm::dvec3& x, const Channels& factor, Channels& y, Progress& progress);
  // visit(j, F_ij) where that is not 0. Throws Cancelled.
  template <class Visit>
  void visit(std::size_t i, Progress& progress, const Visit& visit);

 private:
  const PassingRow& passing(std::size_t i, Progress& progress);

  std::shared_ptr<const FormFactorMatrix> matrix_;
  int threads_;
  std::size_t first_ = 0;  // the row of ahead_[0]
  std::vector<PassingRow> ahead_;
};

template <class Visit>
void RowSource::visit(std::size_t i, Progress& progress, const Visit& visit) {
  if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
  if (i < matrix_->kept_rows()) return matrix_->visit(i, visit);
  const PassingRow& row = passing(i, progress);
  for (const FormFactor& f : row.factors) visit(std::size_t(f.patch), f.value * row.scale);
}

}  // namespace cg
