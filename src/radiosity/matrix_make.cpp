// What of the matrix is kept, and the rows computed by several threads.
#include <atomic>
#include <cmath>

#include "params/numbers.h"
#include "radiosity/matrix_rows.h"
#include "raster/workers.h"

namespace cg {

namespace {

constexpr double mebibyte = 1024.0 * 1024.0;
constexpr std::size_t few_rows = 1024;  // dense they are 4 MiB: nothing to decide
constexpr std::size_t tried_rows = 16;  // of more
constexpr double spare = 1.25;          // times what the tried rows say, as others may be fuller
constexpr double sparse_below = 0.25;   // of the factors: then sparse is half the memory, and no slower to read

// The mean number of entries of rows that are spread evenly.
double mean_entries(std::size_t rows, const FormFactorMethod& method, const Progress& progress) {
  double sum = 0;
  for (std::size_t t = 0; t < tried_rows; ++t)
    sum += double(method.row(std::uint32_t((2 * t + 1) * rows / (2 * tried_rows)), progress).factors.size());
  return sum / double(tried_rows);
}

}  // namespace

MatrixPlan plan_matrix(std::size_t rows, const FormFactorMethod& method, double memory, const Progress& progress) {
  MatrixPlan plan{.rows = rows, .kept_rows = rows};
  const double budget = memory * mebibyte, n = double(rows);
  const double dense_row = double(dense_stride(rows) * sizeof(float));
  double row_bytes = dense_row, share = 1;
  if (rows > few_rows || n * dense_row > budget) {
    const double entries = rows > tried_rows ? mean_entries(rows, method, progress) : n;
    const double sparse_row = double(sparse_row_bytes(0)) + spare * entries * sizeof(FormFactor);
    plan.fill = entries / n;
    if (plan.fill < sparse_below || (n * dense_row > budget && sparse_row < dense_row)) {
      plan.storage = Storage::sparse;
      row_bytes = sparse_row;
    }
  }
  share = std::min(1.0, budget / (n * row_bytes));
  plan.kept_rows = std::size_t(share * n);
  plan.bytes = std::size_t(double(plan.kept_rows) * row_bytes);
  return plan;
}

Text MatrixPlan::text() const {
  const std::string n = std::to_string(rows), kept = std::to_string(kept_rows);
  const bool large = double(bytes) >= mebibyte;
  const std::string size =
      number_text(std::ceil(double(bytes) / (large ? mebibyte : 1024))) + (large ? " MiB" : " KiB");
  const Words kind = storage == Storage::dense ? Words{"dense", "密行列"} : Words{"sparse", "疎行列"};
  const std::string en(kind.en), ja(kind.ja);
  if (kept_rows == rows)
    return {n + " rows of form factors, " + en + ", " + size, "形態係数 " + n + " 行、" + ja + "、" + size};
  return {kept + " of " + n + " rows of form factors are kept, " + en + ", " + size + "; the others are computed again",
          "形態係数 " + n + " 行のうち " + kept + " 行を保存（" + ja + "、" + size + "）、残りは毎回計算し直す"};
}

void FormFactorMatrix::make_dense(std::size_t rows, int threads, Progress& progress) {
  floats_ = numbers<float>(rows);
  kept_ = rows;
  figures_.resize(rows);
  Workers workers(threads, progress);
  std::atomic<std::size_t> done{0};
  workers.for_each(int(rows), [&](int i) {
    const FormFactorRow row = method_.row(std::uint32_t(i), progress);
    note(std::size_t(i), row);
    float* out = floats_.get() + std::size_t(i) * stride_;
    std::fill(out, out + stride_, 0.0f);
    for (const FormFactor& f : row.factors) out[f.patch] = f.value;
    workers.done(float(++done) / float(rows));
  });
}

// In batches, each computed by all threads and then taken in the order of its rows, so that which rows are kept does
// not depend on threads.
void FormFactorMatrix::make_sparse(std::size_t rows, std::size_t bytes, int threads, Progress& progress) {
  constexpr std::size_t batch = 64;
  Workers workers(threads, progress);
  std::vector<FormFactorRow> made(batch);
  figures_.resize(rows);
  for (std::size_t begin = 0; begin < rows; begin += batch) {
    const std::size_t count = std::min(batch, rows - begin);
    workers.for_each(int(count), [&](int k) {
      made[std::size_t(k)] = method_.row(std::uint32_t(begin) + std::uint32_t(k), progress);
    });
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t needs = sparse_row_bytes(made[k].factors.size());
      if (needs > bytes) return figures_.resize(kept_);
      bytes -= needs;
      note(kept_++, made[k]);
      std::vector<FormFactor>& row = made[k].factors;
      row.capacity() == row.size() ? sparse_.push_back(std::move(row))
                                   : void(sparse_.emplace_back(row.begin(), row.end()));
      row = {};
    }
    workers.done(float(begin + count) / float(rows));
  }
}

std::shared_ptr<const FormFactorMatrix> FormFactorMatrix::make(const MatrixPlan& plan, FormFactorMethod method,
                                                               std::vector<double> area, bool normalised, int threads,
                                                               Progress& progress, bool reciprocal) {
  assert(plan.rows == area.size() && plan.kept_rows <= plan.rows);
  std::shared_ptr<FormFactorMatrix> m(new FormFactorMatrix);
  m->set_up(std::move(area));
  m->storage_ = plan.storage;
  m->normalised_ = normalised;
  m->method_ = std::move(method);
  if (plan.storage == Storage::dense)
    m->make_dense(plan.kept_rows, threads, progress);
  else
    m->make_sparse(plan.kept_rows, plan.bytes, threads, progress);
  if (reciprocal && m->whole()) m->make_reciprocal(plan.bytes, threads, progress);
  return m;
}

}  // namespace cg
