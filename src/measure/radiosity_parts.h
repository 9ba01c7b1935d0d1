// What the ladders of radiosity's knobs are made with.
#pragma once
#include <functional>

#include "measure/knob.h"
#include "radiosity/matrix.h"
#include "radiosity/patches.h"
#include "radiosity/solver.h"

namespace cg {

// The scene with so large patches that all pairs of them can be had by every setting. Throws InputError where one may
// hide another: the closed form of a pair is exact then.
Scene scene_of_few_patches(const TradeRequest& request);

// `x` is its label too.
Setting radiosity_setting(const Scene& scene, std::string id, double x, std::size_t series);

// A setting for each value: `set` puts it into the scene's options; ids begin with `prefix`.
void add_settings(Ladder& out, Scene scene, const std::string& prefix, std::size_t series,
                  std::initializer_list<int> values, const std::function<void(Radiosity&, int)>& set);

// The closed form of all pairs, as a reference.
Setting closed_form_of(const Scene& scene);

// The factors of all pairs as a picture, row by row; what it cost is the rows alone.
Frame factors_of_all_pairs(const Setting& setting, std::span<const Technique> techniques, Progress& progress);

// What the knobs of form factors have in common.
Knob form_factor_knob();

// Of all pairs by closed form, rows normalised in a closed scene.
std::shared_ptr<const FormFactorMatrix> closed_form_matrix(const Patches& patches, Progress& progress);

// Values as a picture of one row.
ColourImage row_of_colours(const std::vector<glm::dvec3>& values);

// The four solvers that go by sweeps, by RadiositySolver, against LU: their series, the reference and the error.
inline constexpr std::size_t sweeping_solvers = 4;
Knob sweeping_knob();
// `add` gives the solver's settings: of a scene that has it chosen, ids beginning with its own.
Ladder sweeping_ladder(Scene scene,
                       const std::function<void(Ladder& out, Scene& scene, const std::string& solver)>& add);
// B of all patches by the setting's solver, which works as `run` says; what it cost is the solver alone.
Frame solved_light(const Setting& setting, const Radiosity& options, const std::function<void(Solver&)>& run,
                   Progress& progress);

// How far values are off: the root mean square of the errors over that of the values, and the largest over the largest.
class RelativeErrors {
 public:
  void add(const glm::dvec3& value, const glm::dvec3& exact);
  Errors errors() const;

 private:
  double off_ = 0, all_ = 0, farthest_ = 0, largest_ = 0;
  std::size_t count_ = 0;
};

// Over all values: the root mean square of the errors over that of the values, and the largest over the largest.
Errors relative_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference);

}  // namespace cg
