// What each technique does for this scene and what that costs, what it leaves out and why, and what was kept when
// something changed.
#include <algorithm>
#include <string>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/widgets.h"
#include "workbench/measured_plan.h"

namespace cg {
namespace {

// The share of the picture's time that a pass takes, as a thin bar under its line.
void share_bar(App& app, double share) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = look.px(3);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + room, at.y + height}, look.palette.line, height / 2);
  const float width = room * float(std::clamp(share, 0.0, 1.0));
  if (width >= 1) draw->AddRectFilled(at, {at.x + width, at.y + height}, look.palette.accent, height / 2);
  ImGui::Dummy({room, look.px(5)});
}

// To the right of a line: its milliseconds, or the bytes of what is no work.
std::string figure_of(const MeasuredPass& line, Language l) {
  if (line.kept) return std::string(Words{"kept", "再利用"}.in(l));
  if (line.planned.kind == PassKind::pass) return ms_text(line.ms);
  return line.held > 0 ? size_text(line.held) : "";
}

void draw_line(App& app, const MeasuredPass& line, double all_ms) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  const Pass& pass = line.planned;
  const bool bytes_below = line.held > 0 && (line.kept || pass.kind == PassKind::pass);
  pair_line(app, pass.name.in(l), pass.needed ? figure_of(line, l) : "", pass.needed && !line.kept ? p.text : p.dim);
  if (line.ran && pass.kind == PassKind::pass && !line.kept) share_bar(app, all_ms > 0 ? line.ms / all_ms : 0);
  small_text(app, (bytes_below ? size_text(line.held) + Words{": ", "："}.in(l).data() : "") + pass.reason.in(l),
             p.dim);
}

// What changed since the picture before, and what of it could be kept.
void draw_change(App& app, const Drawing& drawing, const MeasuredPlan& m) {
  const Language l = app.language();
  if (!drawing.change.any()) return;
  std::string kept;
  for (const MeasuredPass& line : m.passes)
    if (line.kept)
      kept += std::string(kept.empty() ? "" : Words{", ", "、"}.in(l)) + std::string(line.planned.name.in(l));
  if (kept.empty()) kept = Words{"nothing", "なし"}.in(l);
  const Text changed = text_of(drawing.change);
  small_text(app, Text("Changed: " + changed.en + ".", "変わったもの：" + changed.ja + "。").in(l),
             app.look.palette.accent);
  small_text(app, Text("Kept: " + kept + ".", "再利用：" + kept + "。").in(l), app.look.palette.text);
}

void draw_lines(App& app, const MeasuredPlan& m, Words title, bool needed, PassKind first, PassKind last) {
  bool any = false;
  for (const MeasuredPass& line : m.passes) {
    const PassKind kind = line.planned.kind;
    if (line.planned.needed != needed || kind < first || kind > last) continue;
    if (!any) heading(app, title.in(app.language()));
    any = true;
    draw_line(app, line, m.ms);
  }
}

void draw_plan(App& app, const Drawing& drawing) {
  const Language l = app.language();
  const MeasuredPlan m = measured(*drawing.plan, drawing.frame);
  std::string_view name = m.plan.technique;
  for (const Technique& t : app.techniques)
    if (t.id == m.plan.technique) name = t.name.in(l);
  ImGui::PushFont(app.look.fonts.bold);
  write(app, name);
  ImGui::PopFont();
  pair_line(app, Words{"In all", "合計"}.in(l), ms_text(m.ms) + "  " + size_text(m.held()), app.look.palette.text);
  draw_change(app, drawing, m);
  draw_lines(app, m, {"Runs", "実行するもの"}, true, PassKind::pass, PassKind::pass);
  for (const CodeRun& code : m.code)
    small_text(app, code.parts + " (" + ms_text(code.compile_ms) + ")", app.look.palette.dim);
  draw_lines(app, m, {"Code that is used", "使うコード"}, true, PassKind::part, PassKind::part);
  draw_lines(app, m, {"Memory", "メモリー"}, true, PassKind::resource, PassKind::resource);
  draw_lines(app, m, {"Left out", "省いたもの"}, false, PassKind::pass, PassKind::resource);
  for (const Text& note : m.plan.notes) small_text(app, note.in(l), app.look.palette.text);
  for (const Text& d : m.differences) small_text(app, d.in(l), app.look.palette.error);
  ImGui::Dummy({1, app.look.px(14)});
}

}  // namespace

void draw_plan_panel(App& app) {
  bool any = false;
  for (const DrawingHandle& drawing : app.drawings) {
    if (!drawing || !drawing->plan) continue;
    // A coarse picture comes before a full one; its times are not worth a look.
    draw_plan(app, *drawing);
    any = true;
  }
  if (!any)
    small_text(app,
               Words{"The plan comes with the first picture.", "計画は最初の絵とともに表示される。"}.in(app.language()),
               app.look.palette.dim);
}

}  // namespace cg
