#include "radiosity/row_source.h"

#include "raster/workers.h"

namespace cg {

glm::dvec3 RowSource::times(std::size_t i, const Channels& x, Progress& progress) {
  return i < matrix_->kept_rows() ? matrix_->times(i, x) : passing(i, progress).times(x);
}

void RowSource::add(std::size_t i, const glm::dvec3& x, const Channels& factor, Channels& y, Progress& progress) {
  if (i < matrix_->kept_rows()) return matrix_->add_row(i, x, factor, y);
  // Shooting takes rows in no order: none is computed ahead.
  (i >= first_ && i - first_ < ahead_.size() ? ahead_[i - first_] : matrix_->passing_row(i, progress))
      .add(x, factor, y);
}

const PassingRow& RowSource::passing(std::size_t i, Progress& progress) {
  constexpr std::size_t rows_a_thread = 4;
  if (i >= first_ && i - first_ < ahead_.size()) return ahead_[i - first_];
  std::vector<PassingRow> rows(std::min(rows_a_thread * std::size_t(threads_), matrix_->size() - i));
  Workers(threads_, progress).for_each(int(rows.size()), [&](int k) {
    rows[std::size_t(k)] = matrix_->passing_row(i + std::size_t(k), progress);
  });
  first_ = i;
  ahead_ = std::move(rows);
  return ahead_.front();
}

}  // namespace cg
