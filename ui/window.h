// The window's life: opened, drawn when something changed, closed. The one file beside main.cpp that knows GLFW's
// event loop.
#pragma once
#include <algorithm>
#include <vector>

#include "scene/technique.h"
#include "ui/settings.h"
#include "workbench/command_line.h"

namespace cg {

// The seconds that a frame counts as: 1e-4 to 0.25, whatever was measured (0, a suspend, a clock set back, NaN).
inline float frame_time(float measured) { return measured > 1e-4f ? std::min(measured, 0.25f) : 1e-4f; }

// Opens the window and returns when it was closed: the program's exit status. Throws InputError where there is no
// display or no OpenGL 3.3.
int run_window(const std::vector<Technique>& techniques, const WindowOptions& options);

}  // namespace cg
