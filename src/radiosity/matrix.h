// The matrix of form factors: rows dense, sparse, or computed again whenever they are asked for, as a plan decides from
// their number, how full they are and the memory that is allowed.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>

#include "params/words.h"
#include "radiosity/channels.h"
#include "radiosity/form_factors.h"

namespace cg {

enum class Storage { dense, sparse };

// What will be kept, before it is computed.
struct MatrixPlan {
  std::size_t rows = 0;
  Storage storage = Storage::dense;
  std::size_t kept_rows = 0;  // the first ones; the others are computed again whenever they are asked for
  std::size_t bytes = 0;      // of the kept rows: never passed
  double fill = 1;            // the share of F_ij > 0 in the rows that were tried
  Text text() const;          // "4096 rows of form factors, dense, 64 MiB"
};

// `memory`, MiB, is for the form factors alone. Decides from a few rows, spread evenly, that it computes where there
// are many. Throws Cancelled.
MatrixPlan plan_matrix(std::size_t rows, const FormFactorMethod& method, double memory, const Progress& progress);

struct RowFigures {
  float sum = 0;             // before it was normalised
  std::uint32_t missed = 0;  // patches in front that it has no entry for
};

// Of the kept rows.
struct MatrixFigures {
  std::size_t rows = 0;
  double least_sum = 0, mean_sum = 0, greatest_sum = 0;  // before rows were normalised
  std::size_t missed = 0;                                // of all these rows
  // |A_i F_ij - A_j F_ji|, m^2: the largest, and the root mean square over that of A_i F_ij.
  double reciprocity_error = 0, reciprocity_relative = 0;
  // The largest |sum - 1|.
  double sum_error() const { return rows == 0 ? 0 : std::max(1 - least_sum, greatest_sum - 1); }
};

// A row that is computed to be used once.
struct PassingRow {
  std::vector<FormFactor> factors;
  double scale = 1;
  glm::dvec3 times(const Channels& x) const;
  void add(const glm::dvec3& x, const Channels& factor, Channels& y) const;
};

// Rows of F. F_ij is the float that is kept times the row's scale, in double: a row that was normalised sums to 1 to
// the last digits whatever floats round.
class FormFactorMatrix {
 public:
  // Computes the rows that the plan keeps, by `threads` threads; nothing but the time depends on their number. `area`
  // is the patches', m^2. `normalised`: the method's rows sum to 1 but for the rounding of floats. `reciprocal`: where
  // all rows are kept they are changed so that also A_i F_ij = A_j F_ji, their sums staying what they are. Where not
  // all rows are kept, what the method refers to must outlive the matrix. Throws Cancelled.
  static std::shared_ptr<const FormFactorMatrix> make(const MatrixPlan& plan, FormFactorMethod method,
                                                      std::vector<double> area, bool normalised, int threads,
                                                      Progress& progress, bool reciprocal = false);
  // Factors that are known, row by row: kept as doubles, not normalised.
  static std::shared_ptr<const FormFactorMatrix> of(std::span<const double> factors, std::vector<double> area);

  std::size_t size() const { return area_.size(); }
  std::size_t kept_rows() const { return kept_; }
  bool whole() const { return kept_ == size(); }
  Storage storage() const { return storage_; }
  std::size_t bytes() const;  // of the kept rows
  const std::vector<double>& area() const { return area_; }
  // Of the kept rows.
  const std::vector<RowFigures>& row_figures() const { return figures_; }
  // sum_j F_ij of a kept row, as times() has it.
  double row_sum(std::size_t i) const { return sums_[i]; }
  double scale(std::size_t i) const { return scale_[i]; }

  // sum_j F_ij x_j of a kept row: the same bits on every call.
  glm::dvec3 times(std::size_t i, const Channels& x) const;
  // The same of `rows_at_once` rows from i on, those that are kept: x is read once for all of them.
  static constexpr std::size_t rows_at_once = 8;
  void times(std::size_t i, const Channels& x, std::array<glm::dvec3, rows_at_once>& out) const;
  // y_j += F_ij x factor_j for every j, of a kept row.
  void add_row(std::size_t i, const glm::dvec3& x, const Channels& factor, Channels& y) const;
  // visit(j, F_ij) where that is not 0, j ascending, of a kept row: in matrix_rows.h.
  template <class Visit>
  void visit(std::size_t i, const Visit& visit) const;
  // F_ij of a kept row.
  double at(std::size_t i, std::size_t j) const;
  // A row that is not kept, computed. Throws Cancelled.
  PassingRow passing_row(std::size_t i, const Progress& progress) const;
  // Any row to be looked at, its factors multiplied by the scale: computed where it is not kept. Throws Cancelled.
  FormFactorRow row(std::size_t i, const Progress& progress) const;

  // What is kept, transposed and without scales: at(i, j) of it times scale(j) is F_ji. All rows must be kept.
  // Throws Cancelled where `progress` is not null.
  std::shared_ptr<const FormFactorMatrix> transposed(const Progress* progress = nullptr) const;

  MatrixFigures figures(int threads, Progress& progress) const;

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  template <class Real>
  using Numbers = std::unique_ptr<Real[], Free>;  // aligned for lanes

  FormFactorMatrix() = default;
  void set_up(std::vector<double> area);
  template <class Real>
  Numbers<Real> numbers(std::size_t rows) const;  // stride_ of them a row
  void make_dense(std::size_t rows, int threads, Progress& progress);
  void make_sparse(std::size_t rows, std::size_t bytes, int threads, Progress& progress);
  void make_reciprocal(std::size_t bytes, int threads, Progress& progress);
  void make_symmetric(int threads, Progress& progress);
  void make_symmetric_sparse(std::size_t bytes, Progress& progress);
  std::vector<double> balance(Progress& progress) const;
  void note(std::size_t i, const FormFactorRow& row);
  double scale_of(double sum) const;
  // work(row) with a row as it is kept: floats, doubles or entries.
  template <class Work>
  auto with_row(std::size_t i, const Work& work) const;
  double stored(std::size_t i, std::size_t j) const;  // F_ij / scale
  // The entry of a sparse row; null: 0.
  const FormFactor* entry(std::size_t i, std::size_t j) const;

  Storage storage_ = Storage::dense;
  std::size_t kept_ = 0;
  std::size_t stride_ = 0;  // dense_stride(); filled up with zeros
  Numbers<float> floats_;
  Numbers<double> doubles_;  // instead of the floats where factors are known
  std::vector<std::vector<FormFactor>> sparse_;
  std::vector<double> area_, scale_, sums_;
  std::vector<RowFigures> figures_;
  bool normalised_ = false;
  FormFactorMethod method_;  // of the rows that are not kept
};

}  // namespace cg
