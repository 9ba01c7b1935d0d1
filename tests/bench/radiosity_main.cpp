// bench_radiosity [--grow FILE N...] [--memory MIB]: what radiosity costs, in CPU time; what is compared takes turns in
// one process, so that both see the machine at the same speed.
//   without options: a Gauss-Seidel sweep beside one read of the matrix, LU beside Gauss-Seidel, and what rows that are
//     made reciprocal cost and keep
//   --grow FILE N...: the Cornell box with about N patches each, R = 128, one position, phase by phase, each in a
//   process
//     of its own that tells its largest memory; adds a line each to FILE, and fits all lines of FILE: sizes that take
//     long can be run one at a time, as in --grow growth.txt 65536
//   --memory MIB: 100000 patches where only so much may be kept: some shots of progressive refinement, beside the plan
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <sstream>

#include "radiosity/solution.h"
#include "scene/cornell_box.h"
#include "scene/cpu_clock.h"
#include "tests/radiosity/scenes.h"

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
  double patches = 0, patches_s = 0, form_factors_s = 0, solve_s = 0, matrix_mib = 0, peak_mib = 0;
};
constexpr std::pair<const char*, double Grown::*> columns[] = {
    {"patches", &Grown::patches}, {"patches_s", &Grown::patches_s},   {"form_factors_s", &Grown::form_factors_s},
    {"solve_s", &Grown::solve_s}, {"matrix_MiB", &Grown::matrix_mib}, {"peak_MiB", &Grown::peak_mib},
};

// What this process had in memory at most, MiB. (It begins at what the one before fork() had.)
double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

// work() in a process of its own, which ends with it.
template <class Work>
void apart(const Work& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) std::printf("  it ended with status %d\n", status);
}

std::vector<double> areas_of(const Patches& patches) {
  std::vector<double> out;
  for (const Patch& p : patches.patches) out.push_back(p.area);
  return out;
}

// Seconds of processor time.
template <class Work>
double seconds_of(const Work& work) {
  return cpu_ms_of(work) / 1e3;
}

// What the rows would take, from some that are spread evenly: where not all of them fit.
void estimate_rows(Grown& g, const FormFactorMethod& method, const MatrixPlan& all) {
  constexpr std::size_t tried = 256;
  Progress progress;
  g.form_factors_s = seconds_of([&] {
    for (std::size_t t = 0; t < tried; ++t) method.row(std::uint32_t((2 * t + 1) * all.rows / (2 * tried)), progress);
  });
  g.form_factors_s *= double(all.rows) / double(tried);
  g.matrix_mib = double(all.bytes) / 1048576;
  std::printf("  %zu patches: form factors from %zu rows, as all would take %.0f MiB; not solved\n", all.rows, tried,
              g.matrix_mib);
}

void grow(const char* file, std::size_t wanted) {
  const double most_bytes = 0.5 * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  Scene scene = cornell_box();
  Radiosity& o = scene.radiosity;
  o.samples = 1;
  o.patch_size = patch_size_for(scene, wanted);
  Progress progress;
  Grown g;
  Patches patches;
  g.patches_s = seconds_of([&] { patches = make_patches(scene, o, progress); });
  const std::size_t n = patches.patches.size();
  g.patches = double(n);
  const FormFactorMethod method = form_factor_method(patches, o);
  const MatrixPlan plan = plan_matrix(n, method, 1e9, progress);
  if (double(plan.bytes) > most_bytes) {
    estimate_rows(g, method, plan);
  } else {
    std::shared_ptr<const FormFactorMatrix> matrix;
    g.form_factors_s = seconds_of(
        [&] { matrix = FormFactorMatrix::make(plan, method, areas_of(patches), patches.closed, 1, progress); });
    Solver solver(system_of(patches, matrix), o);
    solver.forget_states();
    g.solve_s = seconds_of([&] { solver.run(progress); });
    g.matrix_mib = double(matrix->bytes()) / 1048576;
    std::size_t missed = 0;
    for (const RowFigures& row : matrix->row_figures()) missed += row.missed;
    std::printf("  %zu patches: %s, %.0f sweeps, missed %zu\n", n, plan.text().en.c_str(), solver.sweeps(), missed);
  }
  g.peak_mib = peak_mib();
  if (std::FILE* out = std::fopen(file, "a")) {
    for (const auto& [name, value] : columns) std::fprintf(out, "%s %g ", name, g.*value);
    std::fprintf(out, "\n");
    std::fclose(out);
  }
}

std::vector<Grown> read_growth(const char* file) {
  std::vector<Grown> out;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string name;
    Grown g;
    for (const auto& [column, value] : columns) words >> name >> g.*value;
    if (words) out.push_back(g);
  }
  std::sort(out.begin(), out.end(), [](const Grown& a, const Grown& b) { return a.patches < b.patches; });
  return out;
}

