// A patch as lines over the picture.
#pragma once
#include "radiosity/patches.h"
#include "workbench/overlay.h"

namespace cg {

// Its outline, as `mark`.
Lines patch_lines(const Patch& patch, Mark mark);

}  // namespace cg
