// Words and knobs over the view from outside.
#pragma once
#include <imgui.h>

#include <string_view>

#include "ui/probe_jobs.h"

namespace cg {

struct App;

// Width / height of the pictures that the scene's camera makes.
double aspect_of(const App& app);
// The probe whose numbers are shown; null: none.
const Probed* shown_probed(const App& app);

void mark_word(App& app, ImVec2 at, std::string_view text);
// A ring; `full`: with a dot in it.
void mark_knob(App& app, ImVec2 at, float radius, bool full, bool held);

}  // namespace cg
