// What the ladders of radiosity's knobs are made with.
#pragma once
#include "measure/knob.h"
#include "radiosity/matrix.h"
#include "radiosity/patches.h"

namespace cg {

// The scene with so large patches that all pairs of them can be had by every setting. Throws InputError where one may
// hide another: the closed form of a pair is exact then.
Scene scene_of_few_patches(const TradeRequest& request);

// `x` is its label too.
Setting radiosity_setting(const Scene& scene, std::string id, double x, std::size_t series);

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

// Over all values: the root mean square of the errors over that of the values, and the largest over the largest.
Errors relative_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference);

}  // namespace cg
