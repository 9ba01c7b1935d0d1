// Pictures of stuff: brick, wood, marble, hair, cloth, rust, sky. Those that are laid side by side have no seam.
// This work is based on: Darwyn Peachey, Solid Texturing of Complex Surfaces, 1985 (wood, marble); Ken Perlin, An Image
// Synthesizer, 1985.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/texture_makers.h"
#include "scene/texture_noise.h"

namespace cg {

namespace {

constexpr double pi = std::numbers::pi;

struct Brick {
  int column, row;
  double x, y;  // within it, 0..1
};

// A running bond: eight rows of four, every second row moved by half a brick.
Brick brick_at(double u, double v) {
  const int row = int(v * 8) % 8;
  const double x = u * 4 + (row % 2) * 0.5;
  return {int(x) % 4, row, x - std::floor(x), v * 8 - std::floor(v * 8)};
}

double step_between(double low, double high, double x) {
  return smooth_step(std::clamp((x - low) / (high - low), 0.0, 1.0));
}

}  // namespace

double brick_height(double u, double v) {
  const Brick b = brick_at(u, v);
  const double edge = std::min(std::min(b.x, 1 - b.x) * 2, std::min(b.y, 1 - b.y));  // in heights of a brick
  const double rough = turbulence({u * 32, v * 32, 0}, 32, 3, 21);
  return step_between(0.06, 0.16, edge) * (0.85 + 0.15 * rough) + 0.05 * turbulence({u * 64, v * 64, 0}, 64, 2, 22);
}

glm::dvec4 brick_colour(double u, double v) {
  const Brick b = brick_at(u, v);
  const double own = random_number(23, std::uint64_t(b.row * 4 + b.column));
  const double rough = turbulence({u * 16, v * 16, 0}, 16, 5, 24);
  const glm::dvec3 brick =
      glm::mix(glm::dvec3(0.50, 0.20, 0.13), glm::dvec3(0.70, 0.34, 0.22), own) * (0.75 + 0.5 * rough);
  const glm::dvec3 mortar = glm::dvec3(0.72, 0.69, 0.64) * (0.8 + 0.3 * rough);
  const double edge = std::min(std::min(b.x, 1 - b.x) * 2, std::min(b.y, 1 - b.y));
  return glm::dvec4(glm::clamp(glm::mix(mortar, brick, step_between(0.05, 0.10, edge)), 0.0, 1.0), 1);
}

// A plank cut along a trunk whose rings are bent a little.
glm::dvec4 wood(double u, double v) {
  const double bend = 0.35 * (turbulence({u * 4, v * 2, 0}, 4, 4, 31) - 0.5);
  const double x = 3.2 * (u - 0.5) + bend, z = 0.6 + 0.25 * std::sin(2 * pi * v) + 0.2 * bend;
  const double ring = std::hypot(x, z) * 7, part = ring - std::floor(ring);
  const double late = step_between(0.55, 0.95, part) * (1 - step_between(0.95, 1.0, part));
  const double fibre = turbulence({u * 128, v * 4, 0}, 128, 2, 32);
  const glm::dvec3 c = glm::mix(glm::dvec3(0.76, 0.56, 0.34), glm::dvec3(0.47, 0.28, 0.13), late);
  return glm::dvec4(glm::clamp(c * (0.85 + 0.3 * fibre), 0.0, 1.0), 1);
}

// Veins: a sine whose phase is disturbed.
glm::dvec4 marble(double u, double v) {
  const double disturbed = turbulence({u * 4, v * 4, 0}, 4, 6, 41);
  const double vein = std::pow(std::abs(std::sin(pi * (2 * u + 2 * v + 3 * disturbed))), 0.45);
  const glm::dvec3 c = glm::mix(glm::dvec3(0.30, 0.34, 0.38), glm::dvec3(0.94, 0.93, 0.90), vein);
  return glm::dvec4(c * (0.92 + 0.1 * turbulence({u * 16, v * 16, 0}, 16, 3, 42)), 1);
}

// Strands from the top, each thinner towards its end; between them nothing.
glm::dvec4 hair_card(double u, double v) {
  constexpr int strands = 48;
  double alpha = 0, shade = 0;
  for (int i = 0; i < strands; ++i) {
    const auto random = [&](int k) { return random_number(51, std::uint64_t(i * 8 + k)); };
    const double root = random(0), length = 0.55 + 0.45 * random(1), drop = (1 - v) / length;
    if (drop > 1) continue;
    const double x = root + 0.06 * std::sin(2 * pi * (random(2) + drop)) * drop + (random(3) - 0.5) * 0.2 * drop * drop;
    const double width = 0.011 * (1 - 0.85 * drop), off = std::abs(u - x);
    const double here = 1 - step_between(0.5 * width, width, off);
    if (here <= alpha) continue;
    alpha = here, shade = 0.6 + 0.5 * random(4) - 0.3 * off / width;
  }
  // Colour also where nothing is, so that a filter takes no other from there.
  return glm::dvec4(glm::clamp(glm::dvec3(0.42, 0.26, 0.14) * (alpha > 0 ? shade : 0.8), 0.0, 1.0), alpha);
}

// Threads over and under each other, with holes and a torn lower edge.
glm::dvec4 torn_cloth(double u, double v) {
  constexpr double threads = 48;
  const double x = std::abs(std::sin(pi * u * threads)), y = std::abs(std::sin(pi * v * threads));
  const bool over = (int(u * threads) + int(v * threads)) % 2 == 0;
  const double weave = 0.65 + 0.35 * (over ? x : y);
  const double holes = turbulence({u * 6, v * 6, 0}, 6, 4, 61),
               edge = 0.18 + 0.22 * turbulence({u * 8, 0, 0}, 8, 4, 62);
  const double alpha = std::min(1 - step_between(0.60, 0.63, holes), step_between(edge - 0.01, edge + 0.01, v));
  const glm::dvec3 c =
      glm::mix(glm::dvec3(0.30, 0.36, 0.50), glm::dvec3(0.45, 0.48, 0.56), turbulence({u * 12, v * 12, 0}, 12, 3, 63));
  return glm::dvec4(c * weave, alpha);
}

double rust_mask(double u, double v) {
  const double rust = turbulence({u * 5, v * 5, 0}, 5, 6, 71);
  return 1 - step_between(0.46, 0.56, rust);
}

// A blue that pales towards the horizon, clouds, the sun, and haze below.
glm::dvec4 sky(double u, double v) {
  const double longitude = 2 * pi * (u - 0.5), latitude = pi * (v - 0.5);
  const glm::dvec3 d{std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                     -std::cos(latitude) * std::cos(longitude)};
  const glm::dvec3 sun = glm::normalize(glm::dvec3(0.5, 0.6, -0.6));
  if (d.y < 0)
    return glm::dvec4(glm::mix(glm::dvec3(0.70, 0.72, 0.70), glm::dvec3(0.33, 0.36, 0.30), std::min(-4 * d.y, 1.0)), 1);
  glm::dvec3 c = glm::mix(glm::dvec3(0.80, 0.88, 0.95), glm::dvec3(0.18, 0.40, 0.78), std::pow(d.y, 0.6));
  const double near = d.y + 0.15;  // clouds lie on a plane above
  const double cloud = turbulence({d.x / near * 1.5 + 32, d.z / near * 1.5 + 32, 0.5}, 64, 5, 81);
  c = glm::mix(c, glm::dvec3(0.96), step_between(0.52, 0.75, cloud) * std::min(d.y * 4, 1.0) * 0.9);
  const double cosine = glm::dot(d, sun);
  c = glm::mix(c, glm::dvec3(1, 0.98, 0.9),
               std::max(step_between(0.996, 0.9985, cosine), 0.5 * std::pow(std::max(cosine, 0.0), 60)));
  return glm::dvec4(c, 1);
}

}  // namespace cg
