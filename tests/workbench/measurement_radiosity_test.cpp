// Measurements of radiosity against values that are known, and what they share.
#include <gtest/gtest.h>

#include <cmath>

#include "params/input_error.h"
#include "raster/software.h"
#include "workbench/measurement.h"
#include "workbench/open.h"

namespace cg {
namespace {

class MeasurementRadiosity : public testing::Test {
 protected:
  double of(const std::string& what, const Scene& scene, MeasurementOptions options = {}) {
    return measure({&find_measurement(what), options}, scene, scene, techniques, progress, solved);
  }
  // A room of six walls, or squares, each one patch.
  static Scene of_whole_faces(const std::string& model) {
    Scene s = open_scene(model);
    for (Object& o : s.objects) o.transform = {};
    s.radiosity.patch_size = 1;
    s.radiosity.form_factors = FormFactors::closed_form;
    return s;
  }
  static MeasurementOptions objects(int object, int to = 1) {
    MeasurementOptions out;
    out.object = object, out.to = to;
    return out;
  }

  const std::vector<Technique> techniques{software_technique()};
  Progress progress;
  SolvedScenes solved;
};

TEST_F(MeasurementRadiosity, FormFactorsOfUnitSquares) {
  EXPECT_NEAR(of("form-factor", of_whole_faces("models/parallel-squares.json"), objects(0, 1)), 0.199824895698, 1e-7);
  EXPECT_NEAR(of("form-factor", of_whole_faces("models/perpendicular-squares.json"), objects(1, 0)), 0.200043776075,
              1e-7);
}

// Floor E = 1, all rho = 0.5: the exact solution of six patches.
TEST_F(MeasurementRadiosity, LightOfACubeOfSixPatches) {
  Scene cube = of_whole_faces("models/closed-cube.json");
  cube.radiosity.solver = RadiositySolver::lu;
  EXPECT_NEAR(of("radiosity", cube, objects(0)), 1.090909098, 1e-7);
  EXPECT_NEAR(of("radiosity", cube, objects(1)), 0.1817458261, 1e-7);
  EXPECT_NEAR(of("radiosity", cube, objects(4)), 0.1818362689, 1e-7);
  EXPECT_EQ(of("patches", cube), 6);
  EXPECT_EQ(of("elements", cube), 6);
  EXPECT_LT(of("residual", cube), 1e-14);
  EXPECT_NEAR(of("row-sum", cube), 1, 1e-7);
  EXPECT_LT(of("reciprocity-error", cube), 1e-7);
  EXPECT_EQ(of("diverges", cube), 0);
}

TEST_F(MeasurementRadiosity, SweepsAndStepsOfTheSolver) {
  Scene cube = of_whole_faces("models/closed-cube.json");
  cube.radiosity.solver = RadiositySolver::jacobi;
  const double sweeps = of("sweeps", cube);
  EXPECT_NEAR(sweeps, std::log(1e-6) / std::log(0.5), 3);
  EXPECT_EQ(of("solver-steps", cube), 6 * sweeps);
}

// The error of rays goes as one over the root of their number; the closed form has none.
TEST_F(MeasurementRadiosity, ErrorOfAllFactors) {
  Scene cube = of_whole_faces("models/closed-cube.json");
  EXPECT_EQ(of("form-factor-error", cube), 0);
  cube.radiosity.patch_size = 0.5;
  cube.radiosity.form_factors = FormFactors::monte_carlo;
  cube.radiosity.rays = 1024;
  const double few = of("form-factor-error", cube);
  cube.radiosity.rays = 16384;
  EXPECT_NEAR(few / of("form-factor-error", cube), 4, 1);
  EXPECT_THROW(of("form-factor-error", open_scene("models/cornell-box.json")), InputError);
}

TEST_F(MeasurementRadiosity, LightThatGrowsIsNoNumber) {
  Scene cube = of_whole_faces("models/closed-cube.json");
  cube.radiosity.form_factors = FormFactors::hemicube;
  cube.radiosity.resolution = 64, cube.radiosity.samples = 1, cube.radiosity.normalise = Normalise::none;
  for (Object& o : cube.objects) o.material.k_d = glm::dvec3(0.9999);
  EXPECT_NEAR(of("row-sum", cube), 1.000132, 1e-6);
  EXPECT_EQ(of("diverges", cube), 1);
  EXPECT_THROW(of("radiosity", cube), InputError);
  cube.radiosity.normalise = Normalise::rows;
  EXPECT_EQ(of("diverges", cube), 0);
}

TEST_F(MeasurementRadiosity, AnObjectThatIsNotThereIsNamed) {
  const Scene squares = of_whole_faces("models/parallel-squares.json");
  EXPECT_THROW(of("form-factor", squares, objects(0, 7)), InputError);
  EXPECT_THROW(of("radiosity", squares, objects(7)), InputError);
}

// A picture has the radiosity that its ambient term asks for: a surface's B is what is seen of it.
TEST_F(MeasurementRadiosity, IsInPictures) {
  Scene squares = of_whole_faces("models/parallel-squares.json");
  squares.camera.position = {0, 0, 0}, squares.camera.target = {0, 0.5, 0}, squares.camera.up = {0, 0, 1};
  squares.shading.clamp = false;
  EXPECT_NEAR(of("mean", squares), of("radiosity", squares, objects(1)), 1e-6);
  squares.shading.ambient_source = AmbientSource::constant;
  squares.shading.ambient = glm::dvec3(0.25);
  squares.objects[1].material.k_a = glm::dvec3(0.5);
  EXPECT_NEAR(of("mean", squares), 0.125, 1e-6);
}

TEST(SolvedScenes, AreSolvedOnce) {
  Scene cube = open_scene("models/closed-cube.json");
  cube.radiosity.patch_size = 0.6;
  SolvedScenes solved;
  Progress progress;
  const SolutionHandle first = solved.of(cube, progress).solution;
  Scene moved = cube;
  moved.camera.position.x += 0.1;
  EXPECT_EQ(solved.of(moved, progress).solution, first);
  Scene brighter = cube;
  brighter.objects[0].material.emission = glm::dvec3(2);
  const SolutionHandle second = solved.of(brighter, progress).solution;
  EXPECT_EQ(second->matrix, first->matrix);
  EXPECT_EQ(solved.of(cube, progress).solution, first);
  for (int i = 0; i < 20; ++i) {
    brighter.objects[0].material.emission = glm::dvec3(3 + i);
    solved.of(brighter, progress);
  }
  EXPECT_NE(solved.of(cube, progress).solution, first) << "the oldest are forgotten";
}

}  // namespace
}  // namespace cg
