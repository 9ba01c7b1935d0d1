// Nothing but the time depends on the number of threads: whole solutions, to the last bit, for every method and weight.
#include <gtest/gtest.h>

#include "radiosity/solution_file.h"
#include "tests/radiosity/scenes.h"

namespace cg {
namespace {

using namespace testing;

Scene furnished() {
  Scene scene = scene_of({object_of(room({1, 1, 1})), shape_object("cube")});
  scene.material.k_d = {0.25, 0.5, 0.7};
  scene.objects[1].transform = {.translate = {0.45, 0.3, 0.55}, .scale = glm::dvec3(0.15)};
  scene.objects[1].own_material = true;
  scene.objects[1].material.emission = {1, 0.5, 0.25};
  return scene;
}

void expect_the_same(const Radiosity& options, const std::string& what) {
  const Scene scene = furnished();
  const auto solve = [&](int threads) {
    Progress progress;
    SolveOptions how;
    how.threads = threads;
    return solve_radiosity(scene, options, nullptr, progress, how);
  };
  const SolutionHandle one = solve(1);
  const std::string bytes = solution_bytes(*one);
  for (const int threads : {2, 7}) {
    const SolutionHandle many = solve(threads);
    EXPECT_TRUE(solution_bytes(*many) == bytes) << what << ", " << threads << " threads";
    ASSERT_EQ(one->matrix->size(), many->matrix->size());
    for (std::size_t i = 0; i < one->matrix->size(); ++i) {
      ASSERT_EQ(one->matrix->row_figures()[i].sum, many->matrix->row_figures()[i].sum) << what;
      ASSERT_EQ(one->matrix->row_figures()[i].missed, many->matrix->row_figures()[i].missed) << what;
      for (std::size_t j = 0; j < one->matrix->size(); ++j)
        ASSERT_EQ(one->matrix->at(i, j), many->matrix->at(i, j)) << what << ' ' << i << ' ' << j;
    }
  }
}

Radiosity coarse() {
  return {.patch_size = 0.35, .adaptive_levels = 1, .gradient = 0.05, .resolution = 32, .samples = 2, .rays = 200};
}

TEST(Threads, EveryMethod) {
  for (std::size_t m = 0; m < names_of<FormFactors>.size(); ++m)
    for (const Normalise normalise : {Normalise::none, Normalise::rows, Normalise::reciprocal}) {
      Radiosity options = coarse();
      options.form_factors = FormFactors(m);
      options.normalise = normalise;
      expect_the_same(options, std::string(names_of<FormFactors>[m].id));
    }
}

TEST(Threads, EveryWeightAndPlacement) {
  for (std::size_t w = 0; w < names_of<PixelWeight>.size(); ++w)
    for (const Placement placement : {Placement::grid, Placement::gauss}) {
      Radiosity options = coarse();
      options.weight = PixelWeight(w);
      options.placement = placement;
      expect_the_same(options, std::string(names_of<PixelWeight>[w].id));
    }
}

TEST(Threads, EverySolver) {
  for (std::size_t s = 0; s < names_of<RadiositySolver>.size(); ++s) {
    Radiosity options = coarse();
    options.solver = RadiositySolver(s);
    options.resolution = 16, options.samples = 1;
    expect_the_same(options, std::string(names_of<RadiositySolver>[s].id));
  }
}

}  // namespace
}  // namespace cg
