// The dialogues: open, save, save a picture. One line to type a path, and a list to choose from.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

#include "scene/shape.h"
#include "ui/app.h"
#include "ui/export_dialogue.h"
#include "ui/layout.h"
#include "ui/widgets.h"
#include "workbench/environment.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

void close(App& app) {
  app.dialogue = {};
  ImGui::CloseCurrentPopup();
}

// Names as buttons, line by line; the one that was pressed.
std::string pick_name(App& app, const Words& title, const std::vector<std::pair<std::string, std::string>>& names) {
  if (names.empty()) return {};
  heading(app, title.in(app.language()));
  std::string picked;
  const float left = ImGui::GetCursorScreenPos().x, room = app.look.px(520);
  float x = 0;
  ImGui::PushID(title.en.data());
  for (const auto& [what, label] : names) {
    const float w = button_width(app, noted(app, label));
    if (x > 0 && x + w <= room)
      ImGui::SameLine(0, app.look.px(6));
    else
      x = 0;
    ImGui::PushID(what.c_str());
    if (button(app, "name", {.label = label})) picked = what;
    ImGui::PopID();
    x += w + app.look.px(6);
  }
  ImGui::PopID();
  (void)left;
  return picked;
}

void draw_open(App& app) {
  const Language l = app.language();
  std::string picked;
  if (path_field(app, {"A model file, a preset or a name; or drop a file on the window",
                       "モデルファイル・プリセット・名前（ウィンドウへのドロップも可）"}) &&
      !app.dialogue.text.empty())
    picked = typed_path(app.dialogue.text).string();
  std::vector<std::pair<std::string, std::string>> names;
  for (const Shape& s : shapes()) names.emplace_back(std::string(s.id), std::string(s.label.in(l)));
  if (auto p = pick_name(app, {"Shapes", "基本の形"}, names); !p.empty()) picked = p;
  names.clear();
  for (const std::string& m : app.bundled) names.emplace_back(m, m);
  if (auto p = pick_name(app, {"Models", "モデル"}, names); !p.empty()) picked = p;
  names.clear();
  for (const std::string& r : app.recent)
    if (r.find('/') != std::string::npos) names.emplace_back(r, std::filesystem::path(r).filename().string());
  if (auto p = pick_name(app, {"Recent files", "最近のファイル"}, names); !p.empty()) picked = p;
  if (picked.empty()) return;
  open_in_window(app, picked);
  close(app);
}

void draw_save(App& app) {
  const bool entered = save_field(app, {"scene.json", "scene.json"});
  ImGui::Dummy({1, app.look.px(4)});
  if ((button(app, "save", {.label = Words{"Save", "保存"}.in(app.language())}) || entered) &&
      !app.dialogue.text.empty()) {
    save_as(app, typed_path(app.dialogue.text));
    close(app);
  }
}

}  // namespace

bool path_field(App& app, const Words& hint, float width) {
  ImGui::SetNextItemWidth(app.look.px(width));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const std::string shown(noted(app, hint));
  // The field leaves out what is pressed in the frame in which it becomes active.
  const bool early = !ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  return ImGui::InputTextWithHint("##path", shown.c_str(), &app.dialogue.text,
                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll) ||
         early;
}

bool save_field(App& app, const Words& hint, float width) {
  const bool entered = path_field(app, hint, width);
  const std::filesystem::path file = typed_path(app.dialogue.text);
  const std::string folder = shown_path(file.has_parent_path() ? file.parent_path() : std::filesystem::path("."));
  heading(app, Text("in " + folder, "フォルダ: " + folder).in(app.language()));
  return entered;
}

void draw_dialogues(App& app) {
  Dialogue& d = app.dialogue;
  if (d.kind != Dialogue::none && d.fresh) ImGui::OpenPopup("dialogue");
  d.fresh = false;
  const ImVec2 size = ImGui::GetWindowSize();
  ImGui::SetNextWindowPos({0.5f * size.x, app.look.px(70)}, 0, {0.5f, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {app.look.px(24), app.look.px(20)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), app.look.px(8)});
  if (ImGui::BeginPopup("dialogue", ImGuiWindowFlags_NoMove)) {
    switch (d.kind) {
      case Dialogue::open:
        draw_open(app);
        break;
      case Dialogue::save:
        draw_save(app);
        break;
      case Dialogue::picture:
        if (draw_picture_dialogue(app)) close(app);
        break;
      case Dialogue::export_scene:
        if (draw_export_dialogue(app)) close(app);
        break;
      case Dialogue::trade:
        if (draw_trade_dialogue(app)) close(app);
        break;
      case Dialogue::save_solution:
      case Dialogue::open_solution:
        if (draw_solution_dialogue(app)) close(app);
        break;
      case Dialogue::none:
        ImGui::CloseCurrentPopup();
        break;
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) close(app);
    ImGui::EndPopup();
  } else {
    d = {};
  }
  ImGui::PopStyleVar(2);
}

}  // namespace cg
