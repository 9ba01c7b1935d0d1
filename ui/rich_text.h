// Running text with words in other faces and formulas between them, set in lines.
#pragma once
#include <span>

#include "ui/formula.h"
#include "workbench/lesson_text.h"

namespace cg {

struct App;

// The faces of a text, and how far apart its lines stand (pixels).
struct RichStyle {
  ImFont *text, *bold, *mono;
  TypeSize math;
  float line;
  ImU32 colour;
};
RichStyle body_style(const App& app);
RichStyle formula_style(const App& app);  // of a formula on a line of its own

// Sets `runs` at ImGui's cursor in lines as wide as the room there is, less `indent` pixels on the left, and moves the
// cursor below. A quantity in a formula has its colour; the mouse on it lights the quantity everywhere.
void set_runs(App& app, std::span<const TextRun> runs, const RichStyle& style, float indent = 0);

}  // namespace cg
