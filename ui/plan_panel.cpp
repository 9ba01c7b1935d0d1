// What each technique does for this scene, and what it leaves out and why.
#include <cstdio>
#include <string>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/widgets.h"

namespace cg {
namespace {

std::string bytes_text(std::size_t n) {
  const double d = double(n);
  char buffer[32];
  if (n < 1000) return std::to_string(n) + " B";
  const char* unit = n < 1000000 ? "kB" : n < 1000000000 ? "MB" : "GB";
  const double v = n < 1000000 ? d / 1e3 : n < 1000000000 ? d / 1e6 : d / 1e9;
  std::snprintf(buffer, sizeof buffer, v < 9.95 ? "%.1f %s" : "%.0f %s", v, unit);
  for (char* p = buffer; *p; ++p)
    if (*p == ',') *p = '.';
  return buffer;
}

void draw_plan(App& app, const Plan& plan) {
  const Language l = app.language();
  const Palette& p = app.look.palette;
  std::string_view name = plan.technique;
  for (const Technique& t : app.techniques)
    if (t.id == plan.technique) name = t.name.in(l);
  ImGui::PushFont(app.look.fonts.bold);
  write(app, name);
  ImGui::PopFont();
  for (const bool needed : {true, false}) {
    bool any = false;
    for (const Pass& pass : plan.passes) any = any || pass.needed == needed;
    if (!any) continue;
    heading(app, (needed ? Words{"Runs", "必要なもの"} : Words{"Left out", "省いたもの"}).in(l));
    for (const Pass& pass : plan.passes) {
      if (pass.needed != needed) continue;
      pair_line(app, pass.name.in(l), needed && pass.bytes > 0 ? bytes_text(pass.bytes) : "", needed ? p.text : p.dim);
      small_text(app, pass.reason.in(l), p.dim);
    }
  }
  for (const Text& note : plan.notes) small_text(app, note.in(l), p.text);
  ImGui::Dummy({1, app.look.px(14)});
}

}  // namespace

void draw_plan_panel(App& app) {
  for (const Plan& plan : app.plans) draw_plan(app, plan);
  if (app.plans.empty())
    small_text(app,
               Words{"The plan comes with the first picture.", "計画は最初の絵とともに表示される。"}.in(app.language()),
               app.look.palette.dim);
}

}  // namespace cg
