// Shadebench's main(): the command line, with OpenGL among its techniques and a window to open.
#include "gl/hemicube_items.h"
#include "gl/techniques.h"
#include "measure/commands.h"
#include "raster/software.h"
#include "ui/window.h"

int main(int argc, char** argv) {
  std::vector<cg::Technique> techniques = cg::gl_techniques();
  techniques.push_back(cg::software_technique());
  return cg::run_command_line(
      argc, argv, techniques, [&](const cg::WindowOptions& options) { return cg::run_window(techniques, options); },
      cg::measure_commands(), cg::gl_draw_items());
}
