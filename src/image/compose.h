// Two pictures in one.
#pragma once
#include "image/display.h"

namespace cg {

// `left` in the first `at` (0..1) of the width and `right` in the rest, with a line between. Of one size.
Picture wipe(const Picture& left, const Picture& right, double at);

// Beside each other from the left, their tops level, a gap between.
Picture side_by_side(const std::vector<Picture>& pictures);

}  // namespace cg
