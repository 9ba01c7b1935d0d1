// The blocks of a lesson's text, drawn: paragraphs, lists, listings, formulas, tasks, questions.
#pragma once
#include <vector>

#include "workbench/lesson_text.h"

namespace cg {

struct App;
class LessonPlayer;

// Draws `blocks` (numbers filled in) at ImGui's cursor. `questions` counts those that were drawn, so that each keeps
// its answer; pass 0 for a step's first blocks. `indent` pixels are left free on the left.
void draw_blocks(App& app, LessonPlayer& player, const std::vector<TextBlock>& blocks, std::size_t& questions,
                 float indent = 0);

}  // namespace cg
