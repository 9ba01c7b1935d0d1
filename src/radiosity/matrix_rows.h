// The rows of FormFactorMatrix as they are kept, and a visit of one.
#pragma once
#include <cassert>
#include <new>

#include "radiosity/matrix.h"

namespace cg {

// Numbers from one dense row to the next: an odd number of cache lines, so that neighbouring rows, which are read at
// once, do not fall into the same places of the cache.
inline std::size_t dense_stride(std::size_t size) {
  constexpr std::size_t line = 64 / sizeof(float);
  return ((size + line - 1) / line | 1) * line;
}

// What a row that is kept sparse takes.
inline std::size_t sparse_row_bytes(std::size_t entries) {
  return entries * sizeof(FormFactor) + sizeof(std::vector<FormFactor>) + 16;  // 16: of the allocation
}

template <class Work>
auto FormFactorMatrix::with_row(std::size_t i, const Work& work) const {
  assert(i < kept_);
  if (storage_ == Storage::sparse) return work(sparse_[i]);
  return doubles_ ? work(doubles_.get() + i * stride_) : work(floats_.get() + i * stride_);
}

template <class Visit>
void visit_row(const std::vector<FormFactor>& row, std::size_t, const Visit& visit) {
  for (const FormFactor& f : row) visit(std::size_t(f.patch), double(f.value));
}
template <class Real, class Visit>
void visit_row(const Real* row, std::size_t size, const Visit& visit) {
  for (std::size_t j = 0; j < size; ++j)
    if (row[j] != 0) visit(j, double(row[j]));
}

template <class Visit>
void FormFactorMatrix::visit(std::size_t i, const Visit& visit) const {
  const double scale = scale_[i];
  with_row(i, [&](const auto& row) { visit_row(row, size(), [&](std::size_t j, double f) { visit(j, f * scale); }); });
}

template <class Real>
FormFactorMatrix::Numbers<Real> FormFactorMatrix::numbers(std::size_t rows) const {
  constexpr std::size_t alignment = 64;
  const std::size_t bytes = (rows * stride_ * sizeof(Real) / alignment + 1) * alignment;
  Numbers<Real> out(static_cast<Real*>(std::aligned_alloc(alignment, bytes)));
  if (!out) throw std::bad_alloc();
  return out;
}

}  // namespace cg
