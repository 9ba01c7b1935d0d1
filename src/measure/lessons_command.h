// The command `lessons`.
#pragma once
#include "workbench/commands.h"

namespace cg {

// Lists them; with --check prints a line for each finding, with --report writes a page, 1 where something does not
// hold. SCENE is a lesson's name or folder; none: all that come with the program.
int run_lessons(const Arguments& arguments, std::span<const Technique> techniques, Language language);

CommandOffer lessons_command();

}  // namespace cg
