// Noise to make pictures of, without a seam: the value at (x + period, y) is that at (x, y).
// This work is based on: Ken Perlin, An Image Synthesizer, 1985 (noise, turbulence); values at lattice points instead
// of gradients.
#pragma once
#include <glm/vec3.hpp>

#include "math/counter_random.h"

namespace cg {

inline double smooth_step(double t) { return t * t * (3 - 2 * t); }

// 0..1; the lattice's points are whole numbers, `period` of them to a side.
inline double lattice_noise(double x, double y, double z, int period, std::uint64_t seed) {
  const double x0 = std::floor(x), y0 = std::floor(y), z0 = std::floor(z);
  const double a = smooth_step(x - x0), b = smooth_step(y - y0), c = smooth_step(z - z0);
  const auto at = [&](double i, double j, double k) {
    const auto wrap = [&](double v) { return std::uint64_t((std::int64_t(v) % period + period) % period); };
    return random_number(seed, (wrap(k) * 4096 + wrap(j)) * 4096 + wrap(i));
  };
  const auto mix = [](double p, double q, double t) { return p + (q - p) * t; };
  const auto plane = [&](double k) {
    return mix(mix(at(x0, y0, k), at(x0 + 1, y0, k), a), mix(at(x0, y0 + 1, k), at(x0 + 1, y0 + 1, k), a), b);
  };
  return mix(plane(z0), plane(z0 + 1), c);
}

// Octaves, each twice as fine and half as strong; 0..1. `p` counts the first one's lattice.
inline double turbulence(const glm::dvec3& p, int period, int octaves, std::uint64_t seed) {
  double sum = 0, weight = 0, scale = 1;
  for (int i = 0; i < octaves; ++i, scale *= 2) {
    sum += lattice_noise(p.x * scale, p.y * scale, p.z * scale, int(period * scale), seed + std::uint64_t(i)) / scale;
    weight += 1 / scale;
  }
  return sum / weight;
}

}  // namespace cg
