// Convex borders: Tutte, How to Draw a Graph, 1963; Floater, Mean Value Coordinates, 2003. Free borders: the symmetric
// Dirichlet energy and the longest step without a flip of Smith and Schaefer, Bijective Parameterization with Free
// Boundaries, 2015; steps preconditioned by the Laplacian as in Kovalsky, Galun and Lipman, Accelerated Quadratic Proxy
// for Geometric Optimization, 2016.
#include "mapping/flip_free.h"

#include <Eigen/LU>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "math/transform.h"

namespace cg {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;
using Plane = Eigen::MatrixX2d;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The border on a circle of the chart's area, its vertices as far apart as they are along the border.
void lay_on_circle(const ChartMesh& disk, FlatPositions& flat) {
  const std::vector<std::uint32_t>& border = disk.loops.front();
  double area = 0, length = 0, so_far = 0;
  for (const auto& t : disk.triangle)
    area += lay_flat(disk.position[t[0]], disk.position[t[1]], disk.position[t[2]]).area();
  const auto side = [&](std::size_t i) {
    return glm::distance(disk.position[border[i]], disk.position[border[(i + 1) % border.size()]]);
  };
  for (std::size_t i = 0; i < border.size(); ++i) length += side(i);
  const double least = 1e-3 * length / double(border.size());  // different places, also for equal positions
  length += least * double(border.size());
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double angle = 2 * pi * so_far / length;
    flat[border[i]] = std::sqrt(area / pi) * glm::dvec2(std::cos(angle), std::sin(angle));
    so_far += side(i) + least;
  }
}

// Weights w_ij = (tan(alpha/2) + tan(beta/2))/|ij| with the angles at i beside the edge.
Entries mean_value_weights(const ChartMesh& disk) {
  Entries out;
  for (const auto& t : disk.triangle)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3], l = t[(k + 2) % 3];
      const FlatTriangle f = lay_flat(disk.position[i], disk.position[j], disk.position[l]);
      const double to_l = std::hypot(f.x2, f.y2);
      // tan of half the angle: sin/(1 + cos).
      const double tangent = std::min(f.y2 / std::max(to_l + f.x2, 1e-300), 1e6);
      out.emplace_back(int(i), int(j), tangent / f.x1);
      out.emplace_back(int(i), int(l), tangent / to_l);
    }
  return out;
}

// The symmetric Dirichlet energy and its gradient, with the triangles' shapes laid flat once.
class Energy {
 public:
  explicit Energy(const ChartMesh& disk) : disk_(disk) {
    for (const auto& t : disk.triangle)
      shape_.push_back(lay_flat(disk.position[t[0]], disk.position[t[1]], disk.position[t[2]]));
  }

  // Sum of A (|J|² + |J^-1|²); infinite where a triangle is flipped.
  double value(const Plane& x) const {
    double sum = 0;
    for (std::size_t t = 0; t < shape_.size(); ++t) {
      const Eigen::Matrix2d J = jacobian(x, t);
      const double det = J.determinant();
      if (!(det > 0)) return INFINITY;
      sum += shape_[t].area() * J.squaredNorm() * (1 + 1 / (det * det));
    }
    return sum;
  }

  Plane gradient(const Plane& x) const {
    Plane out = Plane::Zero(x.rows(), 2);
    for (std::size_t t = 0; t < shape_.size(); ++t) {
      const FlatTriangle& f = shape_[t];
      const Eigen::Matrix2d J = jacobian(x, t);
      const double det = J.determinant(), norm = J.squaredNorm();
      Eigen::Matrix2d cofactor;
      cofactor << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
      const Eigen::Matrix2d d =
          f.area() * (2 * (1 + 1 / (det * det)) * J - 2 * norm / (det * det * det) * cofactor);  // dE/dJ
      // J = [x1-x0, x2-x0] D^-1 with D the flat triangle's sides.
      const Eigen::Vector2d to_1 = d.col(0) / f.x1 - f.x2 / (f.x1 * f.y2) * d.col(1), to_2 = d.col(1) / f.y2;
      const auto& [a, b, c] = disk_.triangle[t];
      out.row(b) += to_1, out.row(c) += to_2, out.row(a) -= to_1 + to_2;
    }
    return out;
  }

  // The longest step along `p` for which no triangle has lost its area.
  double longest_step(const Plane& x, const Plane& p) const {
    double longest = 1e30;
    for (const auto& [a, b, c] : disk_.triangle) {
      const glm::dvec2 e = at(x, b) - at(x, a), f = at(x, c) - at(x, a), u = at(p, b) - at(p, a),
                       v = at(p, c) - at(p, a);
      // cross(e + s u, f + s v) = q2 s² + q1 s + q0, q0 > 0: its least positive root.
      const double q2 = cross(u, v), q1 = cross(e, v) + cross(u, f), q0 = cross(e, f);
      const double root = q1 * q1 - 4 * q2 * q0;
      if (root < 0) continue;
      const double h = -0.5 * (q1 + std::copysign(std::sqrt(root), q1));
      for (const double s : {q2 != 0 ? h / q2 : -1, h != 0 ? q0 / h : -1})
        if (s > 0) longest = std::min(longest, s);
    }
    return longest;
  }

