// Shapes of revolution and their relatives, from their parametric forms: u goes around to the right seen from
// outside, v upwards or around the tube.
#include <algorithm>

#include "math/transform.h"
#include "scene/shape_builder.h"
#include "scene/shape_makers.h"

namespace cg {

namespace {

// Around the y axis, counter-clockwise seen from above.
glm::dvec3 around_y(const Turn& t, double radius, double y) { return {radius * t.cosine, y, -radius * t.sine}; }

// A disc at the height y, seen from above or from below, in rings of quads.
void disc(ShapeBuilder& builder, int slices, int rings, double radius, double y, bool up) {
  builder.grid(rings, slices, [&](int row, int column) -> ShapeCorner {
    const double r = double(up ? rings - row : row) / rings;
    const Turn t = turn(column, slices);
    return {around_y(t, radius * r, y), {0, up ? 1 : -1, 0}, {0.5 + 0.5 * r * t.cosine, 0.5 + 0.5 * r * t.sine}};
  });
}

int rows_of(int slices) { return std::max(1, slices / 4); }

}  // namespace

MeshData make_uv_sphere(int slices) {
  const int stacks = std::max(2, slices / 2);
  ShapeBuilder builder;
  builder.grid(stacks, slices, [&](int row, int column) -> ShapeCorner {
    const Turn latitude = turn(row, 2 * stacks);
    const glm::dvec3 p = around_y(turn(column, slices), latitude.sine, -latitude.cosine);
    return {p, p, {double(column) / slices, double(row) / stacks}};
  });
  return builder.take();
}

MeshData make_torus(int around) {
  const int tube = std::max(3, around / 2);
  const double R = 0.7, r = 0.3;
  ShapeBuilder builder;
  builder.grid(tube, around, [&](int row, int column) -> ShapeCorner {
    const Turn theta = turn(column, around), phi = turn(row, tube);
    const glm::dvec3 n{phi.cosine * theta.cosine, phi.cosine * theta.sine, phi.sine};
    return {R * glm::dvec3(theta.cosine, theta.sine, 0) + r * n, n, {double(column) / around, double(row) / tube}};
  });
  return builder.take();
}

// The tube around the (2, 3) torus knot C(t) = ((R + a cos 3t) cos 2t, (R + a cos 3t) sin 2t, a sin 3t). The normal
// of the torus on which the knot runs is at right angles to its tangent: the two carry the tube's circle, and a
// tube's normal is the direction from the curve.
MeshData make_torus_knot(int tube) {
  const int along = 10 * tube;
  const double R = 2, a = 1, tube_radius = 0.45;
  ShapeBuilder builder;
  builder.grid(tube, along, [&](int row, int column) -> ShapeCorner {
    const Turn p = turn(2 * column, along), q = turn(3 * column, along), phi = turn(row, tube);
    const double rho = R + a * q.cosine, rho_prime = -3 * a * q.sine;
    const glm::dvec3 centre{rho * p.cosine, rho * p.sine, a * q.sine};
    const glm::dvec3 tangent = unit(
        glm::dvec3(rho_prime * p.cosine - 2 * rho * p.sine, rho_prime * p.sine + 2 * rho * p.cosine, 3 * a * q.cosine));
    const glm::dvec3 normal{q.cosine * p.cosine, q.cosine * p.sine, q.sine};
    const glm::dvec3 n = phi.cosine * normal + phi.sine * glm::cross(normal, tangent);
    return {centre + tube_radius * n, unit(n), {double(column) / along, double(row) / tube}};
  });
  builder.fit();
  return builder.take();
}

MeshData make_cylinder(int slices) {
  const double radius = 0.6, half_height = 0.8;
  const int rows = rows_of(slices), rings = std::max(1, slices / 16);
  ShapeBuilder builder;
  builder.grid(rows, slices, [&](int row, int column) -> ShapeCorner {
    const Turn t = turn(column, slices);
    const double v = double(row) / rows;
    return {around_y(t, radius, half_height * (2 * v - 1)), around_y(t, 1, 0), {double(column) / slices, v}};
  });
  disc(builder, slices, rings, radius, half_height, true);
  disc(builder, slices, rings, radius, -half_height, false);
  return builder.take();
}

// At the apex there is no normal: each triangle there has the one of the line in its middle.
MeshData make_cone(int slices) {
  const double radius = 0.6, half_height = 0.8;
  const glm::dvec2 slope = glm::dvec2(2 * half_height, radius) / std::hypot(2 * half_height, radius);
  const int rows = rows_of(slices), rings = std::max(1, slices / 16);
  const auto corner = [&](int row, int half_column) -> ShapeCorner {
    const Turn t = turn(half_column, 2 * slices);
    const double v = double(row) / rows;
    return {around_y(t, radius * double(rows - row) / rows, half_height * (2 * v - 1)),
            around_y(t, slope.x, slope.y),
            {0.5 * half_column / slices, v}};
  };
  ShapeBuilder builder;
  builder.grid(rows - 1, slices, [&](int row, int column) { return corner(row, 2 * column); });
  for (int c = 0; c < slices; ++c)
    builder.face(std::array{builder.corner(corner(rows - 1, 2 * c)), builder.corner(corner(rows - 1, 2 * c + 2)),
                            builder.corner(corner(rows, 2 * c + 1))});
  disc(builder, slices, rings, radius, -half_height, false);
  return builder.take();
}

}  // namespace cg
