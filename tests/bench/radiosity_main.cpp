// bench_radiosity [--largest N]: what radiosity costs. A Gauss-Seidel sweep beside one read of the matrix, LU beside
// Gauss-Seidel, the Cornell box phase by phase, and how time and memory grow with the patches. One process and CPU
// time; what is compared takes turns, so that both see the machine at the same speed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "radiosity/solution.h"
#include "scene/cornell_box.h"
#include "scene/cpu_clock.h"

namespace {

using namespace cg;

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

template <class Work>
double cpu_ms_of(const Work& work) {
  const double begin = process_cpu_ms();
  work();
  return process_cpu_ms() - begin;
}

// Every row has `entries` factors, spread over all patches, that sum to 1.
FormFactorMethod spread_rows(std::size_t n, std::size_t entries) {
  const auto row = [=](std::uint32_t i, const Progress&) {
    FormFactorRow out;
    const std::size_t step = n / entries;
    for (std::size_t k = 0; k < entries; ++k)
      out.factors.push_back({std::uint32_t(k * step + (i * 2654435761u + k) % step), float(1.0 / double(entries))});
    out.sum = 1;
    return out;
  };
  return {row, {}};
}

RadiositySystem system_of_rows(std::size_t n, std::size_t entries) {
  Progress progress;
  const FormFactorMethod method = spread_rows(n, entries);
  RadiositySystem out{FormFactorMatrix::make(plan_matrix(n, method, 1e5, progress), method, std::vector<double>(n, 1),
                                             true, 1, progress),
                      std::vector<glm::dvec3>(n), std::vector<glm::dvec3>(n, {.7, .5, .3})};
  out.emission[n / 2] = glm::dvec3(1);
  return out;
}

// All of `bytes` read once from a block of its own, by vector loads.
class Memory {
 public:
  explicit Memory(std::size_t bytes)
      : count_(bytes / sizeof(float) / 32 * 32),
        numbers_(static_cast<float*>(std::aligned_alloc(64, count_ * 4 + 64))) {
    std::fill(numbers_, numbers_ + count_, 1.0f);
  }
  ~Memory() { std::free(numbers_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  float read() const {
    Lanes<float> sums[4] = {};
    for (std::size_t i = 0; i < count_; i += 32)
      for (std::size_t k = 0; k < 4; ++k) {
        Lanes<float> v;
        std::memcpy(&v, numbers_ + i + 8 * k, sizeof v);
        sums[k] += v;
      }
    const Lanes<float> all = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    return all[0] + all[7];
  }

 private:
  std::size_t count_;
  float* numbers_;
};

void sweep_against_read(const char* name, std::size_t n, std::size_t entries) {
  constexpr int pairs = 15;
  Radiosity options;
  options.residual = 1e-300;
  const RadiositySystem system = system_of_rows(n, entries);
  Solver solver(system, options);
  const Memory memory(system.matrix->bytes());
  Progress progress;
  std::vector<double> sweep, read, ratio;
  volatile float sink = 0;
  for (int i = 0; i <= pairs; ++i) {
    const double s = cpu_ms_of([&] { solver.sweep(progress); }), r = cpu_ms_of([&] { sink = sink + memory.read(); });
    if (i == 0) continue;  // warm
    sweep.push_back(s), read.push_back(r), ratio.push_back(s / r);
  }
  std::printf("  %-28s %8.2f ms   read %8.2f ms (%5.1f GB/s)   ratio %5.2f  goal 1.40\n", name, median(sweep),
              median(read), double(system.matrix->bytes()) / median(read) * 1e-6, median(ratio));
  std::fflush(stdout);
}

void lu_against_gauss_seidel(std::size_t n) {
  const RadiositySystem system = system_of_rows(n, n / 2);
  const auto solve = [&](RadiositySolver kind) {
    Progress progress;
    Radiosity options;
    options.solver = kind;
    Solver solver(system, options);
    return cpu_ms_of([&] { solver.run(progress); });
  };
  const double iterated = solve(RadiositySolver::gauss_seidel), direct = solve(RadiositySolver::lu);
  std::printf("  LU %.0f ms, Gauss-Seidel to 1e-6 %.1f ms: %.0f times  goal 10\n", direct, iterated, direct / iterated);
  std::fflush(stdout);
}

Scene cornell_box() {
  Scene scene;
  const std::vector<BundledMaterial> materials = cornell_materials();
  for (const BundledPart& part : cornell_parts()) {
    Object o;
    o.name = part.name;
    o.mesh = Mesh::make(part.mesh);
    o.own_material = true;
    for (const BundledMaterial& m : materials)
      if (m.name == part.material) o.material.k_d = m.reflectance, o.material.emission = m.emission;
    scene.objects.push_back(std::move(o));
  }
  scene.radiosity.resolution = 128;
  return scene;
}

// The coarsest of many patch sizes that gives at least so many patches.
double patch_size_for(const Scene& scene, std::size_t patches) {
  Progress progress;
  Radiosity options = scene.radiosity;
  for (options.patch_size = 0.5; make_patches(scene, options, progress).patches.size() < patches;)
    options.patch_size *= 0.95;
  return options.patch_size;
}

struct Grown {
  double patches, form_factors_s, solve_s, bytes;
};

Grown solve_box(Scene scene, std::size_t patches) {
  Progress progress;
  scene.radiosity.patch_size = patch_size_for(scene, patches);
  const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress);
  const RadiosityFigures& f = s->figures;
  std::printf(
      "  %6zu patches: patches %.3f s, form factors %.2f s, solve %.3f s (%.0f sweeps), %.0f MiB %s, "
      "%zu of %zu rows kept, missed %zu\n",
      s->patches->patches.size(), f.patches_s, f.form_factors_s, f.solve_s, f.sweeps, double(f.matrix_bytes) / 1048576,
      s->matrix->storage() == Storage::dense ? "dense" : "sparse", s->matrix->kept_rows(), s->matrix->size(),
      f.matrix.missed);
  std::fflush(stdout);
  return {double(s->patches->patches.size()), f.form_factors_s, f.solve_s, double(f.matrix_bytes)};
}

// The exponent p of value ~ patches^p, by least squares of logarithms.
double exponent(const std::vector<Grown>& grown, double Grown::*value) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Grown& g : grown) {
    const double a = std::log(g.patches), b = std::log(std::max(g.*value, 1e-9));
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t largest = 16384;
  if (argc == 3 && std::strcmp(argv[1], "--largest") == 0) largest = std::size_t(std::atol(argv[2]));
  std::printf("A Gauss-Seidel sweep, RGB, one thread\n");
  sweep_against_read("4096 patches, dense", 4096, 4096 / 2);
  sweep_against_read("16384 patches, dense", 16384, 16384 / 2);
  sweep_against_read("16384 patches, sparse 1/16", 16384, 1024);
  std::printf("LU, one thread, 4096 patches, three reflectances\n");
  lu_against_gauss_seidel(4096);
  std::printf("The Cornell box, hemicube R = 128, 2 x 2 positions, one thread\n");
  const Scene box = cornell_box();
  std::vector<Grown> grown;
  for (std::size_t n = 1024; n <= largest; n *= 4) grown.push_back(solve_box(box, n));
  std::printf("  form factors ~ patches^%.2f, solve ~ patches^%.2f, memory ~ patches^%.2f\n",
              exponent(grown, &Grown::form_factors_s), exponent(grown, &Grown::solve_s),
              exponent(grown, &Grown::bytes));
}
