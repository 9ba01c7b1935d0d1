// Cuts a mesh into charts that lie flat with little distortion, without flips and without overlaps.
#pragma once
#include "mapping/flatten.h"

namespace cg {

// Adds to `cuts`: afterwards every chart is a disk whose conformal map is injective and within `options`' limit of area
// distortion (a single face aside). What is cut already stays so. As many threads as there are processors, with the
// same result for any number.
void cut_automatically(const UnwrapSurface& surface, const Unwrapping& options, EdgeCuts& cuts);

// Within the limits that a chart must keep.
bool lies_well(const FlatChart& chart, const Unwrapping& options);

}  // namespace cg
