// Patches, form factors and light of a scene, computed once and then walked through; parts that a change leaves valid
// are kept.
#pragma once
#include <functional>
#include <memory>

#include "radiosity/patches.h"
#include "radiosity/solver.h"

namespace cg {

// What it took and how good it is.
struct RadiosityFigures {
  double patches_s = 0, form_factors_s = 0, solve_s = 0, elements_s = 0;  // wall clock; 0 where it was kept
  MatrixFigures matrix;
  std::size_t matrix_bytes = 0;
  std::size_t steps = 0;
  double sweeps = 0;
  double residual = 0;     // max norm of E - (1 - rho F) B, measured at the end
  double error_bound = 0;  // as ResidualPoint's
  SolverEnd end = SolverEnd::none;
};

struct RadiositySolution {
  Radiosity options;
  std::shared_ptr<const Patches> patches;
  std::shared_ptr<const FormFactorMatrix> matrix;  // null where it was read from a file
  std::vector<glm::dvec3> radiosity;               // B over pi, by patch
  std::vector<glm::dvec3> element_radiosity;       // the same by element; an element that is its whole patch has its B
  std::uint64_t geometry = 0;                      // geometry_key()
  RadiosityFigures figures;
  std::vector<ResidualPoint> curve;
  std::vector<Text> kept;   // what was taken from an earlier solution, a line each
  std::vector<Text> notes;  // what a user should know: row sums that are off, why the solver stopped
};

// Shared and never changed once it is made.
using SolutionHandle = std::shared_ptr<const RadiositySolution>;

// Told before the form factors are computed: how many rows will be kept in what memory.
using AnnouncePlan = std::function<void(const MatrixPlan&)>;

// Patches, form factors, the linear system and the elements' light, by scene.radiosity's options. Of `earlier`, which
// may be null, it takes the form factors where geometry and method are the same, and all where nothing changed. Where
// it is cancelled `earlier` stays what it is. Throws Cancelled, and InputError where the scene has no patch, a
// reflectance is above 1, or the solver cannot have so many patches.
SolutionHandle solve_radiosity(const Scene& scene, const Radiosity& options, const SolutionHandle& earlier,
                               Progress& progress, int threads = 1, const AnnouncePlan& announce = {});

// F from one object to another, indices into Scene::objects: the mean over the patches of the first, weighted by area,
// of the factors to all patches of the second. 0 where either has no patch. Throws Cancelled.
double form_factor(const RadiositySolution& solution, std::uint32_t from, std::uint32_t to, const Progress& progress);

}  // namespace cg
