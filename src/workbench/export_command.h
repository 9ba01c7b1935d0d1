// shadebench export: the scene as a preset, as C, as a GLUT program, as OBJ.
#pragma once
#include <span>

#include "workbench/commands.h"

namespace cg {

// Writes the file (of a GLUT program: the OBJ beside it too).
int run_export(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
