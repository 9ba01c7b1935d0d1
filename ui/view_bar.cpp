// Above the pictures: which technique draws each, and how the two are looked at.
#include <algorithm>
#include <string>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/layout.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// The techniques as a list; those that cannot work here stand in it with their reason.
void choose_technique(App& app, const char* id, int& chosen, float width) {
  if (app.techniques.empty()) return;
  chosen = std::clamp(chosen, 0, int(app.techniques.size()) - 1);
  const Language l = app.language();
  const std::string now(noted(app, app.techniques[std::size_t(chosen)].name));
  if (!begin_list(app, id, now.c_str(), width)) return;
  for (int i = 0; i < int(app.techniques.size()); ++i) {
    const Technique& t = app.techniques[std::size_t(i)];
    const std::optional<Text> why_not = t.unavailable   ? t.unavailable
                                        : t.unsupported ? t.unsupported(app.scene)
                                                        : std::nullopt;
    ImGui::PushID(i);
    if (ImGui::Selectable(std::string(noted(app, t.name)).c_str(), i == chosen,
                          t.unavailable ? ImGuiSelectableFlags_Disabled : 0))
      chosen = i;
    ImGui::PopID();
    if (why_not) {
      ImGui::PushFont(app.look.fonts.small);
      ImGui::PushStyleColor(ImGuiCol_Text, app.look.palette.dim);
      ImGui::PushTextWrapPos(width * 1.3f);
      write(app, why_not->in(l));
      ImGui::PopTextWrapPos();
      ImGui::PopStyleColor();
      ImGui::PopFont();
    }
  }
  ImGui::EndCombo();
}

constexpr Do actions_of_view[] = {Do::view_two, Do::view_wipe, Do::view_flip, Do::view_difference,
                                  Do::view_false_colour};

void view_buttons(App& app) {
  constexpr auto& modes = names_of<ViewMode>;
  for (int i = 0; i < int(modes.size()); ++i) {
    if (i > 0) ImGui::SameLine(0, app.look.px(2));
    const Action& a = action(actions_of_view[i]);
    ImGui::PushID(i);
    if (button(app, "mode",
               {.label = modes[std::size_t(i)].label.in(app.language()),
                .tip = a.label,
                .shortcut = a.keys,
                .chosen = int(app.settings.view) == i,
                .quiet = true}))
      perform(app, a.what);
    ImGui::PopID();
  }
}

void view_list(App& app, float width) {
  constexpr auto& modes = names_of<ViewMode>;
  const std::string now(modes[std::size_t(app.settings.view)].label.in(app.language()));
  if (!begin_list(app, "##view", now.c_str(), width)) return;
  for (int i = 0; i < int(modes.size()); ++i)
    if (ImGui::Selectable(std::string(noted(app, modes[std::size_t(i)].label)).c_str(), int(app.settings.view) == i))
      app.settings.view = ViewMode(i);
  ImGui::EndCombo();
}

}  // namespace

void draw_view_bar(App& app) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  if (!(room > look.px(60))) return;
  constexpr auto& modes = names_of<ViewMode>;
  float needed = 0;
  for (const Name& m : modes) needed += button_width(app, noted(app, m.label)) + look.px(2);
  const bool narrow = room - needed < look.px(350);  // then the ways to look are a list too
  if (narrow) needed = look.px(140);
  const float combo = std::clamp((room - needed - look.px(16)) * 0.5f, look.px(40), look.px(240));
  choose_technique(app, "##left", app.left, combo);
  ImGui::SetCursorScreenPos({at.x + (room - needed) * 0.5f, at.y});
  if (narrow)
    view_list(app, needed);
  else
    view_buttons(app);
  ImGui::SetCursorScreenPos({at.x + room - combo, at.y});
  choose_technique(app, "##right", app.right, combo);
  ImGui::SetCursorScreenPos({at.x, at.y + look.px(38)});
}

}  // namespace cg
