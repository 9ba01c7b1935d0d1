// The command that computes the light of a scene by radiosity.
#pragma once
#include <span>

#include "workbench/commands.h"

namespace cg {

// Patches, form factors, the linear system: figures on stdout, the solution into a file. 1 where the solver diverges.
int run_radiosity(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