  // The Laplacian of the cotangents: the energy's second derivative where nothing is distorted, but for a factor.
  Sparse laplacian() const {
    Entries entries;
    for (std::size_t t = 0; t < shape_.size(); ++t) {
      const FlatTriangle& f = shape_[t];
      const double twice = f.x1 * f.y2;
      const double cot[3] = {f.x1 * f.x2 / twice, f.x1 * (f.x1 - f.x2) / twice,
                             (f.y2 * f.y2 - f.x2 * (f.x1 - f.x2)) / twice};
      for (int k = 0; k < 3; ++k) {
        const int i = int(disk_.triangle[t][(k + 1) % 3]), j = int(disk_.triangle[t][(k + 2) % 3]);
        const double w = 0.5 * cot[k];
        entries.emplace_back(i, i, w), entries.emplace_back(j, j, w);
        entries.emplace_back(i, j, -w), entries.emplace_back(j, i, -w);
      }
    }
    const int n = int(disk_.position.size());
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-8);
    Sparse out(n, n);
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
  }

 private:
  static glm::dvec2 at(const Plane& x, std::uint32_t i) { return {x(i, 0), x(i, 1)}; }

  Eigen::Matrix2d jacobian(const Plane& x, std::size_t t) const {
    const FlatTriangle& f = shape_[t];
    const auto& [a, b, c] = disk_.triangle[t];
    Eigen::Matrix2d J;
    J.col(0) = (x.row(b) - x.row(a)).transpose() / f.x1;
    J.col(1) = ((x.row(c) - x.row(a)).transpose() - f.x2 * J.col(0)) / f.y2;
    return J;
  }

  const ChartMesh& disk_;
  std::vector<FlatTriangle> shape_;
};

}  // namespace

FlatPositions mean_value_map(const ChartMesh& disk) {
  FlatPositions flat(disk.position.size(), glm::dvec2(0));
  if (disk.loops.empty()) return flat;
  lay_on_circle(disk, flat);
  std::vector<int> row(flat.size(), 0);
  for (const std::uint32_t v : disk.loops.front()) row[v] = -1;
  int n = 0;
  for (int& r : row)
    if (r == 0) r = n++;
  if (n == 0) return flat;
  Entries entries;
  Plane right = Plane::Zero(n, 2);
  for (const auto& e : mean_value_weights(disk)) {
    const int i = row[std::size_t(e.row())], j = row[std::size_t(e.col())];
    if (i < 0) continue;
    entries.emplace_back(i, i, e.value());
    if (j >= 0)
      entries.emplace_back(i, j, -e.value());
    else
      right.row(i) += e.value() * Eigen::RowVector2d(flat[std::size_t(e.col())].x, flat[std::size_t(e.col())].y);
  }
  Sparse m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Sparse> factors(m);
  if (factors.info() != Eigen::Success) return flat;
  const Plane x = factors.solve(right);
  for (std::size_t v = 0; v < flat.size(); ++v)
    if (row[v] >= 0) flat[v] = {x(row[v], 0), x(row[v], 1)};
  return flat;
}

FlatPositions free_boundary_map(const ChartMesh& disk, int most_steps) {
  FlatPositions flat = mean_value_map(disk);
  const Energy energy(disk);
  Plane x(long(flat.size()), 2);
  for (std::size_t v = 0; v < flat.size(); ++v) x.row(long(v)) << flat[v].x, flat[v].y;
  double value = energy.value(x);
  const Eigen::SimplicialLDLT<Sparse> factors(energy.laplacian());
  if (!std::isfinite(value) || factors.info() != Eigen::Success) return flat;
  for (int step = 0, idle = 0; step < most_steps; ++step) {
    const Plane g = energy.gradient(x);
    const Plane p = -factors.solve(g);
    const double slope = g.cwiseProduct(p).sum();
    if (!(slope < 0)) break;
    double t = std::min(1.0, 0.9 * energy.longest_step(x, p)), next = energy.value(x + t * p);
    while (t > 1e-12 && !(next <= value + 1e-4 * t * slope)) t *= 0.5, next = energy.value(x + t * p);
    if (!(next < value)) break;
    x += t * p;
    idle = value - next < 1e-6 * value ? idle + 1 : 0;
    value = next;
    if (idle == 5) break;
  }
  for (std::size_t v = 0; v < flat.size(); ++v) flat[v] = {x(long(v), 0), x(long(v), 1)};
  return flat;
}

}  // namespace cg