// The exponent p of value ~ patches^p, by least squares of logarithms.
double exponent(const std::vector<Grown>& grown, double Grown::*value) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Grown& g : grown) {
    if (!(g.*value > 0)) continue;  // not measured
    const double a = std::log(g.patches), b = std::log(g.*value);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void print_growth(const std::vector<Grown>& grown) {
  for (const auto& [name, value] : columns) std::printf("  %14s", name);
  for (const Grown& g : grown) {
    std::printf("\n");
    for (const auto& [name, value] : columns) std::printf("  %14.4g", g.*value);
  }
  if (grown.size() > 1) {
    std::printf("\n  %14s", "~ patches^");
    for (const auto& [name, value] : std::span(columns).subspan(1)) std::printf("  %14.2f", exponent(grown, value));
  }
  std::printf("\n");
}

void few_shots(double memory) {
  constexpr std::size_t shots = 20;
  Scene scene = cornell_box();
  Radiosity& o = scene.radiosity;
  o.solver = RadiositySolver::progressive, o.samples = 1, o.memory = memory;
  o.patch_size = patch_size_for(scene, 100000);
  Progress progress;
  const double before = peak_mib();
  const Patches patches = make_patches(scene, o, progress);
  const FormFactorMethod method = form_factor_method(patches, o);
  const MatrixPlan plan = plan_matrix(patches.patches.size(), method, memory, progress);
  const double begun = peak_mib();
  std::shared_ptr<const FormFactorMatrix> matrix;
  const double made_s =
      seconds_of([&] { matrix = FormFactorMatrix::make(plan, method, areas_of(patches), false, 1, progress); });
  Solver solver(system_of(patches, matrix), o);
  solver.forget_states();
  const double shot_s = seconds_of([&] {
    while (solver.steps() < shots) solver.step(progress);
  });
  std::printf("  %zu patches, %.0f MiB before the rows\n  planned: %s\n", patches.patches.size(), begun - before,
              plan.text().en.c_str());
  std::printf("  rows %.1f s, %zu shots %.2f s, error below %.2f; %.0f MiB more at most, %.0f planned\n", made_s, shots,
              shot_s, solver.curve().back().error_bound, peak_mib() - begun, double(plan.bytes) / 1048576);
}

// What it costs that a closed room's rows are reciprocal, and what that keeps of the light that the floor emits.
void reciprocal_against_rows(double patch_size) {
  const auto walls = testing::room({1, 1, 1});
  Scene scene = testing::scene_of(
      {testing::object_of({walls[0]}, "floor"), testing::object_of({walls.begin() + 1, walls.end()}, "walls")});
  scene.material.k_d = glm::dvec3(0.8);
  scene.objects[0].own_material = true;
  scene.objects[0].material.emission = glm::dvec3(1);
  Radiosity& o = scene.radiosity;
  o.patch_size = patch_size, o.resolution = 64, o.samples = 1;
  Progress progress;
  for (const Normalise n : {Normalise::none, Normalise::rows, Normalise::reciprocal}) {
    o.normalise = n;
    const SolutionHandle s = solve_radiosity(scene, o, nullptr, progress);
    std::printf("  %5zu patches, %-10s: form factors %.3f s, energy off %.1e\n", s->radiosity.size(),
                names_of<Normalise>[std::size_t(n)].id.data(), s->figures.form_factors_s, s->figures.energy_error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 3 && std::strcmp(argv[1], "--grow") == 0) {
    std::printf("The Cornell box, hemicube R = 128, one position, one thread\n");
    for (int i = 3; i < argc; ++i) apart([&] { grow(argv[2], std::size_t(std::atol(argv[i]))); });
    print_growth(read_growth(argv[2]));
    return 0;
  }
  if (argc == 3 && std::strcmp(argv[1], "--memory") == 0) {
    std::printf("The Cornell box, hemicube R = 128, one position, progressive refinement, %s MiB\n", argv[2]);
    few_shots(std::atof(argv[2]));
    return 0;
  }
  std::printf("A Gauss-Seidel sweep, RGB, one thread\n");
  sweep_against_read("4096 patches, dense", 4096, 4096 / 2);
  sweep_against_read("16384 patches, dense", 16384, 16384 / 2);
  sweep_against_read("16384 patches, sparse 1/16", 16384, 1024);
  std::printf("LU, one thread, 4096 patches, three reflectances\n");
  lu_against_gauss_seidel(4096);
  std::printf("Rows of a closed cube, R = 64, one position\n");
  for (const double size : {0.2, 0.05, 0.025}) reciprocal_against_rows(size);
}
