// The patch whose hemicube is looked at, and the one that it sees, in the pictures of the scene.
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "ui/pane_place.h"
#include "workbench/overlay.h"

namespace cg {

struct App;

// Nothing where the panel of the hemicube is closed.
std::vector<Lines> hemicube_lines(const App& app);

// The patch at a pixel of the picture becomes the one whose hemicube is shown. False where the panel is closed.
bool choose_patch(App& app, const Place& place, const glm::dvec2& pixel);
// The mouse is on it: it is lit everywhere as the one that is seen.
void point_at_patch(App& app, const Place& place, const glm::dvec2& pixel);

}  // namespace cg
