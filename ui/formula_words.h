// Formulas inside a sentence of plain text, found by their looks: the help of a parameter says "I_r" and "(N·H)^n".
#pragma once
#include <string_view>
#include <vector>

#include "workbench/lesson_text.h"

namespace cg {

// `text` as runs, plain and formulas, which together are `text`. A word with an index of one letter or with an exponent
// is a formula, and a sign or a letter beside one belongs to it; GL_NORMALIZE is none.
std::vector<TextRun> formula_runs(std::string_view text);

}  // namespace cg
