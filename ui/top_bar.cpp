// The bar above: what is open, and what can be done with it.
#include <algorithm>
#include <filesystem>
#include <string>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lesson_panel.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// The models that stand in the scene, and the preset's file.
std::string title(const App& app) {
  std::vector<std::string> models;
  for (const Object& o : app.scene.objects) {
    const std::string name = std::filesystem::path(o.model).filename().string();
    if (std::find(models.begin(), models.end(), name) == models.end()) models.push_back(name);
  }
  std::string out = models.empty() ? "" : models[0];
  if (models.size() > 1) out += " + " + std::to_string(models.size() - 1);
  if (!app.preset.empty()) out = std::filesystem::path(app.preset).filename().string() + "  ·  " + out;
  return out;
}

// All of it; else the preset's file alone; else as much of that as there is room for, cut between characters (UTF-8).
std::string fitting_title(App& app, std::string name, float room) {
  const auto fits = [&](const std::string& text) { return text_width(app.look.fonts.text, noted(app, text)) <= room; };
  if (fits(name)) return name;
  if (!app.preset.empty()) name = std::filesystem::path(app.preset).filename().string();
  if (fits(name)) return name;
  while (!name.empty() && !fits(name + "…")) {
    while (name.size() > 1 && (static_cast<unsigned char>(name.back()) & 0xc0) == 0x80) name.pop_back();
    name.pop_back();
  }
  return name + "…";
}

struct Item {
  Do what;
  std::string label;
  bool chosen = false, enabled = true;
};

float width_of(App& app, const std::vector<Item>& items) {
  float w = 0;
  for (const Item& i : items) w += button_width(app, noted(app, i.label)) + app.look.px(4);
  return w;
}

void draw_items(App& app, const std::vector<Item>& items) {
  for (const Item& item : items) {
    const Action& a = action(item.what);
    const std::string keys(a.keys);
    ImGui::PushID(int(item.what));
    if (button(app, "do",
               {.label = item.label,
                .tip = a.label,
                .shortcut = keys,
                .chosen = item.chosen,
                .enabled = item.enabled,
                .quiet = true}))
      perform(app, item.what);
    ImGui::PopID();
    ImGui::SameLine(0, app.look.px(4));
  }
}

Item plain(const App& app, Do what) { return {what, std::string(action(what).label.in(app.language()))}; }

}  // namespace

void draw_top_bar(App& app) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float baseline = at.y + look.px(21.5f);
  float x = at.x;
  x += set_text(draw, look.fonts.bold, {x, baseline}, look.palette.text, "Shadebench") + look.px(20);

  const Language l = app.language();
  std::vector<Item> files{plain(app, Do::open), plain(app, Do::save), plain(app, Do::picture),
                          plain(app, Do::export_scene)};
  std::vector<Item> rest{{Do::undo, std::string(action(Do::undo).label.in(l)), false, app.history.can_undo()},
                         {Do::redo, std::string(action(Do::redo).label.in(l)), false, app.history.can_redo()},
                         {Do::lesson, std::string(action(Do::lesson).label.in(l)), app.settings.side == Side::lesson},
                         {Do::code, std::string(action(Do::code).label.in(l)), app.settings.code},
                         {Do::plan, std::string(action(Do::plan).label.in(l)), app.settings.side == Side::plan},
                         {Do::language, l == Language::english ? "日本語" : "English"},
                         {Do::present, std::string(action(Do::present).label.in(l))},
                         {Do::theme, "◐"},
                         {Do::help, "?"}};
  // In a narrow window what has a key goes first: beside a lesson's title the files; undo, redo, lesson, program, plan.
  const float wanted = lesson_place_width(app);
  if (wanted > 0 && x - at.x + wanted + width_of(app, files) + width_of(app, rest) > room) files.clear();
  while (wanted > 0 && rest.size() > 6 && x - at.x + wanted + width_of(app, rest) > room) rest.erase(rest.begin());
  const float files_w = width_of(app, files);
  while (rest.size() > 3 && x - at.x + files_w + width_of(app, rest) > room) rest.erase(rest.begin());
  const float rest_w = width_of(app, rest);
  const float place = draw_lesson_place(app, {x, at.y}, room - (x - at.x) - rest_w - files_w - look.px(16));
  if (place > 0) x += place + look.px(16);
  const std::string name = place > 0 ? std::string() : title(app);
  const float name_room = room - (x - at.x) - rest_w - files_w - look.px(32);
  if (!name.empty() && name_room > look.px(40)) {
    const std::string shown = fitting_title(app, name, name_room);
    set_text(draw, look.fonts.text, {x, baseline}, look.palette.dim, noted(app, shown));
    const float wide = text_width(look.fonts.text, shown);
    ImGui::SetCursorScreenPos({x, at.y});
    ImGui::InvisibleButton("title", {std::max(wide, 1.0f), look.px(32)});
    if (shown != name && wants_tooltip(app)) tooltip(app, {}, {}, name);
    x += wide + look.px(28);
  }
  ImGui::SetCursorScreenPos({x, at.y});
  draw_items(app, files);
  ImGui::SetCursorScreenPos({std::max(x, at.x + room - rest_w), at.y});
  draw_items(app, rest);
}

}  // namespace cg
