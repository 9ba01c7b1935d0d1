// The scene as OpenGL calls: the listing, each number dragged or typed in it.
#include "ui/layout.h"

namespace cg {

void draw_code_panel(App&) {}

}  // namespace cg
