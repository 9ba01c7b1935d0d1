// Builds a mesh corner by corner and finds by itself which corners share a position, a normal or a uv.
#pragma once
#include <span>

#include "scene/mesh.h"
#include "scene/numbering.h"

namespace cg {

struct ShapeCorner {
  glm::dvec3 position, normal;
  glm::dvec2 uv;
};

class ShapeBuilder {
 public:
  Corner corner(const ShapeCorner& c);

  // A face, counter-clockwise. Neighbouring corners at the same position become one (the triangles at a pole).
  void face(std::span<const Corner> corners);

  // rows x columns quads over the corners at(row, column), 0..rows, 0..columns. The quads are counter-clockwise
  // seen from the side to which d(position)/d(column) x d(position)/d(row) points.
  template <class At>
  void grid(int rows, int columns, const At& at);

  // Corners from now on share no position with those before: another part that merely touches.
  void begin_part() { part_ = std::uint32_t(data_.positions.size()); }

  // Moves the centre of the box to the origin and scales so that the farthest corner is at distance 1.
  void fit();

  MeshData take() { return std::move(data_); }

 private:
  MeshData data_;
  std::uint32_t part_ = 0;
  Numbering positions_{64}, normals_{64}, uvs_{64};
};

struct Turn {
  double cosine, sine;
};

// Of 2 pi i/n, with the symmetries of the circle kept to the last bit: turn(i + n, n) is turn(i, n), quarter turns are
// exact, and mirrored angles have mirrored values.
Turn turn(long i, long n);

template <class At>
void ShapeBuilder::grid(int rows, int columns, const At& at) {
  std::vector<Corner> below, above;
  for (int row = 0; row <= rows; ++row) {
    above.clear();
    for (int column = 0; column <= columns; ++column) above.push_back(corner(at(row, column)));
    for (int c = 0; c < columns && row > 0; ++c) face(std::array{below[c], below[c + 1], above[c + 1], above[c]});
    std::swap(below, above);
  }
}

}  // namespace cg
