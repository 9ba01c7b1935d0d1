#include "ui/lines.h"

#include <algorithm>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/formula_words.h"
#include "ui/rich_text.h"

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

void small_pair_line(App& app, std::string_view left, std::string_view right, ImU32 colour) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, baseline = at.y + look.px(15), h = look.px(20);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(at, {at.x + room, at.y + h}, true);
  const float x = at.x + set_text(draw, look.fonts.small, {at.x, baseline}, look.palette.dim, noted(app, left));
  const float w = text_width(look.fonts.small_mono, noted(app, right));
  set_text(draw, look.fonts.small_mono, {std::max(x + look.px(8), at.x + room - w), baseline}, colour, right);
  draw->PopClipRect();
  ImGui::Dummy({room, h - ImGui::GetStyle().ItemSpacing.y});
}

void small_text(App& app, std::string_view text, ImU32 colour) {
  const Look& look = app.look;
  const Fonts& f = look.fonts;
  const float scale = f.small->FontSize / f.text->FontSize;
  const RichStyle style{f.small, f.bold, f.small_mono, {f.math, f.math_sub, scale, scale}, look.px(18), colour};
  set_runs(app, formula_runs(text), style);
}

}  // namespace cg
