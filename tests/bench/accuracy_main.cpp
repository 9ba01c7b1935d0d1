// bench_accuracy: how far hemicubes' form factors are from closed forms, over where the positions stand, how many there
// are, and the resolution. Two squares opposite each other and two with a common edge, a point and a plate, and other
// pairs of rectangles: turned, beside, small, unequal. Deterministic: not a time but a table of errors.
#include <cmath>
#include <cstdio>
#include <random>

#include "radiosity/closed_form.h"
#include "radiosity/form_factors.h"
#include "tests/radiosity/patch_rooms.h"

namespace {

using namespace cg;

const glm::dvec3 origin(0), x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

double factor(const Patches& patches, std::uint32_t from, std::uint32_t to, const Radiosity& options) {
  const Progress progress;
  for (const FormFactor& f : form_factor_method(patches, options).row(from, progress).factors)
    if (f.patch == to) return double(f.value);
  return 0;
}

// A pair of rectangles, and what its closed form is.
struct Pair {
  Patches patches;
  double exact;
};

Pair pair_of(const glm::dvec3& at, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& to,
             const glm::dvec3& to_u, const glm::dvec3& to_v) {
  Pair out;
  add_rectangle(out.patches, at, u, v);
  add_rectangle(out.patches, to, to_u, to_v);
  const auto corners = [&](std::size_t i) { return std::span<const glm::dvec3>(out.patches.patches[i].corner); };
  out.exact = polygon_form_factor(corners(0), corners(1));
  return out;
}

// Rectangles before the unit square, turned anyhow, with sides from 0.2 to 1.2, some of them behind its edges.
std::vector<Pair> other_pairs(std::size_t count) {
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * double(random()) / double(std::mt19937::max());
  };
  std::vector<Pair> out;
  while (out.size() < count) {
    const glm::dvec3 centre(uniform(-1, 2), uniform(-1, 2), uniform(0.3, 2));
    const glm::dvec3 u = unit(glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    const glm::dvec3 v = unit(glm::cross(u, glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))));
    const glm::dvec3 a = uniform(0.2, 1.2) * u, b = uniform(0.2, 1.2) * v;
    Pair p = pair_of(origin, x_axis, y_axis, centre - 0.5 * (a + b), a, b);
    if (p.exact > 0.005) out.push_back(std::move(p));
  }
  return out;
}

struct Errors {
  double opposite = 0, perpendicular = 0;      // of F
  double mean = 0, largest = 0, relative = 0;  // of the others, |error of F| and over F
};

Errors errors_of(const std::vector<Pair>& pairs, const Radiosity& options) {
  Errors e;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double error = factor(pairs[i].patches, 0, 1, options) - pairs[i].exact;
    if (i == 0) e.opposite = error;
    if (i == 1) e.perpendicular = error;
    if (i < 2) continue;
    e.mean += std::abs(error) / double(pairs.size() - 2);
    e.relative += std::abs(error) / pairs[i].exact / double(pairs.size() - 2);
    e.largest = std::max(e.largest, std::abs(error));
  }
  return e;
}

void print_point_to_plate() {
  Patches point;
  add_rectangle(point, {-5e-10, -5e-10, 0}, 1e-9 * x_axis, 1e-9 * y_axis);
  add_rectangle(point, {-0.5, -0.5, 1}, y_axis, x_axis);
  constexpr double exact = 0.239456470461;
  std::printf("a point and a 1 x 1 plate at distance 1, one position: F - %.6f\n", exact);
  for (const int resolution : {16, 32, 64, 128, 256, 512, 1024}) {
    std::printf("  R = %4d:", resolution);
    for (const Name& name : names_of<PixelWeight>) {
      Radiosity options;
      options.resolution = resolution, options.samples = 1;
      options.weight = PixelWeight(&name - names_of<PixelWeight>.data());
      std::printf("  %.*s %+.2e", int(name.id.size()), name.id.data(), factor(point, 0, 1, options) - exact);
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::size_t(std::atol(argv[1])) : 60;
  print_point_to_plate();
  std::vector<Pair> pairs{pair_of(origin, x_axis, y_axis, z_axis, y_axis, x_axis),
                          pair_of(origin, x_axis, y_axis, origin, y_axis, z_axis)};
  for (Pair& p : other_pairs(count)) pairs.push_back(std::move(p));
  std::printf(
      "pairs of rectangles: error of F, opposite and perpendicular unit squares; %zu others, the mean error\n"
      "of F, the largest, and the mean of the relative ones\n",
      count);
  for (const PixelWeight weight : {PixelWeight::delta_form_factor, PixelWeight::integrated})
    for (const Placement placement : {Placement::grid, Placement::gauss})
      for (const int samples : {1, 2, 3, 4, 6, 8})
        for (const int resolution : {16, 32, 64, 128, 256, 512}) {
          Radiosity options;
          options.weight = weight, options.placement = placement;
          options.samples = samples, options.resolution = resolution;
          const Errors e = errors_of(pairs, options);
          std::printf("  %-17s %-5s S = %d R = %3d: %+.2e %+.2e   %.2e %.2e %5.2f %%\n",
                      names_of<PixelWeight>[std::size_t(weight)].id.data(),
                      names_of<Placement>[std::size_t(placement)].id.data(), samples, resolution, e.opposite,
                      e.perpendicular, e.mean, e.largest, 100 * e.relative);
        }
}
