// The window's life: opened, drawn when something changed, closed. The one file beside main.cpp that knows GLFW's
// event loop.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/technique.h"
#include "ui/settings.h"

namespace cg {

struct WindowOptions {
  std::string scene;             // a shape, a model file, a preset; empty: the last session, or the first shape
  int width = 0, height = 0;     // 0: the last session's, or what fits the monitor
  double scale = 0;              // 0: the monitor's
  std::string screenshot;        // a file (.ppm): drawn when both pictures are there, then the window closes
  std::vector<std::string> set;  // "path=value" of Settings
  bool keep_session = true;      // read it at the start, write it while running
  bool times = false;            // print what the start and the frames took, to stderr
};

// Opens the window and returns when it was closed: the program's exit status. Throws InputError where there is no
// display or no OpenGL 3.3.
int run_window(const std::vector<Technique>& techniques, const WindowOptions& options);

}  // namespace cg
