// Vertices of elements by number: made between others so that neighbours get the same bits, and found again.
#pragma once
#include <vector>

#include "radiosity/patches.h"
#include "scene/numbering.h"

namespace cg {

// The vertex i/n of the way from a to b. The same bits as that at (n - i)/n from b to a: faces on both sides of an edge
// make the same vertices.
inline ElementVertex between(const ElementVertex& a, const ElementVertex& b, long i, long n) {
  if (i == 0) return a;
  if (i == n) return b;
  const auto before = [](const glm::dvec3& p, const glm::dvec3& q) {
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  if (before(b.local, a.local)) return between(b, a, n - i, n);
  const double t = double(i) / double(n);
  return {a.position + t * (b.position - a.position), a.local + t * (b.local - a.local),
          a.normal + t * (b.normal - a.normal), a.surface};
}

// Numbers the vertices of a list: those of one surface at one place are one.
class VertexNumbers {
 public:
  explicit VertexNumbers(std::vector<ElementVertex>& vertices) : vertices_(vertices), number_(vertices.size()) {
    for (const ElementVertex& v : vertices_) number_(BitsAndIndex(v.local, v.surface));
  }
  std::uint32_t operator()(const ElementVertex& v) {
    const std::uint32_t i = number_(BitsAndIndex(v.local, v.surface));
    if (i == vertices_.size()) vertices_.push_back(v);
    return i;
  }

 private:
  std::vector<ElementVertex>& vertices_;
  Numbering number_;
};

}  // namespace cg
