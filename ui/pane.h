// The middle of the window: the two pictures.
#pragma once
#include <imgui.h>

namespace cg {

struct App;

// Draws the panes at ImGui's cursor into `size` pixels (either may be 0).
void draw_panes(App& app, ImVec2 size);

}  // namespace cg
