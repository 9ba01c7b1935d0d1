// A solution cancelled at any moment of any phase: heard within 100 ms, and the one before stays whole.
#include <gtest/gtest.h>
#include <pthread.h>

#include <random>
#include <thread>

#include "radiosity/solution_file.h"
#include "scene/cpu_clock.h"
#include "tests/radiosity/scenes.h"
#include "tests/sanitized.h"

namespace cg {
namespace {

using namespace testing;

constexpr double most_ms = sanitized ? 500 : 100;  // instrumented, a step between two looks takes that much longer

Scene lit_room(double rho = 0.5) {
  Scene scene = scene_of({object_of(room({1, 1, 1})), shape_object("cube")});
  scene.material.k_d = glm::dvec3(rho, 0.9 * rho, 0.8 * rho);
  scene.objects[1].transform = {.translate = {0.45, 0.3, 0.55}, .scale = glm::dvec3(0.15)};
  scene.objects[1].own_material = true;
  scene.objects[1].material.emission = {1, 0.5, 0.25};
  return scene;
}

Radiosity quick(double patch_size) {
  return {.patch_size = patch_size, .resolution = 32, .samples = 1, .rays = 100000};
}

// Cancels `work` when it has run for `after` ms; returns how long it still ran, or nothing where it had ended. In
// processor time of this thread: on a machine with other work to do the clock on the wall says nothing.
template <class Work>
std::optional<double> ms_after_cancel(double after, const Work& work) {
  clockid_t clock;
  pthread_getcpuclockid(pthread_self(), &clock);
  const double begin = clock_ms(clock);
  std::atomic<double> cancelled{0};
  Progress progress;
  std::jthread other([&](const std::stop_token& ended) {
    while (!ended.stop_requested() && clock_ms(clock) - begin < after)
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    cancelled = clock_ms(clock);
    progress.cancelled = true;
  });
  try {
    work(progress);
  } catch (const Cancelled&) {
    return clock_ms(clock) - cancelled;
  }
  return std::nullopt;
}

// Everything of a solution that a later one may take.
struct Whole {
  std::string bytes;
  double factors = 0;
  explicit Whole(const RadiositySolution& s) : bytes(solution_bytes(s)) {
    for (std::size_t i = 0; i < s.matrix->size(); ++i)
      factors += double(i + 1) * s.matrix->row_sum(i) * s.matrix->at(i, 0);
  }
  friend bool operator==(const Whole&, const Whole&) = default;
};

class Cancelling : public ::testing::Test {
 protected:
  // Cancels `trials` solutions of the scene, each once within [first, first + span) ms. At least half must still run.
  void expect_heard(const Scene& scene, const Radiosity& options, const SolutionHandle& earlier, double first,
                    double span, int trials, const std::string& what) {
    const Whole before(*earlier);
    std::uniform_real_distribution<double> at(first, first + span);
    int heard = 0;
    double most = 0;
    for (int i = 0; i < trials; ++i) {
      const double after = at(random_);
      const auto ms = ms_after_cancel(after, [&](Progress& p) { solve_radiosity(scene, options, earlier, p); });
      if (!ms) continue;
      ++heard;
      most = std::max(most, *ms);
      EXPECT_LT(*ms, most_ms) << what << ", cancelled after " << after << " ms";
    }
    std::printf("%s: %d of %d cancelled, heard after %.1f ms at most\n", what.c_str(), heard, trials, most);
    EXPECT_GE(heard, trials / 2) << what;
    EXPECT_TRUE(Whole(*earlier) == before) << what;
  }

  std::mt19937 random_{5};
  Progress progress_;
};

double patches_ms(const Scene& scene, const Radiosity& options) {
  Progress progress;
  const double begin = thread_cpu_ms();
  make_patches(scene, options, progress);
  return thread_cpu_ms() - begin;
}

TEST_F(Cancelling, Patches) {
  const SolutionHandle earlier = solve_radiosity(lit_room(), quick(0.3), nullptr, progress_);
  const Radiosity fine = quick(0.005);
  const double ms = patches_ms(lit_room(), fine);
  expect_heard(lit_room(), fine, earlier, 0, ms, 10, "patches");
  // Between the patches and the first rows: the plan, and the tables of the method.
  expect_heard(lit_room(), fine, earlier, ms, 2 * ms, 10, "240000 patches' first rows");
}

TEST_F(Cancelling, FormFactors) {
  const SolutionHandle earlier = solve_radiosity(lit_room(), quick(0.3), nullptr, progress_);
  for (std::size_t m = 0; m < names_of<FormFactors>.size(); ++m) {
    Radiosity fine = quick(0.02);
    fine.form_factors = FormFactors(m);
    expect_heard(lit_room(), fine, earlier, patches_ms(lit_room(), fine), 300, 6,
                 std::string(names_of<FormFactors>[m].id));
  }
}

TEST_F(Cancelling, Solve) {
  Radiosity options = quick(1.0 / 12);
  options.normalise = Normalise::reciprocal;
  const SolutionHandle earlier = solve_radiosity(lit_room(), options, nullptr, progress_);
  const double first = patches_ms(lit_room(), options);
  for (std::size_t s = 0; s < names_of<RadiositySolver>.size(); ++s) {
    options.solver = RadiositySolver(s);
    options.residual = 1e-14;
    expect_heard(lit_room(0.99999), options, earlier, first, 60, 8, std::string(names_of<RadiositySolver>[s].id));
  }
}

TEST_F(Cancelling, Elements) {
  Radiosity options = quick(0.34);
  options.adaptive_levels = 3, options.gradient = 0;
  const SolutionHandle earlier = solve_radiosity(lit_room(), options, nullptr, progress_);
  Scene brighter = lit_room(0.6);
  const double begin = thread_cpu_ms();
  EXPECT_EQ(solve_radiosity(brighter, options, earlier, progress_)->kept.size(), 1u);
  expect_heard(brighter, options, earlier, 0, 0.9 * (thread_cpu_ms() - begin), 12, "elements");
}

// What is kept is not only unharmed: the next solution is the one that it would have been.
TEST_F(Cancelling, TheNextSolutionIsTheSame) {
  const SolutionHandle earlier = solve_radiosity(lit_room(), quick(0.2), nullptr, progress_);
  const SolutionHandle undisturbed = solve_radiosity(lit_room(0.7), quick(0.2), earlier, progress_);
  for (const double after : {0.0, 1.0, 3.0})
    ms_after_cancel(after, [&](Progress& p) { solve_radiosity(lit_room(0.7), quick(0.2), earlier, p); });
  const SolutionHandle next = solve_radiosity(lit_room(0.7), quick(0.2), earlier, progress_);
  EXPECT_EQ(next->matrix, earlier->matrix);
  EXPECT_TRUE(solution_bytes(*next) == solution_bytes(*undisturbed));
}

}  // namespace
}  // namespace cg
