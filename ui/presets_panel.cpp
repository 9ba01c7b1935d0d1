// Two presets, A and B, and what differs between them.
#include "ui/layout.h"

namespace cg {

void draw_presets_panel(App&) {}

}  // namespace cg
