#include "ui/lines.h"

#include "ui/app.h"
#include "ui/formula.h"

namespace cg {

void pair_line(App& app, std::string_view left, std::string_view right, ImU32 colour) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(19);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.text, {at.x, baseline}, colour, noted(app, left));
  const float w = text_width(look.fonts.mono, noted(app, right));
  set_text(draw, look.fonts.mono, {at.x + room - w, baseline}, colour, right);
  ImGui::Dummy({room, look.px(22)});
}

void small_text(App& app, std::string_view text, ImU32 colour) {
  ImGui::PushFont(app.look.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  write(app, text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

}  // namespace cg
