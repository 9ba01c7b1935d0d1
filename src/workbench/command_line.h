// The program's command line: render, compare and plan without a window, or the window.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/technique.h"
#include "workbench/commands.h"

namespace cg {

// What a start of the window asks for.
struct WindowOptions {
  std::string scene;             // a shape, a model file, a preset; empty: the last session, or the first shape
  int width = 0, height = 0;     // 0: the last session's, or what fits the monitor
  double scale = 0;              // 0: the monitor's
  std::string screenshot;        // a file: drawn when both pictures are there, then the window closes
  std::vector<std::string> set;  // "path=value" of the window's settings
  bool keep_session = true;      // read it at the start, write it while running
  bool times = false;            // print what the start and the frames took, to stderr
  std::string state;             // a file that says what the window shows, for a test; empty: none
  double measure = 0;            // seconds of a scripted drag of a slider; prints its figures, then the window closes
  MakeDrawItems draw_items;      // as Arguments'
};

// Runs the window and returns the exit status; throws InputError where there is no display.
using OpenWindow = std::function<int(const WindowOptions&)>;

// The whole program: parses, runs, reports. With no command it opens the window; where there is no display it draws the
// scene by OpenGL and in software instead and prints the comparison. Errors are one line on stderr in the language of
// the environment. `others`: commands of other rooms. `draw_items`: who draws radiosity's hemicubes by OpenGL. Returns
// the exit status: 0 done, 1 a check failed, 2 the user's input was wrong.
int run_command_line(int argc, char** argv, const std::vector<Technique>& techniques, const OpenWindow& open_window,
                     const std::vector<CommandOffer>& others = {}, const MakeDrawItems& draw_items = {});

}  // namespace cg
