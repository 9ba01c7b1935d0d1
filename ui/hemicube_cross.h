// The pictures of the panel of the hemicube: the five faces unfolded, and the hemisphere with its shadow.
#pragma once
#include <imgui.h>

#include "ui/hemicube_desk.h"

namespace cg {

struct App;

// The pixel of the hemicube under the mouse.
struct PointedPixel {
  int x = -1, y = -1;  // of the cross; -1: none
};

// A square of `side` pixels at ImGui's cursor. Points at what the mouse is on; a click chooses that patch as the one
// seen, a double click as the one whose hemicube is shown.
PointedPixel draw_hemicube_cross(App& app, HemicubeDesk& desk, float side);
// The same of Nusselt's projection, `height` high; a drag turns it.
PointedPixel draw_nusselt(App& app, HemicubeDesk& desk, float side, float height);

// The patch whose hemicube it is, and the one that is asked about, in the panel.
ImU32 own_ink(const App& app);
ImU32 other_ink(const App& app);

// "118 floor"
std::string patch_name(const App& app, const HemicubeGround& ground, std::uint32_t patch);

}  // namespace cg
