// Stands in until the panes are there.
#include "ui/app.h"
#include "ui/pane.h"

namespace cg {

[[gnu::weak]] void draw_panes(App& app, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, app.look.palette.pane, 6);
  app.figures.valid = true;
}

}  // namespace cg
