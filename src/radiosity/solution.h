// Patches, form factors and light of a scene, computed once and then walked through; parts that a change leaves valid
// are kept.
#pragma once
#include <functional>
#include <memory>

#include "radiosity/patches.h"
#include "radiosity/solver.h"
#include "scene/radiosity_field.h"

namespace cg {

// What it took and how good it is.
struct RadiosityFigures {
  double patches_s = 0, form_factors_s = 0, solve_s = 0, elements_s = 0;  // wall clock; 0 where it was kept
  MatrixFigures matrix;
  std::size_t matrix_bytes = 0;
  std::size_t steps = 0;
  double sweeps = 0;
  // The share of the emitted light that patches neither absorb nor send on, where the scene is closed and all rows are
  // kept: what row sums off 1, or factors that are not reciprocal, lose or win.
  double energy_error = 0;
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

struct SolveOptions {
  int threads = 1;  // nothing but the time depends on them
  // Told before the form factors are computed: how many rows will be kept, in what memory.
  std::function<void(const MatrixPlan&)> announce;
  // Where the form factors come from. Null: form_factor_method() without OpenGL.
  std::function<FormFactorMethod(const Patches&, const Radiosity&)> method;
};

// Patches, form factors, the linear system and the elements' light. Of `earlier`, which may be null, it takes the form
// factors where geometry and method are the same, and all where nothing changed. Progress runs from 0 to 1 in each
// phase. Throws Cancelled (within 100 ms; `earlier` stays what it is), and InputError where the scene has no face, a
// reflectance is above 1, or the solver cannot have so many patches.
SolutionHandle solve_radiosity(const Scene& scene, const Radiosity& options, const SolutionHandle& earlier,
                               Progress& progress, const SolveOptions& how = {});

// As the techniques draw it. The solution was made of `scene`.
RadiosityHandle drawable(const Scene& scene, const RadiositySolution& solution);

// F from one object to another, indices into Scene::objects: the mean over the patches of the first, weighted by area,
// of the factors to all patches of the second. 0 where either has no patch; rows that are not kept are computed. Throws
// Cancelled.
double form_factor(const RadiositySolution& solution, std::uint32_t from, std::uint32_t to, const Progress& progress);

// Of each of the first `objects` of Scene::objects: its patches' area, and their B over pi, the mean by area; 0
// without.
struct ObjectLight {
  double area = 0;
  glm::dvec3 radiosity{0};
};
std::vector<ObjectLight> mean_radiosity(const RadiositySolution& solution, std::size_t objects);

}  // namespace cg
