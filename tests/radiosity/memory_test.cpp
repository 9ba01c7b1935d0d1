// 100000 patches where the form factors may take only a few MiB: what the plan announces is not passed, and light is
// shot all the same.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "radiosity/solver.h"
#include "tests/radiosity/scenes.h"
#include "tests/sanitized.h"

namespace cg {
namespace {

using namespace testing;

// What this process had in memory at most, bytes.
double peak() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) * 1024;
}

// In a process of its own, as the largest memory is never forgotten. Exits with what it found wrong.
[[noreturn]] void shoot(double memory, Storage storage) {
  Scene scene = scene_of({object_of(room({1, 1, 1}))});
  scene.material.emission = glm::dvec3(1);
  const Radiosity options{.patch_size = 1.0 / 130,
                          .resolution = 16,
                          .samples = 1,
                          .solver = RadiositySolver::progressive,
                          .memory = memory};
  Progress progress;
  const Patches patches = make_patches(scene, options, progress);
  const std::size_t n = patches.patches.size();
  if (n < 100000) std::_Exit(1);
  const FormFactorMethod method = form_factor_method(patches, options);
  MatrixPlan plan = plan_matrix(n, method, memory, progress);
  if (storage == Storage::dense)
    plan = {.rows = n,
            .storage = storage,
            .kept_rows = std::size_t(memory * 1048576 / double(n * 4 + 128)),
            .bytes = std::size_t(memory * 1048576)};
  if (double(plan.bytes) > memory * 1048576 || plan.kept_rows == 0) std::_Exit(2);
  std::vector<double> area;
  for (const Patch& p : patches.patches) area.push_back(p.area);
  const double before = peak();
  const auto matrix = FormFactorMatrix::make(plan, method, area, true, 1, progress);
  // Beside the rows a batch of them, and a few numbers a patch.
  if (matrix->bytes() > plan.bytes || peak() - before > double(plan.bytes) + 16e6) std::_Exit(3);
  Solver solver(system_of(patches, matrix), options, 1);
  solver.forget_states();
  for (int i = 0; i < 10; ++i) solver.step(progress);
  if (peak() - before > double(plan.bytes) + 16e6 + 600 * double(n)) std::_Exit(4);
  if (solver.steps() != 10 || !(solver.radiosity()[n / 2].x > 1)) std::_Exit(5);
  std::_Exit(0);
}

TEST(Memory, HundredThousandPatchesStayWithinThePlan) {
  if (sanitized) GTEST_SKIP() << "a sanitizer takes memory of its own";
  for (const Storage storage : {Storage::sparse, Storage::dense})
    for (const double memory : {1.0, 8.0}) {
      const pid_t child = fork();
      if (child == 0) shoot(memory, storage);
      int status = 0;
      waitpid(child, &status, 0);
      EXPECT_EQ(status, 0) << memory << " MiB: wrong at " << WEXITSTATUS(status);
    }
}

}  // namespace
}  // namespace cg
