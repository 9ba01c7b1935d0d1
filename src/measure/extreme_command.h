// The command `extremes`: the table of cases walked through the techniques, as text or JSON.
#pragma once
#include "measure/extreme_run.h"
#include "params/tree.h"
#include "workbench/commands.h"

namespace cg {

CommandOffer extremes_command();

// 0, or 1 where a result is off or broken.
int run_extremes_command(const Arguments& arguments, std::span<const Technique> techniques, Language language);

// {"cases": [...], "right": ..., ...}: every case with what is right there and what each gave.
Tree json_of(std::span<const ExtremeResult> results);

// A case and what each gave, in lines.
std::string text_of(const ExtremeCase& subject, std::span<const ExtremeResult> results, Language language);

}  // namespace cg
