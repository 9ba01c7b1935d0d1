// The numbers of the probed pixel, as the strip shows them under and beside the equation.
#pragma once
#include "ui/equation.h"
#include "ui/probe_jobs.h"

namespace cg {

// What is shown: the clicked picture's probe, or the other's where that one has none; null: nothing is known.
const Probe* shown_probe(const App& app);

// The rows under the equation: with the factors, and as a narrow strip has them; a row for each light where
// `most_rows` has room for them.
struct ProbeRows {
  std::vector<NumberRow> wide, narrow;
};
ProbeRows number_rows(const App& app, const Probe& probe, std::size_t most_rows);

// "Pixel (212, 148), left: OpenGL, fixed function, Gouraud".
std::string probe_title(const App& app, const Probe& probe);

// Below the rows: what clamping left and what is in the pictures; the factors of the selected light. What `size` has no
// room for is left out, the last first. Returns the height.
float draw_probe_results(App& app, const Probe& probe, ImVec2 at, ImVec2 size);

// In the line of the heading, from `left` to `right` (screen pixels): with Gouraud shading whose factors are shown, and
// with several lights which of them is drawn alone.
void draw_probe_choices(App& app, const Probe& probe, float left, float right, float baseline);

}  // namespace cg
