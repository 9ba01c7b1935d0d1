#include "radiosity/matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "radiosity/matrix_rows.h"
#include "radiosity/row_kernels.h"

namespace cg {

namespace {

// How far the sum of floats that were normalised in double may be from 1.
constexpr double float_rounding = 1e-4;

template <class Real>
glm::dvec3 dot_of(const Real* row, const Channels& x) {
  glm::dvec3 out;
  dot<1>(row, 0, x, &out);
  return out;
}
glm::dvec3 dot_of(const std::vector<FormFactor>& row, const Channels& x) { return dot(row, x); }

double sum_of(const std::vector<FormFactor>& row) {
  double sum = 0;
  for (const FormFactor& f : row) sum += f.value;
  return sum;
}

void check(const Progress* progress) {
  if (progress && progress->cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
}

// A square of n numbers a side, a tile at a time so that both sides stay in the cache.
template <class Real>
void transpose(const Real* from, Real* to, std::size_t n, std::size_t stride, const Progress* progress) {
  constexpr std::size_t tile = 32;
  for (std::size_t j0 = 0; j0 < n; j0 += tile) {
    check(progress);
    std::fill(to + j0 * stride, to + std::min(j0 + tile, n) * stride, Real(0));
    for (std::size_t i0 = 0; i0 < n; i0 += tile)
      for (std::size_t i = i0; i < std::min(i0 + tile, n); ++i)
        for (std::size_t j = j0; j < std::min(j0 + tile, n); ++j) to[j * stride + i] = from[i * stride + j];
  }
}

}  // namespace

void FormFactorMatrix::set_up(std::vector<double> area) {
  area_ = std::move(area);
  stride_ = dense_stride(area_.size());
  scale_.assign(area_.size(), 1.0);
  sums_.assign(area_.size(), 0.0);
}

double FormFactorMatrix::scale_of(double sum) const {
  return normalised_ && std::abs(sum - 1) < float_rounding ? 1 / sum : 1;
}

void FormFactorMatrix::note(std::size_t i, const FormFactorRow& row) {
  const double sum = sum_of(row.factors);
  figures_[i] = {float(row.sum), row.missed};
  scale_[i] = scale_of(sum);
  sums_[i] = sum * scale_[i];
}

std::shared_ptr<const FormFactorMatrix> FormFactorMatrix::of(std::span<const double> factors,
                                                             std::vector<double> area) {
  const std::size_t n = area.size();
  assert(factors.size() == n * n);
  std::shared_ptr<FormFactorMatrix> m(new FormFactorMatrix);
  m->set_up(std::move(area));
  m->doubles_ = m->numbers<double>(n);
  m->kept_ = n;
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = factors.subspan(i * n, n);
    double* out = std::copy(row.begin(), row.end(), m->doubles_.get() + i * m->stride_);
    std::fill(out, m->doubles_.get() + (i + 1) * m->stride_, 0.0);
    m->sums_[i] = std::accumulate(row.begin(), row.end(), 0.0);
    m->figures_.push_back({float(m->sums_[i]), 0});
  }
  return m;
}

std::size_t FormFactorMatrix::bytes() const {
  if (storage_ == Storage::dense) return kept_ * stride_ * (doubles_ ? sizeof(double) : sizeof(float));
  std::size_t sum = 0;
  for (const auto& row : sparse_) sum += sparse_row_bytes(row.size());
  return sum;
}

glm::dvec3 FormFactorMatrix::times(std::size_t i, const Channels& x) const {
  return with_row(i, [&](const auto& row) { return dot_of(row, x); }) * scale_[i];
}

void FormFactorMatrix::times(std::size_t i, const Channels& x, std::array<glm::dvec3, rows_at_once>& out) const {
  const std::size_t count = std::min(rows_at_once, kept_ - i);
  if (storage_ == Storage::sparse || count < rows_at_once) {
    for (std::size_t k = 0; k < count; ++k) out[k] = times(i + k, x);
    return;
  }
  if (doubles_)
    dot<rows_at_once>(doubles_.get() + i * stride_, stride_, x, out.data());
  else
    dot<rows_at_once>(floats_.get() + i * stride_, stride_, x, out.data());
  for (std::size_t k = 0; k < count; ++k) out[k] *= scale_[i + k];
}

void FormFactorMatrix::add_row(std::size_t i, const glm::dvec3& x, const Channels& factor, Channels& y) const {
  with_row(i, [&](const auto& row) { add(row, x * scale_[i], factor, y); });
}

double FormFactorMatrix::at(std::size_t i, std::size_t j) const { return stored(i, j) * scale_[i]; }

double FormFactorMatrix::stored(std::size_t i, std::size_t j) const {
  if (storage_ == Storage::dense) return doubles_ ? doubles_[i * stride_ + j] : double(floats_[i * stride_ + j]);
  const FormFactor* found = entry(i, j);
  return found ? double(found->value) : 0;
}

const FormFactor* FormFactorMatrix::entry(std::size_t i, std::size_t j) const {
  const auto& row = sparse_[i];
  const auto found = std::lower_bound(row.begin(), row.end(), j,
                                      [](const FormFactor& f, std::size_t patch) { return f.patch < patch; });
  return found != row.end() && found->patch == j ? &*found : nullptr;
}

PassingRow FormFactorMatrix::passing_row(std::size_t i, const Progress& progress) const {
  FormFactorRow row = method_.row(std::uint32_t(i), progress);
  const double scale = scale_of(sum_of(row.factors));
  return {std::move(row.factors), scale};
}

FormFactorRow FormFactorMatrix::row(std::size_t i, const Progress& progress) const {
  if (i >= kept_) {
    FormFactorRow out = method_.row(std::uint32_t(i), progress);
    const double scale = scale_of(sum_of(out.factors));
    for (FormFactor& f : out.factors) f.value = float(f.value * scale);
    return out;
  }
  FormFactorRow out;
  out.sum = figures_[i].sum, out.missed = figures_[i].missed;
  visit(i, [&](std::size_t j, double f) { out.factors.push_back({std::uint32_t(j), float(f)}); });
  return out;
}

std::shared_ptr<const FormFactorMatrix> FormFactorMatrix::transposed(const Progress* progress) const {
  assert(whole());
  std::shared_ptr<FormFactorMatrix> m(new FormFactorMatrix);
  m->set_up(area_);
  m->storage_ = storage_;
  m->kept_ = kept_;
  if (storage_ == Storage::sparse) {
    m->sparse_.resize(kept_);
    for (std::size_t i = 0; i < kept_; ++i, check(progress))
      for (const FormFactor& f : sparse_[i]) m->sparse_[f.patch].push_back({std::uint32_t(i), f.value});
  } else if (doubles_) {
    m->doubles_ = numbers<double>(kept_);
    transpose(doubles_.get(), m->doubles_.get(), kept_, stride_, progress);
  } else {
    m->floats_ = numbers<float>(kept_);
    transpose(floats_.get(), m->floats_.get(), kept_, stride_, progress);
  }
  return m;
}

glm::dvec3 PassingRow::times(const Channels& x) const { return dot(factors, x) * scale; }

void PassingRow::add(const glm::dvec3& x, const Channels& factor, Channels& y) const {
  cg::add(factors, x * scale, factor, y);
}

}  // namespace cg
