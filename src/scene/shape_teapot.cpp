// The Utah teapot: 32 bicubic Bezier patches through Martin Newell's control points (The Utilization of Procedure
// Models in Digital Image Synthesis, 1975), 1.3 times lower than the real one as Jim Blinn drew it, with the bottom
// that was added later (Frank Crow, The Origins of the Teapot, 1987). Of the patches, 24 lie on surfaces of revolution,
// four on the handle and four on the spout. All three are loops of patches, so the 306 control points follow from a
// few numbers for each row of a loop.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "math/vec.h"
#include "scene/shape_builder.h"
#include "scene/shape_makers.h"

namespace cg {

namespace {

// One row of a surface of revolution: radius, height, and how far a quarter's inner control points go sideways.
// Newell took 0.56 of the radius (a circle's best is 0.5523), and 0.45 for the knob's 0.8.
struct Ring {
  double r, z, bend;
  constexpr Ring(double radius, double height) : Ring(radius, height, 0.56 * radius) {}
  constexpr Ring(double radius, double height, double b) : r(radius), z(height), bend(b) {}
};

// One row of the handle or the spout: two points in the plane of symmetry and the width to either side of it.
struct Section {
  double x0, z0, x1, z1, width;
};

constexpr std::array<Ring, 13> shell{{{0, 0},  // bottom
                                      {1.425, 0},
                                      {1.5, 0.075},
                                      {1.5, 0.15},  // lower body
                                      {1.5, 0.225},
                                      {2, 0.45},
                                      {2, 0.9},  // upper body
                                      {2, 1.35},
                                      {1.75, 1.875},
                                      {1.5, 2.4},  // rim
                                      {1.4375, 2.53125},
                                      {1.3375, 2.53125},
                                      {1.4, 2.4}}};
constexpr std::array<Ring, 7> lid{
    {{1.3, 2.4}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.7}, {0, 2.85}, {0.8, 3.15, 0.45}, {0, 3.15}}};
constexpr std::array<Section, 7> handle{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                                         {-2.3, 2.025, -2.5, 2.25, 0.3},
                                         {-2.7, 2.025, -3, 2.25, 0.3},
                                         {-2.7, 1.8, -3, 1.8, 0.3},
                                         {-2.7, 1.575, -3, 1.35, 0.3},
                                         {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                         {-2, 0.9, -1.9, 0.6, 0.3}}};
constexpr std::array<Section, 7> spout{{{1.7, 1.425, 1.7, 0.6, 0.66},
                                        {2.6, 1.425, 3.1, 0.825, 0.66},
                                        {2.3, 2.1, 2.4, 2.025, 0.25},
                                        {2.7, 2.4, 3.3, 2.4, 0.25},
                                        {2.8, 2.475, 3.525, 2.49375, 0.25},
                                        {2.9, 2.475, 3.45, 2.5125, 0.15},
                                        {2.8, 2.4, 3.2, 2.4, 0.15}}};

// A row's control points, z up as in the original, counter-clockwise seen against the direction of the rows; the
// first closes the loop.
using Loop = std::vector<glm::dvec3>;

Loop loop_of(const Ring& k) {
  Loop out;
  glm::dvec2 e{1, 0};  // the quarter's first axis; the second is 90 degrees on
  for (int quarter = 0; quarter < 4; ++quarter) {
    const glm::dvec2 f{-e.y, e.x};
    for (const glm::dvec2& p : {k.r * e, k.r * e + k.bend * f, k.bend * e + k.r * f}) out.emplace_back(p, k.z);
    e = f;
  }
  return out;
}

Loop loop_of(const Section& k) {
  return {{k.x0, 0, k.z0}, {k.x0, -k.width, k.z0}, {k.x1, -k.width, k.z1},
          {k.x1, 0, k.z1}, {k.x1, k.width, k.z1},  {k.x0, k.width, k.z0}};
}

struct Jet {
  glm::dvec3 value, derivative;
};

// A Bezier curve by de Casteljau's algorithm. Equal points stay equal to the last bit, and so do the ends.
Jet bezier(std::array<glm::dvec3, 4> p, double t) {
  const auto lerp = [t](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::dvec3(std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.z, b.z, t));
  };
  for (int n = 3; n > 1; --n)
    for (int i = 0; i < n; ++i) p[i] = lerp(p[i], p[i + 1]);
  return {lerp(p[0], p[1]), 3.0 * (p[1] - p[0])};
}

// Position and normal, y up, at patch (row, column) and its (u, v).
ShapeCorner on_patch(const std::vector<Loop>& control, int row, int column, double u, double v) {
  std::array<glm::dvec3, 4> across, along_u;
  for (int i = 0; i < 4; ++i) {
    const Loop& loop = control[3 * row + i];
    std::array<glm::dvec3, 4> p;
    for (int j = 0; j < 4; ++j) p[j] = loop[(3 * column + j) % loop.size()];
    const Jet jet = bezier(p, u);
    across[i] = jet.value, along_u[i] = jet.derivative;
  }
  const Jet jet = bezier(across, v);
  glm::dvec3 n = glm::cross(bezier(along_u, v).value, jet.derivative);
  // At the poles, where a loop shrinks to a point, the surface meets the axis at a right angle.
  if (glm::length(n) < 1e-9) n = {0, 0, jet.value.z > 1 ? 1 : -1};
  return {{jet.value.x, jet.value.z, -jet.value.y}, unit(glm::dvec3(n.x, n.z, -n.y)), {}};
}

template <class Row, std::size_t size>
void add_part(ShapeBuilder& builder, const std::array<Row, size>& profile, int segments) {
  builder.begin_part();  // the handle's lower end touches the body in one point
  std::vector<Loop> control;
  for (const Row& row : profile) control.push_back(loop_of(row));
  const int patch_rows = int(size - 1) / 3, patch_columns = int(control[0].size()) / 3;
  const int rows = patch_rows * segments, columns = patch_columns * segments;
  builder.grid(rows, columns, [&](int row, int column) {
    const int patch_row = std::min(row / segments, patch_rows - 1);
    const int patch_column = column / segments % patch_columns;
    ShapeCorner corner = on_patch(control, patch_row, patch_column, double(column % segments) / segments,
                                  double(row - patch_row * segments) / segments);
    corner.uv = {double(column) / columns, double(row) / rows};
    return corner;
  });
}

}  // namespace

MeshData make_teapot(int segments) {
  ShapeBuilder builder;
  add_part(builder, shell, segments);
  add_part(builder, lid, segments);
  add_part(builder, handle, segments);
  add_part(builder, spout, segments);
  builder.fit();
  return builder.take();
}

}  // namespace cg
