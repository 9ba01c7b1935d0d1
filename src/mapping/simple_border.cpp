// Sides are sorted into the cells of a grid, and those that share a cell are compared: about linear where sides are
// about equally long.
#include "mapping/simple_border.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace cg {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// On which side of the line from a to b the point lies; 0 within rounding.
int side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  const double v = cross(b - a, p - a);
  const double rounding = 1e-12 * (std::abs((b.x - a.x) * (p.y - a.y)) + std::abs((b.y - a.y) * (p.x - a.x)));
  return v > rounding ? 1 : v < -rounding ? -1 : 0;
}

bool meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  const int c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
  return c_side * d_side <= 0 && a_side * b_side <= 0;
}

// The sides a-b and b-c lie on each other.
bool folds_back(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return side(a, b, c) == 0 && glm::dot(b - a, c - b) <= 0;
}

class Cells {
 public:
  explicit Cells(std::span<const glm::dvec2> p) : p_(p), n_(p.size()) {
    low_ = high_ = p[0];
    for (const glm::dvec2& q : p) low_ = glm::min(low_, q), high_ = glm::max(high_, q);
    double length = 0;
    for (std::size_t i = 0; i < n_; ++i) length += glm::distance(p[i], p[(i + 1) % n_]);
    // Cells as large as a mean side, but not very many.
    const double size = std::max({length / double(n_), (high_.x - low_.x) / 1000, (high_.y - low_.y) / 1000, 1e-300});
    to_cell_ = 1 / size;
    columns_ = cell(high_).x + 1, rows_ = cell(high_).y + 1;
  }

  template <class Visit>  // (cell); false ends it
  bool along(std::size_t i, const Visit& visit) const {
    const glm::dvec2 &a = p_[i], &b = p_[(i + 1) % n_];
    const auto from = cell(glm::min(a, b)), to = cell(glm::max(a, b));
    for (int y = from.y; y <= to.y; ++y) {
      // The part of the side within this row.
      int x0 = from.x, x1 = to.x;
      if (to.y > from.y && to.x > from.x) {
        const double y0 = low_.y + double(y) / to_cell_, y1 = low_.y + double(y + 1) / to_cell_;
        const double t0 = std::clamp((y0 - a.y) / (b.y - a.y), 0.0, 1.0),
                     t1 = std::clamp((y1 - a.y) / (b.y - a.y), 0.0, 1.0);
        const double xa = a.x + t0 * (b.x - a.x), xb = a.x + t1 * (b.x - a.x);
        x0 = std::max(from.x, int((std::min(xa, xb) - low_.x) * to_cell_ - 1e-3));
        x1 = std::min(to.x, int((std::max(xa, xb) - low_.x) * to_cell_ + 1e-3));
      }
      for (int x = x0; x <= x1; ++x)
        if (!visit(std::size_t(y) * std::size_t(columns_) + std::size_t(x))) return false;
    }
    return true;
  }
  std::size_t count() const { return std::size_t(columns_) * std::size_t(rows_); }

 private:
  struct Cell {
    int x, y;
  };
  Cell cell(const glm::dvec2& q) const { return {int((q.x - low_.x) * to_cell_), int((q.y - low_.y) * to_cell_)}; }

  std::span<const glm::dvec2> p_;
  std::size_t n_;
  glm::dvec2 low_, high_;
  double to_cell_ = 1;
  int columns_ = 1, rows_ = 1;
};

}  // namespace

bool is_simple_polygon(std::span<const glm::dvec2> p) {
  const std::size_t n = p.size();
  if (n < 3) return false;
  for (const glm::dvec2& q : p)
    if (!std::isfinite(q.x) || !std::isfinite(q.y)) return false;
  const Cells cells(p);
  std::vector<std::uint32_t> first(cells.count() + 1, 0);
  for (std::size_t i = 0; i < n; ++i) cells.along(i, [&](std::size_t c) { return ++first[c + 1], true; });
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  std::vector<std::uint32_t> sides(first.back()), filled(first.begin(), first.end() - 1);
  const auto meets_earlier = [&](std::size_t i, std::size_t c) {
    for (std::size_t k = first[c]; k < filled[c]; ++k) {
      const std::size_t j = sides[k];  // j < i
      if (j == i) continue;
      const glm::dvec2 &a = p[i], &b = p[(i + 1) % n], &d = p[j], &e = p[(j + 1) % n];
      if (i == j + 1 ? folds_back(d, a, b) : (i + 1) % n == j ? folds_back(a, b, e) : meet(a, b, d, e)) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < n; ++i)
    if (!cells.along(i, [&](std::size_t c) {
          if (meets_earlier(i, c)) return false;
          sides[filled[c]++] = std::uint32_t(i);
          return true;
        }))
      return false;
  return true;
}

}  // namespace cg
