// The command that lays a model flat.
#pragma once
#include <span>

#include "workbench/commands.h"

namespace cg {

// Charts, flips, overlaps, distortion and time on stdout; the model with its uv, or the layout as a picture, into a
// file. All parts of a model share one texture.
int run_unwrap(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
