#include <algorithm>
#include <numeric>

#include "radiosity/elements.h"

namespace cg {

namespace {

using Index = std::uint32_t;

// An element's side: from corner `from` of the element to the next.
struct Side {
  Index low, high;  // the ends
  Index element;
  int from;
};

// Sides that no other element has: along them vertices of smaller neighbours may lie.
std::vector<Side> open_sides(const Patches& patches) {
  std::vector<Side> all, open;
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element& element = patches.elements[e];
    for (int i = 0; i < element.corners; ++i) {
      const Index a = element.vertex[std::size_t(i)], b = element.vertex[std::size_t((i + 1) % element.corners)];
      all.push_back({std::min(a, b), std::max(a, b), e, i});
    }
  }
  std::sort(all.begin(), all.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.element < b.element;
  });
  const auto same = [](const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; };
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || !same(all[i - 1], all[i])) && (i + 1 == all.size() || !same(all[i], all[i + 1])))
      open.push_back(all[i]);
  return open;
}

// The vertices at the ends of open sides by surface and then along x, y or z, whichever the surface is longest in.
class OpenVertices {
 public:
  OpenVertices(const Patches& patches, const std::vector<Side>& sides) : patches_(patches) {
    for (const Side& s : sides) list_.push_back(s.low), list_.push_back(s.high);
    std::sort(list_.begin(), list_.end());
    list_.erase(std::unique(list_.begin(), list_.end()), list_.end());
    for (const Index v : list_) grow(patches.vertices[v]);
    std::sort(list_.begin(), list_.end(), [&](Index a, Index b) {
      const Index s = surface(a), t = surface(b);
      if (s != t) return s < t;
      const double x = place(a), y = place(b);
      return x != y ? x < y : a < b;
    });
    for (std::size_t i = 0; i < list_.size(); ++i) {
      Box& box = boxes_[surface(list_[i])];
      if (box.begin == box.end) box.begin = i;
      box.end = i + 1;
    }
  }

  // Calls visit(vertex) for those of the side's surface that may lie on it.
  template <class Visit>
  void along(const Side& side, double margin, const Visit& visit) const {
    const Box& box = boxes_[surface(side.low)];
    const double a = place(side.low), b = place(side.high), low = std::min(a, b) - margin,
                 high = std::max(a, b) + margin;
    const auto end = list_.begin() + std::ptrdiff_t(box.end);
    auto i = std::lower_bound(list_.begin() + std::ptrdiff_t(box.begin), end, low,
                              [&](Index v, double x) { return place(v) < x; });
    for (; i != end && place(*i) <= high; ++i) visit(*i);
  }

 private:
  struct Box {
    glm::dvec3 low{1e300}, high{-1e300};
    std::size_t begin = 0, end = 0;
  };

  Index surface(Index v) const { return patches_.vertices[v].surface; }
  void grow(const ElementVertex& v) {
    if (v.surface >= boxes_.size()) boxes_.resize(v.surface + 1);
    Box& box = boxes_[v.surface];
    box.low = glm::min(box.low, v.position), box.high = glm::max(box.high, v.position);
  }
  double place(Index v) const {
    const Box& box = boxes_[surface(v)];
    const glm::dvec3 d = box.high - box.low;
    const int axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
    return patches_.vertices[v].position[axis];
  }

  const Patches& patches_;
  std::vector<Index> list_;
  std::vector<Box> boxes_;
};

struct OnSide {
  Index element;
  int from;
  double t;  // from corner `from` to the next
  Index vertex;
};

// Files have positions in 24 bits; farther beside an edge than this share of it a vertex is not on it.
constexpr double beside = 1e-6;

std::vector<OnSide> vertices_on_sides(const Patches& patches) {
  const std::vector<Side> sides = open_sides(patches);
  const OpenVertices vertices(patches, sides);
  std::vector<OnSide> out;
  for (const Side& side : sides) {
    const Element& e = patches.elements[side.element];
    const Index a = e.vertex[std::size_t(side.from)], b = e.vertex[std::size_t((side.from + 1) % e.corners)];
    const glm::dvec3 p = patches.vertices[a].position, edge = patches.vertices[b].position - p;
    const double length2 = glm::dot(edge, edge), tolerance = beside * beside * length2;
    vertices.along(side, beside * std::sqrt(length2), [&](Index v) {
      const glm::dvec3 d = patches.vertices[v].position - p;
      const double t = glm::dot(d, edge) / length2;
      const glm::dvec3 off = d - t * edge;
      if (t > beside && t < 1 - beside && glm::dot(off, off) <= tolerance)
        out.push_back({side.element, side.from, t, v});
    });
  }
  std::sort(out.begin(), out.end(), [](const OnSide& a, const OnSide& b) {
    return a.element != b.element ? a.element < b.element : a.from != b.from ? a.from < b.from : a.t < b.t;
  });
  return out;
}

}  // namespace

Outlines outlines_of(const Patches& patches) {
  const std::vector<OnSide> on_sides = vertices_on_sides(patches);
  Outlines out;
  std::vector<double> length;  // of the edge that each vertex hangs in
  auto next = on_sides.begin();
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element& element = patches.elements[e];
    for (int i = 0; i < element.corners; ++i) {
      const Index a = element.vertex[std::size_t(i)], b = element.vertex[std::size_t((i + 1) % element.corners)];
      out.vertex.push_back(a);
      for (; next != on_sides.end() && next->element == e && next->from == i; ++next) {
        out.vertex.push_back(next->vertex);
        out.hanging.push_back({next->vertex, a, b, next->t});
        length.push_back(glm::distance(patches.vertices[a].position, patches.vertices[b].position));
      }
    }
    out.first.push_back(Index(out.vertex.size()));
  }
  std::vector<Index> order(out.hanging.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return length[a] > length[b]; });
  std::vector<HangingVertex> sorted;
  for (const Index i : order) sorted.push_back(out.hanging[i]);
  out.hanging = std::move(sorted);
  return out;
}

std::vector<glm::dvec3> vertex_values(const Patches& patches, const Outlines& outlines,
                                      std::span<const glm::dvec3> element_values) {
  std::vector<glm::dvec3> sum(patches.vertices.size(), glm::dvec3(0));
  std::vector<double> area(patches.vertices.size(), 0);
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element& element = patches.elements[e];
    for (int i = 0; i < element.corners; ++i) {
      const Index v = element.vertex[std::size_t(i)];
      sum[v] += element.area * element_values[e];
      area[v] += element.area;
    }
  }
  for (Index v = 0; v < sum.size(); ++v)
    if (area[v] > 0) sum[v] /= area[v];
  // Longest edges first: the ends of an edge that hang themselves do so in a longer one.
  for (const HangingVertex& h : outlines.hanging) sum[h.vertex] = (1 - h.t) * sum[h.a] + h.t * sum[h.b];
  return sum;
}

}  // namespace cg
