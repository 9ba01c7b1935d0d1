// A lesson's text as HTML: paragraphs, formulas in the colours of their quantities, questions with their answers.
#pragma once
#include <span>

#include "measure/html.h"
#include "params/field.h"
#include "params/words.h"
#include "workbench/lesson_text.h"

namespace cg {

// The class that a style sheet colours: "q-diffuse"; empty for none.
std::string_view class_of(Quantity quantity);

// Markup of ui/formula.h's typeset(): letters slanted, names of functions and digits upright, what stands behind _ and
// ^ lowered and raised.
Html formula_html(std::string_view markup);

Html runs_html(std::span<const TextRun> runs);

// `blocks` with their numbers filled in. A question shows its choices, the right ones marked, and its answer.
Html blocks_html(std::span<const TextBlock> blocks, Language language);

}  // namespace cg
