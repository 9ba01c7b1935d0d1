// A scene solved whole: what is computed, what is kept when something changes, and how it ends.
#include "radiosity/solution.h"

#include "params/input_error.h"
#include "scene/shape.h"
#include "tests/radiosity/systems.h"

namespace cg {
namespace {

// As if everything lay on the inside of one sphere: F_ij = A_j / A, whatever the geometry. Counts its rows.
struct SphereRows {
  std::atomic<int> rows{0}, parts{0};
  SolveOptions how() {
    SolveOptions out;
    out.method = [this](const Patches& patches, const Radiosity&) {
      double area = 0;
      for (const Patch& p : patches.patches) area += p.area;
      FormFactorRow row;
      for (std::uint32_t j = 0; j < patches.patches.size(); ++j)
        row.factors.push_back({j, float(patches.patches[j].area / area)});
      row.sum = 1;
      return FormFactorMethod{[this, row](std::uint32_t, const Progress&) { return ++rows, row; },
                              [this, row](const Patch&, std::uint32_t, const Progress&) { return ++parts, row; }};
    };
    return out;
  }
};

Scene lit_cube() {
  Scene scene;
  for (const double x : {0., 3.}) {
    Object o;
    o.mesh = make_shape(*find_shape("cube"), 0);
    o.transform.translate = {x, 0, 0};
    o.own_material = true;
    o.material.k_d = glm::dvec3(x > 0 ? .25 : .75);
    o.material.emission = glm::dvec3(x > 0 ? 1 : 0);
    scene.objects.push_back(o);
  }
  scene.radiosity.patch_size = .5;
  return scene;
}

TEST(SolutionTest, TheLightOfASphere) {
  SphereRows sphere;
  Progress progress;
  const Scene scene = lit_cube();
  MatrixPlan plan;
  SolveOptions how = sphere.how();
  how.announce = [&](const MatrixPlan& p) { plan = p; };
  const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress, how);
  const std::size_t n = s->patches->patches.size();
  EXPECT_EQ(plan.rows, n);
  EXPECT_EQ(s->matrix->size(), n);
  EXPECT_EQ(s->radiosity.size(), n);
  EXPECT_EQ(s->element_radiosity.size(), s->patches->elements.size());
  EXPECT_EQ(s->figures.end, SolverEnd::converged);
  EXPECT_LE(s->figures.error_bound, 1e-6);
  EXPECT_TRUE(s->kept.empty());
  // <E> / (1 - <rho>) = 0.5 / 0.5.
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(s->radiosity[i].x, s->patches->patches[i].object == 1 ? 1.25 : .75, 1e-5);
  EXPECT_NEAR(form_factor(*s, 0, 1, progress), .5, 1e-6);
  EXPECT_NEAR(form_factor(*s, 1, 1, progress), .5, 1e-6);
  EXPECT_EQ(form_factor(*s, 0, 7, progress), 0);
  EXPECT_EQ(drawable(scene, *s)->objects.size(), 2u);
}

TEST(SolutionTest, OnlyWhatAChangeReachesIsComputedAgain) {
  SphereRows sphere;
  Progress progress;
  Scene scene = lit_cube();
  const SolveOptions how = sphere.how();
  const SolutionHandle first = solve_radiosity(scene, scene.radiosity, nullptr, progress, how);
  const int rows = sphere.rows;
  EXPECT_GE(rows, int(first->patches->patches.size()));
  const SolutionHandle same = solve_radiosity(scene, scene.radiosity, first, progress, how);
  EXPECT_EQ(same->matrix, first->matrix);
  EXPECT_TRUE(same->radiosity == first->radiosity);
  EXPECT_EQ(same->kept.size(), 1u);
  scene.objects[0].material.k_d = glm::dvec3(.25);
  scene.objects[1].material.emission = glm::dvec3(3);
  const SolutionHandle bright = solve_radiosity(scene, scene.radiosity, first, progress, how);
  EXPECT_EQ(bright->matrix, first->matrix);
  EXPECT_NEAR(bright->radiosity[0].x, .5, 1e-5);
  EXPECT_EQ(bright->kept.size(), 1u);
  scene.radiosity.solver = RadiositySolver::southwell;
  scene.radiosity.residual = 1e-4;
  EXPECT_EQ(solve_radiosity(scene, scene.radiosity, bright, progress, how)->matrix, first->matrix);
  scene.camera.position.x += 1;
  EXPECT_EQ(solve_radiosity(scene, scene.radiosity, bright, progress, how)->matrix, first->matrix);
  scene.radiosity.rays += 1;  // no Monte Carlo here
  EXPECT_EQ(solve_radiosity(scene, scene.radiosity, bright, progress, how)->matrix, first->matrix);
  EXPECT_EQ(sphere.rows, rows);
  const auto computed_again = [&](const Scene& changed) {
    const int before = sphere.rows;
    const SolutionHandle s = solve_radiosity(changed, changed.radiosity, bright, progress, how);
    return s->kept.empty() && sphere.rows > before;
  };
  Scene moved = scene, finer = scene, resolution = scene;
  moved.objects[0].transform.translate.y = 1;
  finer.radiosity.patch_size = .4;
  resolution.radiosity.resolution = 64;
  for (const Scene* s : {&moved, &finer, &resolution}) EXPECT_TRUE(computed_again(*s));
}

TEST(SolutionTest, ElementsGatherTheirOwnLight) {
  SphereRows sphere;
  Progress progress;
  Scene scene = lit_cube();
  scene.radiosity.adaptive_levels = 2;
  scene.radiosity.gradient = 0;
  const SolutionHandle s = solve_radiosity(scene, scene.radiosity, nullptr, progress, sphere.how());
  EXPECT_EQ(s->element_radiosity.size(), s->patches->elements.size());
  for (std::size_t e = 0; e < s->patches->elements.size(); ++e)
    EXPECT_NEAR(s->element_radiosity[e].x, s->radiosity[s->patches->elements[e].patch].x, 1e-5);
}

TEST(SolutionTest, CancelledItLeavesTheEarlierOne) {
  SphereRows sphere;
  const Scene scene = lit_cube();
  Progress progress;
  const SolutionHandle first = solve_radiosity(scene, scene.radiosity, nullptr, progress, sphere.how());
  const auto before = first->radiosity;
  SolveOptions how = sphere.how();
  how.announce = [&](const MatrixPlan&) { progress.cancelled = true; };
  Radiosity finer = scene.radiosity;
  finer.patch_size = .2;
  EXPECT_THROW(solve_radiosity(scene, finer, first, progress, how), Cancelled);
  EXPECT_TRUE(first->radiosity == before);
}

TEST(SolutionTest, NothingToSolveIsSaid) {
  Progress progress;
  Scene scene = lit_cube();
  for (Object& o : scene.objects) o.visible = false;
  EXPECT_THROW(solve_radiosity(scene, scene.radiosity, nullptr, progress), InputError);
  scene = lit_cube();
  scene.objects[0].material.k_d = glm::dvec3(1.5);
  EXPECT_THROW(solve_radiosity(scene, scene.radiosity, nullptr, progress), InputError);
}

}  // namespace
}  // namespace cg
