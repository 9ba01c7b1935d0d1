// Least squares conformal maps: Lévy, Petitjean, Ray and Maillot, Least Squares Conformal Maps for Automatic Texture
// Atlas Generation, SIGGRAPH 2002, with the energy written as Dirichlet energy minus area, E(z) = ½ z* M z over complex
// coordinates z = u + iv (Desbrun, Meyer and Alliez, Intrinsic Parameterizations of Surface Meshes, 2002). Spectral:
// Mullen, Tong, Alliez and Desbrun, Spectral Conformal Parameterization, 2008.
#include "mapping/conformal.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <complex>

namespace cg {

namespace {

using Complex = std::complex<double>;
using Sparse = Eigen::SparseMatrix<Complex>;
using Vector = Eigen::VectorXcd;
using Entries = std::vector<Eigen::Triplet<Complex>>;

// M, its lower triangle only: cotangent weights, and from the area ±i/2 for each border edge.
Entries conformal_energy(const ChartMesh& disk) {
  Entries out;
  const auto add = [&](std::uint32_t i, std::uint32_t j, Complex m_ij) {
    if (i > j)
      out.emplace_back(int(i), int(j), m_ij);
    else
      out.emplace_back(int(j), int(i), std::conj(m_ij));
  };
  for (const auto& t : disk.triangle) {
    const FlatTriangle f = lay_flat(disk.position[t[0]], disk.position[t[1]], disk.position[t[2]]);
    const double twice = f.x1 * f.y2;
    // cot of the angle at each corner: dot over cross of its two sides.
    const double cot[3] = {f.x1 * f.x2 / twice, f.x1 * (f.x1 - f.x2) / twice,
                           (f.y2 * f.y2 - f.x2 * (f.x1 - f.x2)) / twice};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t i = t[(k + 1) % 3], j = t[(k + 2) % 3];
      const double w = 0.5 * cot[k];
      add(i, j, -w);
      out.emplace_back(int(i), int(i), w), out.emplace_back(int(j), int(j), w);
    }
  }
  for (const auto& loop : disk.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], loop[(k + 1) % loop.size()], Complex(0, 0.5));
  return out;
}

// A vertex of the border that is far from another one, and that one.
std::pair<std::uint32_t, std::uint32_t> far_border_vertices(const ChartMesh& disk) {
  const std::vector<std::uint32_t>& border = disk.loops.front();
  const auto farthest_from = [&](std::uint32_t v) {
    return *std::max_element(border.begin(), border.end(), [&](std::uint32_t a, std::uint32_t b) {
      return glm::distance(disk.position[a], disk.position[v]) < glm::distance(disk.position[b], disk.position[v]);
    });
  };
  const std::uint32_t a = farthest_from(border.front()), b = farthest_from(a);
  return {a, a == b ? border[border.front() == a] : b};
}

std::optional<FlatPositions> positions_of(const Vector& z) {
  FlatPositions out(std::size_t(z.size()));
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = {z[long(i)].real(), z[long(i)].imag()};
    if (!std::isfinite(out[i].x) || !std::isfinite(out[i].y)) return std::nullopt;
  }
  return out;
}

}  // namespace

std::optional<FlatPositions> least_squares_conformal(const ChartMesh& disk) {
  if (disk.loops.empty()) return std::nullopt;
  const auto [a, b] = far_border_vertices(disk);
  const int n = int(disk.position.size()), low = int(std::min(a, b)), high = int(std::max(a, b));
  Vector z = Vector::Zero(n);
  z[int(b)] = std::max(glm::distance(disk.position[a], disk.position[b]), 1e-12);
  const auto free_index = [&](int i) { return i == low || i == high ? -1 : i - (i > low) - (i > high); };
  Entries free;
  Vector right = Vector::Zero(n - 2);
  for (const auto& e : conformal_energy(disk)) {
    const int i = free_index(e.row()), j = free_index(e.col());
    if (i >= 0 && j >= 0)
      free.emplace_back(i, j, e.value());
    else if (i >= 0)
      right[i] -= e.value() * z[e.col()];
    else if (j >= 0)
      right[j] -= std::conj(e.value()) * z[e.row()];
  }
  if (n > 2) {
    Sparse m(n - 2, n - 2);
    m.setFromTriplets(free.begin(), free.end());
    const Eigen::SimplicialLDLT<Sparse> factors(m);
    if (factors.info() != Eigen::Success) return std::nullopt;
    const Vector x = factors.solve(right);
    for (int i = 0; i < n; ++i)
      if (free_index(i) >= 0) z[i] = x[free_index(i)];
  }
  return positions_of(z);
}

// The smallest eigenvector of M z = lambda B z that is not the constant one, B the indicator of the border, by inverse
// iteration.
std::optional<FlatPositions> spectral_conformal(const ChartMesh& disk) {
  const std::optional<FlatPositions> start = least_squares_conformal(disk);
  if (!start) return std::nullopt;
  const int n = int(start->size());
  Entries entries = conformal_energy(disk);
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-8);  // M is singular
  Sparse m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> factors(m);
  if (factors.info() != Eigen::Success) return std::nullopt;
  Vector z(n), on_border = Vector::Zero(n);
  for (int i = 0; i < n; ++i) z[i] = Complex((*start)[std::size_t(i)].x, (*start)[std::size_t(i)].y);
  for (const std::uint32_t v : disk.loops.front()) on_border[int(v)] = 1;
  for (int step = 0; step < 8; ++step) {
    Vector right = z.cwiseProduct(on_border);
    right -= right.sum() / on_border.sum() * on_border;
    z = factors.solve(right);
    z /= z.norm();
  }
  return positions_of(z);
}

}  // namespace cg
