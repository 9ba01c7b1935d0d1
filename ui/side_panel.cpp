// The right side, opened when it is asked for: a row of tabs, and the panel that is chosen.
#include <algorithm>
#include <array>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/widgets.h"

namespace cg {
namespace {

struct Panel {
  Side side;
  void (*draw)(App&);
};
constexpr std::array panels{Panel{Side::lesson, draw_lesson_panel},       Panel{Side::world, draw_world_panel},
                            Panel{Side::mistakes, draw_mistakes_panel},   Panel{Side::presets, draw_presets_panel},
                            Panel{Side::challenge, draw_challenge_panel}, Panel{Side::plan, draw_plan_panel},
                            Panel{Side::mesh, draw_mesh_panel},           Panel{Side::trade, draw_trade_panel},
                            Panel{Side::extremes, draw_extremes_panel},   Panel{Side::solver, draw_solver_panel},
                            Panel{Side::hemicube, draw_hemicube_panel}};

// As many tabs in a line as fit.
void draw_tabs(App& app) {
  Look& look = app.look;
  const float gap = look.px(3), right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (const Panel& panel : panels) {
    const std::string_view label = noted(app, names_of<Side>[std::size_t(panel.side)].label);
    if (panel.side != panels[0].side && ImGui::GetItemRectMax().x + gap + tab_width(app, label) <= right)
      ImGui::SameLine(0, gap);
    ImGui::PushID(int(panel.side));
    if (tab(app, "tab", label, app.settings.side == panel.side)) app.settings.side = panel.side;
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::Dummy({1, look.px(6)});
}

}  // namespace

void draw_side_panel(App& app) {
  draw_tabs(app);
  const auto chosen =
      std::find_if(panels.begin(), panels.end(), [&](const Panel& p) { return p.side == app.settings.side; });
  if (chosen != panels.end()) chosen->draw(app);
}

}  // namespace cg
