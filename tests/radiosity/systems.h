// Systems whose factors and light are known exactly.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "radiosity/solver.h"

namespace cg {

constexpr double cube_opposite = 0.199824895698387, cube_adjacent = 0.200043776075403;  // Howell C-11, C-14

inline RadiositySystem system_with(const std::vector<double>& factors, std::vector<double> area,
                                   std::vector<double> emission, std::vector<double> reflectance) {
  RadiositySystem out{FormFactorMatrix::of(factors, std::move(area)), {}, {}};
  for (const double e : emission) out.emission.emplace_back(e);
  for (const double r : reflectance) out.reflectance.emplace_back(r);
  return out;
}

// A patch a face: floor, ceiling and four walls.
inline RadiositySystem cube_system(std::vector<double> emission, std::vector<double> reflectance) {
  std::vector<double> f;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) f.push_back(i == j ? 0 : i / 2 == j / 2 ? cube_opposite : cube_adjacent);
  return system_with(f, std::vector<double>(6, 1), std::move(emission), std::move(reflectance));
}

// The inside of a sphere of radius 1 in n pieces of different areas: F_ij = A_j / 4 pi, F_ii too.
inline RadiositySystem sphere_system(std::size_t n) {
  std::vector<double> area, factors, emission, reflectance;
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += 1 + double(i * 7 % 5);
  for (std::size_t i = 0; i < n; ++i) area.push_back(4 * M_PI * (1 + double(i * 7 % 5)) / sum);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) factors.push_back(area[j] / (4 * M_PI));
  for (std::size_t i = 0; i < n; ++i) {
    emission.push_back(i % 3 == 0 ? 1 : 0);
    reflectance.push_back(0.1 + 0.1 * double(i % 9));
  }
  return system_with(factors, area, emission, reflectance);
}

inline Radiosity with_solver(RadiositySolver solver, double residual = 1e-10) {
  Radiosity out;
  out.solver = solver;
  out.residual = residual;
  return out;
}

inline constexpr RadiositySolver all_solvers[] = {RadiositySolver::jacobi, RadiositySolver::gauss_seidel,
                                                  RadiositySolver::southwell, RadiositySolver::progressive,
                                                  RadiositySolver::lu};

inline std::vector<glm::dvec3> solve(const RadiositySystem& system, const Radiosity& options) {
  Progress progress;
  Solver solver(system, options);
  solver.run(progress);
  EXPECT_EQ(solver.end(), SolverEnd::converged) << solver.message().en;
  return solver.radiosity();
}

}  // namespace cg
