// The cube and the plane, and the sphere that begins as an icosahedron.
#include <algorithm>
#include <array>
#include <cmath>

#include "math/transform.h"
#include "scene/shape_builder.h"
#include "scene/shape_makers.h"

namespace cg {

namespace {

// The square centre + (2u - 1) right + (2v - 1) up, cut into n x n.
void square(ShapeBuilder& builder, int n, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up,
            const glm::dvec3& normal) {
  builder.grid(n, n, [&](int row, int column) -> ShapeCorner {
    const double u = double(2 * column - n) / n, v = double(2 * row - n) / n;
    return {centre + u * right + v * up, normal, {double(column) / n, double(row) / n}};
  });
}

// Longitude and latitude. Across the seam and at the poles, u follows the face's first other corner.
void add_sphere_triangle(ShapeBuilder& builder, const std::array<glm::dvec3, 3>& p) {
  std::array<ShapeCorner, 3> face;
  for (int i = 0; i < 3; ++i) {
    const double u = std::atan2(-p[i].z, p[i].x) / (2 * pi);
    face[i] = {p[i], p[i], {u < 0 ? u + 1 : u, std::acos(std::min(1.0, std::max(-1.0, -p[i].y))) / pi}};
  }
  const auto at_pole = [&](int i) { return p[i].x == 0 && p[i].z == 0; };
  const double largest = std::max({face[0].uv.x, face[1].uv.x, face[2].uv.x});
  for (int i = 0; i < 3; ++i)
    if (!at_pole(i) && largest - face[i].uv.x > 0.5) face[i].uv.x += 1;
  for (int i = 0; i < 3; ++i)
    if (at_pole(i)) face[i].uv.x = 0.5 * (face[(i + 1) % 3].uv.x + face[(i + 2) % 3].uv.x);
  builder.face(std::array{builder.corner(face[0]), builder.corner(face[1]), builder.corner(face[2])});
}

void subdivide(ShapeBuilder& builder, const std::array<glm::dvec3, 3>& p, int level) {
  if (level == 0) return add_sphere_triangle(builder, p);
  const std::array<glm::dvec3, 3> middle{unit(p[0] + p[1]), unit(p[1] + p[2]), unit(p[2] + p[0])};
  subdivide(builder, {p[0], middle[0], middle[2]}, level - 1);
  subdivide(builder, {middle[0], p[1], middle[1]}, level - 1);
  subdivide(builder, {middle[2], middle[1], p[2]}, level - 1);
  subdivide(builder, middle, level - 1);
}

}  // namespace

MeshData make_cube(int n) {
  const double h = 1 / std::sqrt(3.0);
  ShapeBuilder builder;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 normal(0), right(0), up(0);
      normal[axis] = side;
      // Right, up and normal are right-handed; up is y on the four sides that stand.
      (axis == 1 ? up.z : up.y) = axis == 1 ? -side * h : h;
      right = glm::cross(up, normal);
      square(builder, n, h * normal, right, up, normal);
    }
  return builder.take();
}

MeshData make_plane(int n) {
  const double h = std::sqrt(0.5);
  ShapeBuilder builder;
  square(builder, n, {0, 0, 0}, {h, 0, 0}, {0, 0, -h}, {0, 1, 0});
  return builder.take();
}

MeshData make_icosphere(int level) {
  // An icosahedron's corners are those of three golden rectangles.
  const double phi = (1 + std::sqrt(5.0)) / 2;
  std::array<glm::dvec3, 12> corner;
  for (int i = 0; i < 12; ++i) {
    const double a = i & 1 ? 1 : -1, b = i & 2 ? phi : -phi;
    const int axis = i / 4;
    corner[i][axis] = 0, corner[i][(axis + 1) % 3] = a, corner[i][(axis + 2) % 3] = b;
    corner[i] = unit(corner[i]);
  }
  // Its faces join corners one edge apart.
  const double edge = 2 / std::sqrt(phi * phi + 1);
  const auto joined = [&](int i, int j) { return std::abs(glm::distance(corner[i], corner[j]) - edge) < 1e-9; };
  ShapeBuilder builder;
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      for (int k = j + 1; k < 12; ++k)
        if (joined(i, j) && joined(j, k) && joined(k, i)) {
          const bool outward = glm::dot(glm::cross(corner[j] - corner[i], corner[k] - corner[i]), corner[i]) > 0;
          subdivide(builder, {corner[i], corner[outward ? j : k], corner[outward ? k : j]}, level);
        }
  return builder.take();
}

}  // namespace cg
