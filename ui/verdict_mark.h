// The sign of a verdict, in a list: its shape tells it as well as its colour.
#pragma once
#include <imgui.h>

#include <optional>

#include "measure/extreme_run.h"

namespace cg {

struct App;

// With its middle at `c`; nothing: not checked yet.
void draw_verdict_mark(const App& app, ImVec2 c, std::optional<Verdict> verdict);

// Of the results of one case what is to be known first: a failure, then a driver's fault, then right.
std::optional<Verdict> worst_of(std::span<const ExtremeResult> results);

}  // namespace cg
