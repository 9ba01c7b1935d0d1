// How far rows are from summing to 1, and from A_i F_ij = A_j F_ji.
#include <cmath>

#include "radiosity/matrix_rows.h"
#include "raster/workers.h"

namespace cg {

namespace {

struct Reciprocity {
  double largest = 0, squares = 0, all = 0;
  void add(double ij, double ji) {  // A_i F_ij and A_j F_ji
    const double off = ij - ji, mean = 0.5 * (ij + ji);
    largest = std::max(largest, std::abs(off));
    squares += off * off;
    all += mean * mean;
  }
  void add(const Reciprocity& r) {
    largest = std::max(largest, r.largest);
    squares += r.squares;
    all += r.all;
  }
};

}  // namespace

MatrixFigures FormFactorMatrix::figures(int threads, Progress& progress) const {
  MatrixFigures out;
  out.rows = kept_;
  if (kept_ == 0) return out;
  out.least_sum = out.greatest_sum = figures_[0].sum;
  double sum = 0;
  for (std::size_t i = 0; i < kept_; ++i) {
    out.least_sum = std::min(out.least_sum, double(figures_[i].sum));
    out.greatest_sum = std::max(out.greatest_sum, double(figures_[i].sum));
    sum += figures_[i].sum;
    out.missed += figures_[i].missed;
  }
  out.mean_sum = sum / double(kept_);

  // Pairs i > j by tiles, so that the columns' numbers are still in the cache for the next row.
  constexpr std::size_t tile = 64;
  const int tiles = part_count(kept_, tile);
  std::vector<Reciprocity> by_tile(std::size_t(tiles), Reciprocity{});
  const auto pairs_of_tile = [&](int t) {
    const Part rows = part_of(kept_, tile, t);
    Reciprocity& r = by_tile[std::size_t(t)];
    for (std::size_t j0 = 0; j0 < rows.end; j0 += tile) {
      if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
      for (std::size_t i = rows.begin; i < rows.end; ++i)
        for (std::size_t j = j0; j < std::min(j0 + tile, i); ++j) r.add(area_[i] * at(i, j), area_[j] * at(j, i));
    }
  };
  const auto entries_of_tile = [&](int t) {
    const Part rows = part_of(kept_, tile, t);
    for (std::size_t i = rows.begin; i < rows.end; ++i)
      visit(i, [&](std::size_t j, double f) {
        const double back = j < kept_ ? at(j, i) : 0;
        if (j < kept_ && (j < i || back == 0)) by_tile[std::size_t(t)].add(area_[i] * f, area_[j] * back);
      });
  };
  Workers workers(threads, progress);
  if (storage_ == Storage::dense)
    workers.for_each(tiles, pairs_of_tile);
  else
    workers.for_each(tiles, entries_of_tile);
  Reciprocity all;
  for (const Reciprocity& r : by_tile) all.add(r);
  out.reciprocity_error = all.largest;
  out.reciprocity_relative = all.all > 0 ? std::sqrt(all.squares / all.all) : 0;
  return out;
}

}  // namespace cg
