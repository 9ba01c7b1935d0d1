#include "workbench/challenge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "params/slots.h"
#include "workbench/scene_differences.h"

namespace cg {

namespace {

// The scene's models, camera and display; else the defaults.
Scene bare(const Scene& scene) {
  Scene out = scene;
  const Scene usual;
  out.material = usual.material, out.lights = usual.lights, out.shading = usual.shading, out.mistakes = usual.mistakes;
  for (Object& object : out.objects) object.own_material = false, object.material = usual.material;
  return out;
}

std::vector<std::string> offered_between(const Scene& start, const Scene& target) {
  std::vector<std::string> paths;
  for (const ParameterDifference& d : scene_differences(start, target)) paths.push_back(d.path);
  return paths;
}

// SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014): the same numbers everywhere.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  // One of 0..n-1.
  int below(int n) { return int(next() % std::uint64_t(n)); }
  // One of low, low + step, ..., in twentieths and the like: `steps` + 1 values.
  double among(double low, double high, int steps) {
    return std::round((low + (high - low) * below(steps + 1) / steps) * 1000) / 1000;
  }
  glm::dvec3 colour(double low, double high, int steps) {
    const double r = among(low, high, steps), g = among(low, high, steps);
    return {r, g, among(low, high, steps)};
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

constexpr std::array<double, 6> exponents{2, 5, 10, 20, 50, 100};

}  // namespace

Challenge challenge_of(const Scene& scene) {
  Challenge out{bare(scene), scene, {}};
  out.offered = offered_between(out.start, out.target);
  return out;
}

Challenge made_up_challenge(const Scene& scene, std::uint64_t seed, int level) {
  Numbers numbers(seed);
  Challenge out{bare(scene), bare(scene), {}};
  Material& m = out.target.material;
  m.k_d = numbers.colour(0.1, 0.9, 16);
  m.n = exponents[std::size_t(numbers.below(int(exponents.size())))];
  if (level >= 2) {
    m.k_s = glm::dvec3(numbers.among(0.2, 1, 16));
    m.k_a = m.k_d;
    out.target.shading.ambient = glm::dvec3(numbers.among(0.05, 0.5, 9));
  }
  if (level >= 3) {
    Light& light = out.target.lights[0];
    // Before the model, so that there is something to see.
    const double angle = numbers.among(-1.2, 1.2, 24), height = numbers.among(0, 8, 16);
    light.position = {std::round(100 * std::sin(angle)) / 10, height, std::round(100 * std::cos(angle)) / 10};
    light.diffuse = light.specular = numbers.colour(0.5, 1, 10);
  }
  out.offered = offered_between(out.start, out.target);
  return out;
}

}  // namespace cg
