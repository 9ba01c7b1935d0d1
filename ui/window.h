// The window's life: opened, drawn when something changed, closed. The one file beside main.cpp that knows GLFW's
// event loop.
#pragma once
#include <vector>

#include "scene/technique.h"
#include "ui/settings.h"
#include "workbench/command_line.h"

namespace cg {

// Opens the window and returns when it was closed: the program's exit status. Throws InputError where there is no
// display or no OpenGL 3.3.
int run_window(const std::vector<Technique>& techniques, const WindowOptions& options);

}  // namespace cg
