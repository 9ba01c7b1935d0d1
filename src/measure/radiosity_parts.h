// What the ladders of radiosity's knobs are made with.
#pragma once
#include "measure/knob.h"

namespace cg {

// The scene with so large patches that all pairs of them can be had by every setting. Throws InputError where one may
// hide another: the closed form of a pair is exact then.
Scene scene_of_few_patches(const TradeRequest& request);

// `x` is its label too.
Setting radiosity_setting(const Scene& scene, std::string id, double x, std::size_t series);

// Over all values: the root mean square of the errors over that of the values, and the largest over the largest.
Errors relative_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference);

}  // namespace cg
