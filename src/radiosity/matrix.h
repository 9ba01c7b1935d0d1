// The matrix of form factors: rows dense, sparse, or computed again whenever they are asked for, as a plan decides from
// their number, how full they are and the memory that is allowed.
#pragma once
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

// Rows of F. F_ij is the float that is kept times the row's scale, in double: a row that was normalised sums to 1 to
// the last digits whatever floats round.
class FormFactorMatrix {
 public:
  // Computes the rows that the plan keeps, by `threads` threads; nothing but the time depends on their number. `area`
  // is the patches', m^2. `normalised`: the method's rows sum to 1 but for the rounding of floats. Where not all rows
  // are kept, what the method refers to must outlive the matrix. Throws Cancelled.
  static std::shared_ptr<const FormFactorMatrix> make(const MatrixPlan& plan, FormFactorMethod method,
                                                      std::vector<double> area, bool normalised, int threads,
                                                      Progress& progress);
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
  // sum_j F_ij as times() adds it up, of a kept row.
  double row_sum(std::size_t i) const;
  double scale(std::size_t i) const { return scale_[i]; }

  // sum_j F_ij x_j of a kept row: the same bits on every call.
  glm::dvec3 times(std::size_t i, const Channels& x) const;
  // y_j += F_ij x factor_j for every j, of a kept row.
  void add_row(std::size_t i, const glm::dvec3& x, const Channels& factor, Channels& y) const;
  // F_ij of a kept row.
  double at(std::size_t i, std::size_t j) const;
  // Any row, its factors multiplied by the scale: computed where it is not kept. Throws Cancelled.
  FormFactorRow row(std::size_t i, const Progress& progress) const;

  // What is kept, transposed and without scales: at(i, j) of it times scale(j) is F_ji. All rows must be kept.
  std::shared_ptr<const FormFactorMatrix> transposed() const;

  MatrixFigures figures(int threads, Progress& progress) const;

 private:
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  // Rows of `stride_` numbers, each aligned to 64 bytes and filled up with zeros.
  template <class Real>
  struct Dense {
    std::unique_ptr<Real[], Free> numbers;
    void allocate(std::size_t count);
  };

  FormFactorMatrix() = default;
  void allocate(Storage storage, std::size_t rows);
  void keep(std::size_t i, FormFactorRow&& row);
  template <class Visit>
  void visit(std::size_t i, const Visit& visit) const;  // (j, number without scale)
  void add_reciprocity(std::size_t i, double& largest, double& squares, double& all) const;

  Storage storage_ = Storage::dense;
  bool doubles_ = false;
  std::size_t kept_ = 0, stride_ = 0;
  Dense<float> floats_;
  Dense<double> exact_;
  std::vector<std::vector<FormFactor>> sparse_;
  std::vector<double> area_, scale_;
  std::vector<RowFigures> figures_;
  bool normalised_ = false;
  FormFactorMethod method_;  // of the rows that are not kept
};

// Of a row that FormFactorMatrix::row() gave.
glm::dvec3 times(const FormFactorRow& row, const Channels& x);
void add_row(const FormFactorRow& row, const glm::dvec3& x, const Channels& factor, Channels& y);

}  // namespace cg
