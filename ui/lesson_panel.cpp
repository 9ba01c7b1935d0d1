// A lesson: its text, the step's parameters, tasks and questions.
#include "ui/layout.h"

namespace cg {

void draw_lesson_panel(App&) {}

}  // namespace cg
