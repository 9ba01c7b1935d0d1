#include "scene/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

namespace cg {

double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 u = b - a, v = c - a;
  const double left = u.x * v.y, right = u.y * v.x;
  const double difference = left - right;
  if (std::abs(difference) > 1e-15 * (std::abs(left) + std::abs(right))) return difference;
  return std::fma(u.x, v.y, -right) + std::fma(-u.y, v.x, right);
}

namespace {

using Index = std::uint32_t;

struct Ear {
  glm::dvec2 a, b, c;
  bool boundary_counts;  // do points on the boundary lie inside?

  bool contains(const glm::dvec2& p) const {
    if (p == a || p == b || p == c) return false;
    const double ab = orientation(a, b, p), bc = orientation(b, c, p), ca = orientation(c, a, p);
    return boundary_counts ? ab >= 0 && bc >= 0 && ca >= 0 : ab > 0 && bc > 0 && ca > 0;
  }
  // Whether the box lies outside one edge's line, so that no point of it can be inside.
  bool misses(const glm::dvec2& low, const glm::dvec2& high) const {
    if (std::max({a.x, b.x, c.x}) < low.x || std::min({a.x, b.x, c.x}) > high.x) return true;
    if (std::max({a.y, b.y, c.y}) < low.y || std::min({a.y, b.y, c.y}) > high.y) return true;
    return outside(a, b, low, high) || outside(b, c, low, high) || outside(c, a, low, high);
  }

 private:
  static bool outside(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec2 inwards{p.y - q.y, q.x - p.x};
    const glm::dvec2 nearest{inwards.x > 0 ? high.x : low.x, inwards.y > 0 ? high.y : low.y};
    return orientation(p, q, nearest) < 0;
  }
};

// A balanced k-d tree over some of the polygon's corners, from which corners can be taken. The node of a range
// of order_ is its middle.
class PointTree {
 public:
  PointTree(std::span<const glm::dvec2> points, std::vector<Index> members)
      : points_(points), order_(std::move(members)), nodes_(order_.size()), place_(points.size(), no_place) {
    build(0, order_.size(), 0);
    for (std::size_t i = 0; i < order_.size(); ++i) place_[order_[i]] = Index(i);
  }

  void remove(Index point) {
    const Index place = place_[point];
    if (place == no_place) return;
    place_[point] = no_place;
    for (std::size_t begin = 0, end = order_.size();;) {
      const std::size_t middle = (begin + end) / 2;
      --nodes_[middle].alive;
      if (place == middle) return;
      place < middle ? end = middle : begin = middle + 1;
    }
  }

  bool any_inside(const Ear& ear) const { return any_inside(ear, 0, order_.size()); }

 private:
  static constexpr Index no_place = 0xffffffffu;
  struct Node {
    glm::dvec2 low, high;  // of the whole range
    Index alive;           // members of the range that were not removed
  };

  void build(std::size_t begin, std::size_t end, int axis) {
    if (begin == end) return;
    const std::size_t middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](Index i, Index j) { return points_[i][axis] < points_[j][axis]; });
    Node& node = nodes_[middle];
    node = {points_[order_[begin]], points_[order_[begin]], Index(end - begin)};
    for (std::size_t i = begin; i < end; ++i) {
      const glm::dvec2& p = points_[order_[i]];
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
    }
    build(begin, middle, 1 - axis);
    build(middle + 1, end, 1 - axis);
  }

  bool any_inside(const Ear& ear, std::size_t begin, std::size_t end) const {
    if (begin == end) return false;
    const std::size_t middle = (begin + end) / 2;
    const Node& node = nodes_[middle];
    if (node.alive == 0 || ear.misses(node.low, node.high)) return false;
    const Index point = order_[middle];
    return (place_[point] != no_place && ear.contains(points_[point])) || any_inside(ear, begin, middle) ||
           any_inside(ear, middle + 1, end);
  }

  std::span<const glm::dvec2> points_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
  std::vector<Index> place_;  // in order_, of a corner that is a member
};

// What is accepted as an ear. A simple polygon needs only the first; the others let a polygon end whose edges
// cross or touch. `flat` takes corners without area away and makes no triangle of them.
enum class Accept { proper, touching, convex, flat };

class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec2> points)
      : points_(points), next_(points.size()), previous_(points.size()), left_(points.size()) {
    const Index n = Index(points.size());
    for (Index i = 0; i < n; ++i) next_[i] = (i + 1) % n, previous_[i] = (i + n - 1) % n;
    std::vector<Index> reflex;
    for (Index i = 0; i < n; ++i)
      if (turn(i) <= 0) reflex.push_back(i);
    reflex_.emplace(points_, std::move(reflex));
  }

  void run(std::vector<std::array<Index, 3>>& triangles) {
    for (const Accept accept : {Accept::proper, Accept::touching, Accept::convex, Accept::flat, Accept::convex}) {
      std::queue<Index> candidates;
      const Index start = some_left_;
      Index i = start;
      do candidates.push(i), i = next_[i];
      while (i != start);
      // Clipping an ear changes what its two neighbours are and, of a simple polygon, no other corner.
      while (left_ > 2 && !candidates.empty()) {
        const Index corner = candidates.front();
        candidates.pop();
        if (next_[corner] == corner || !is_ear(corner, accept)) continue;
        const Index before = previous_[corner], after = next_[corner];
        if (accept != Accept::flat) triangles.push_back({before, corner, after});
        take_out(corner);
        candidates.push(before), candidates.push(after);
      }
      if (left_ <= 2) return;
    }
  }

 private:
  double turn(Index i) const { return orientation(points_[previous_[i]], points_[i], points_[next_[i]]); }

  bool is_ear(Index i, Accept accept) const {
    const double area = turn(i);
    if (accept == Accept::flat) return area == 0;
    if (!(area > 0)) return false;
    if (accept == Accept::convex) return true;
    return !reflex_->any_inside({points_[previous_[i]], points_[i], points_[next_[i]], accept == Accept::proper});
  }

  void take_out(Index i) {
    const Index before = previous_[i], after = next_[i];
    next_[before] = after, previous_[after] = before;
    next_[i] = i;  // marks it as gone
    some_left_ = before;
    --left_;
    reflex_->remove(i);
    for (const Index neighbour : {before, after})
      if (turn(neighbour) > 0) reflex_->remove(neighbour);
  }

  std::span<const glm::dvec2> points_;
  std::vector<Index> next_, previous_;
  std::size_t left_;
  Index some_left_ = 0;
  std::optional<PointTree> reflex_;
};

}  // namespace

void clip_ears(std::span<const glm::dvec2> polygon, std::vector<std::array<Index, 3>>& triangles) {
  if (polygon.size() >= 3) EarClipper(polygon).run(triangles);
}

}  // namespace cg
