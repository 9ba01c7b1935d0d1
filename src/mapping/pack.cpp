// Each piece becomes a mask of the cells it touches, and goes to the lowest free place in the square, the largest
// first; the scale is found by trials. (Lévy, Petitjean, Ray and Maillot 2002 pack against the charts below; masks also
// fill the holes between them.)
#include "mapping/pack.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "mapping/parallel.h"
#include "math/counter_random.h"

namespace cg {

namespace {

constexpr int cells = 384;  // along the square's side
constexpr int words = cells / 64;
using Row = std::array<std::uint64_t, words>;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Counter-clockwise (Andrew's monotone chain).
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> p) {
  std::sort(p.begin(), p.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const glm::dvec2& q : p) {
      while (hull.size() >= begin + 2 && cross(hull.back() - hull[hull.size() - 2], q - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(q);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  return hull;
}

struct Box {
  glm::dvec2 low{1e300}, high{-1e300};
  void add(const glm::dvec2& p) { low = glm::min(low, p), high = glm::max(high, p); }
  glm::dvec2 size() const { return high - low; }
};

Box box_of(const std::vector<glm::dvec2>& points) {
  Box out;
  for (const glm::dvec2& p : points) out.add(p);
  return out;
}

// The cells that a piece touches, width x height, in one of four positions: turned by 90 degrees each.
struct Mask {
  int width = 0, height = 0;
  std::vector<Row> rows;
  bool at(int x, int y) const { return rows[std::size_t(y)][std::size_t(x / 64)] >> (x % 64) & 1; }
  void set(int x, int y) { rows[std::size_t(y)][std::size_t(x / 64)] |= std::uint64_t(1) << (x % 64); }
};

// Whether the triangle comes nearer than `reach` to the centre of the cell, in the largest of the coordinates along
// its sides' normals and the axes.
bool touches(const std::array<glm::dvec2, 3>& t, const glm::dvec2& centre, double reach) {
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 side = t[(k + 1) % 3] - t[k], normal{-side.y, side.x};
    const double here = glm::dot(normal, centre - t[k]), other = glm::dot(normal, t[(k + 2) % 3] - t[k]);
    const double most = reach * (std::abs(normal.x) + std::abs(normal.y));
    if (here > std::max(other, 0.0) + most || here < std::min(other, 0.0) - most) return false;
  }
  return true;
}

// `scale`: cells a unit; `reach`: half the margin in cells. Nothing where it is larger than the square.
Mask mask_of(const FlatPiece& piece, const Box& box, double scale, double reach) {
  Mask out;
  const glm::dvec2 size = box.size() * scale;
  if (!(size.x + 2 * reach <= cells && size.y + 2 * reach <= cells)) return out;
  out.width = std::max(1, int(std::ceil(size.x + 2 * reach))),
  out.height = std::max(1, int(std::ceil(size.y + 2 * reach)));
  out.rows.assign(std::size_t(out.height), Row{});
  for (const auto& triangle : piece.triangle) {
    std::array<glm::dvec2, 3> t;
    Box b;
    for (int k = 0; k < 3; ++k) t[k] = (piece.flat[triangle[k]] - box.low) * scale + reach, b.add(t[k]);
    const int x0 = std::max(0, int(b.low.x - reach)), x1 = std::min(out.width - 1, int(b.high.x + reach));
    const int y0 = std::max(0, int(b.low.y - reach)), y1 = std::min(out.height - 1, int(b.high.y + reach));
    const bool small = x1 - x0 <= 1 && y1 - y0 <= 1;
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        if (!out.at(x, y) && (small || touches(t, {x + 0.5, y + 0.5}, 0.5 + reach))) out.set(x, y);
  }
  return out;
}

Mask turned(const Mask& m) {
  Mask out{m.height, m.width, std::vector<Row>(std::size_t(m.width), Row{})};
  for (int y = 0; y < m.height; ++y)
    for (int x = 0; x < m.width; ++x)
      if (m.at(x, y)) out.set(y, m.width - 1 - x);
  return out;
}

// row moved n cells towards 0.
Row moved(const Row& row, int n) {
  Row out{};
  const int w = n / 64, b = n % 64;
  for (int k = 0; k + w < words; ++k) {
    out[k] = row[k + w] >> b;
    if (b > 0 && k + w + 1 < words) out[k] |= row[k + w + 1] << (64 - b);
  }
  return out;
}

struct Run {
  int begin, length;
};

std::vector<std::vector<Run>> runs_of(const Mask& m) {
  std::vector<std::vector<Run>> out(std::size_t(m.height));
  for (int y = 0; y < m.height; ++y)
    for (int x = 0; x < m.width; ++x) {
      if (!m.at(x, y)) continue;
      if (x > 0 && m.at(x - 1, y))
        ++out[std::size_t(y)].back().length;
      else
        out[std::size_t(y)].push_back({x, 1});
    }
  return out;
}

struct Place {
  int x = -1, y = cells;
};

class Square {
 public:
  // The lowest free place, of those the leftmost; x = -1 where there is none below `top`.
  Place lowest(const Mask& m, int top) const {
    const auto runs = runs_of(m);
    for (int y = 0; y + m.height <= std::min(cells, top); ++y) {
      Row blocked{};
      for (int x = cells - m.width + 1; x < cells; ++x) blocked[std::size_t(x / 64)] |= std::uint64_t(1) << (x % 64);
      for (int r = 0; r < m.height; ++r) {
        add_blocked(rows_[std::size_t(y + r)], runs[std::size_t(r)], blocked);
        if (std::all_of(blocked.begin(), blocked.end(), [](std::uint64_t w) { return w == ~std::uint64_t(0); })) break;
      }
      for (int x = 0; x < cells; ++x)
        if (!(blocked[std::size_t(x / 64)] >> (x % 64) & 1)) return {x, y};
    }
    return {};
  }

  void take(const Mask& m, const Place& p) {
    for (int y = 0; y < m.height; ++y)
      for (int x = 0; x < m.width; ++x)
        if (m.at(x, y))
          rows_[std::size_t(p.y + y)][std::size_t((p.x + x) / 64)] |= std::uint64_t(1) << ((p.x + x) % 64);
  }

 private:
  // A run of n cells does not fit at x where any of x .. x + n - 1 (after its beginning) is taken.
  static void add_blocked(const Row& taken, const std::vector<Run>& runs, Row& blocked) {
    if (std::all_of(taken.begin(), taken.end(), [](std::uint64_t w) { return w == 0; })) return;
    for (const Run& run : runs) {
      Row any = moved(taken, run.begin);
      for (int reach = 1; reach < run.length;) {  // `any` tells of `reach` cells
        const int step = std::min(reach, run.length - reach);
        const Row further = moved(any, step);
        for (int k = 0; k < words; ++k) any[k] |= further[k];
        reach += step;
      }
      for (int k = 0; k < words; ++k) blocked[k] |= any[k];
    }
  }

  std::array<Row, cells> rows_{};
};

struct Placed {
  int turns = 0;
  Place place;
  int width = 0, height = 0;  // of the mask before it was turned
};

// One after the other to the lowest place, turned so that its upper end is lowest; nothing where one has no place.
std::vector<Placed> place_in_order(const std::vector<std::array<Mask, 4>>& masks,
                                   const std::vector<std::size_t>& order) {
  Square square;
  std::vector<Placed> out(masks.size());
  for (const std::size_t i : order) {
    out[i].width = masks[i][0].width, out[i].height = masks[i][0].height;
    int top = cells + 1;
    for (int k = 0; k < 4; ++k) {
      const Mask& m = masks[i][std::size_t(k)];
      const Place p = square.lowest(m, top - 1);
      if (p.x < 0) continue;
      top = p.y + m.height;
      out[i].turns = k, out[i].place = p;
    }
    if (top > cells) return {};
    square.take(masks[i][std::size_t(out[i].turns)], out[i].place);
  }
  return out;
}

constexpr std::size_t orders = 12;

// The longest, the widest or the largest first; then the same with each piece's size taken up to 30 % for more or less.
std::vector<std::size_t> order_of(const std::vector<std::array<Mask, 4>>& masks, std::size_t way) {
  std::vector<double> key(masks.size());
  for (std::size_t i = 0; i < masks.size(); ++i) {
    const double w = masks[i][0].width, h = masks[i][0].height;
    key[i] = way % 3 == 0 ? std::max(w, h) : way % 3 == 1 ? w + h : std::sqrt(w * h);
    if (way >= 3) key[i] *= 0.7 + 0.6 * random_number(way, i);
  }
  std::vector<std::size_t> order(masks.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] > key[b]; });
  return order;
}

// All pieces at that scale, in the first of so many orders that works.
std::vector<Placed> try_scale(const std::vector<FlatPiece>& pieces, const std::vector<Box>& boxes, double scale,
                              double reach, std::size_t most_orders) {
  std::vector<std::array<Mask, 4>> masks(pieces.size());
  in_parallel(pieces.size(), [&](std::size_t i) {
    masks[i][0] = mask_of(pieces[i], boxes[i], scale, reach);
    for (std::size_t k = 1; k < 4; ++k) masks[i][k] = turned(masks[i][k - 1]);
  });
  for (const auto& m : masks)
    if (m[0].rows.empty()) return {};
  std::array<std::vector<Placed>, orders> placed;
  in_parallel(pieces.size() > 1 ? most_orders : 1,
              [&](std::size_t way) { placed[way] = place_in_order(masks, order_of(masks, way)); });
  for (auto& p : placed)
    if (!p.empty()) return std::move(p);
  return {};
}

void move_to(FlatPiece& piece, const Box& box, const Placed& placed, double scale, double reach) {
  for (glm::dvec2& p : piece.flat) {
    glm::dvec2 q = (p - box.low) * scale + reach;
    double width = placed.width, height = placed.height;
    for (int k = 0; k < placed.turns; ++k) {
      q = {q.y, width - q.x};
      std::swap(width, height);
    }
    p = (q + glm::dvec2(placed.place.x, placed.place.y)) / double(cells);
  }
}

}  // namespace

void turn_to_smallest_box(std::vector<glm::dvec2>& points) {
  const std::vector<glm::dvec2> hull = convex_hull(points);
  double best = 1e300;
  glm::dvec2 along{1, 0};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const double length = std::hypot(side.x, side.y);
    if (!(length > 0)) continue;
    const glm::dvec2 x = side / length;
    Box box;
    for (const glm::dvec2& p : hull) box.add({glm::dot(x, p), cross(x, p)});
    if (const double area = box.size().x * box.size().y; area < best * (1 - 1e-9)) best = area, along = x;
  }
  for (glm::dvec2& p : points) p = {glm::dot(along, p), cross(along, p)};
}

