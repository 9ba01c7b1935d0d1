// Classic errors, put in on purpose, and what they do.
#include "ui/layout.h"

namespace cg {

void draw_mistakes_panel(App&) {}

}  // namespace cg
