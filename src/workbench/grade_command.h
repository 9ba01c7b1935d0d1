// The command that grades a student's scene.
#pragma once
#include <span>

#include "workbench/commands.h"

namespace cg {

// STUDENT.json or STUDENT.c against --target: the score, the hint, one line a parameter that differs. 1 where the score
// is below --pass.
int run_grade(const Arguments& arguments, std::span<const Technique> techniques, Language language);

}  // namespace cg