void pack(std::vector<FlatPiece>& pieces, double margin) {
  std::vector<Box> boxes;
  double area = 0, longest = 0;
  for (FlatPiece& piece : pieces) {
    turn_to_smallest_box(piece.flat);
    boxes.push_back(box_of(piece.flat));
    for (const auto& [a, b, c] : piece.triangle)
      area += 0.5 * std::abs(cross(piece.flat[b] - piece.flat[a], piece.flat[c] - piece.flat[a]));
    longest = std::max({longest, boxes.back().size().x, boxes.back().size().y});
  }
  if (pieces.empty()) return;
  double reach = 0.5 * margin * cells;
  double scale = cells * std::min(std::sqrt(1 / std::max(area, 1e-300)), 1 / std::max(longest, 1e-300));
  std::vector<Placed> placed;
  for (int trial = 1; placed.empty(); ++trial) {
    placed = try_scale(pieces, boxes, scale, reach, 1);
    if (!placed.empty()) break;
    scale *= 0.94;
    if (trial % 16 == 0) reach *= 0.5;
  }
  double too_large = scale * 1.15;
  for (int trial = 0; trial < 4; ++trial) {
    const double between = 0.5 * (scale + too_large);
    std::vector<Placed> next = try_scale(pieces, boxes, between, reach, orders);
    if (next.empty())
      too_large = between;
    else
      scale = between, placed = std::move(next);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) move_to(pieces[i], boxes[i], placed[i], scale, reach);
}

}  // namespace cg
