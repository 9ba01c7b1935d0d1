// A lesson: the list of lessons, or the step that is open, with its text, its tasks and the parameters it offers.
#include <algorithm>
#include <array>

#include "ui/actions.h"
#include "ui/app.h"
#include "ui/challenge_game.h"
#include "ui/layout.h"
#include "ui/lecture.h"
#include "ui/lesson_blocks.h"
#include "ui/lesson_panel.h"
#include "ui/lesson_player.h"
#include "ui/lines.h"
#include "ui/parameter.h"
#include "ui/rich_text.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// The lesson's own files by their names alone.
void error_text(App& app, const InputError& error, const std::filesystem::path& folder) {
  std::string text = error.message(app.language());
  const std::string before = (folder / "").string();
  for (std::size_t at = text.find(before); at != text.npos; at = text.find(before)) text.erase(at, before.size());
  small_text(app, text, app.look.palette.error);
  ImGui::Dummy({1, app.look.px(4)});
}

// "01-light-model" begins with its number.
std::string number_of(const std::string& id) {
  const std::size_t digits = std::min(id.find_first_not_of("0123456789"), id.size());
  return id.substr(0, digits);
}

void draw_entry(App& app, LessonPlayer& player, const LessonEntry& entry) {
  Look& look = app.look;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = std::max(1.0f, ImGui::GetContentRegionAvail().x), h = look.px(50), in = look.px(38);
  ImGui::PushID(entry.folder.c_str());
  const bool pressed = ImGui::InvisibleButton("lesson", {room, h});
  ImGui::PopID();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered())
    draw->AddRectFilled({at.x - look.px(6), at.y}, {at.x + room, at.y + h}, look.palette.raised, look.px(4));
  const Language l = app.language();
  const std::string steps = std::to_string(entry.steps);
  const Text below = entry.steps == 1 ? Text{"1 step", "1 ステップ"} : Text{steps + " steps", steps + " ステップ"};
  set_text(draw, look.fonts.mono, {at.x, at.y + look.px(22)}, look.palette.dim, number_of(entry.id));
  draw->PushClipRect({at.x, at.y}, {at.x + room, at.y + h}, true);
  set_text(draw, look.fonts.text, {at.x + in, at.y + look.px(22)}, look.palette.text, noted(app, entry.title.in(l)));
  set_text(draw, look.fonts.small, {at.x + in, at.y + look.px(41)}, entry.error ? look.palette.error : look.palette.dim,
           noted(app, entry.error ? Text{"cannot be read", "読めない"}.in(l) : below.in(l)));
  draw->PopClipRect();
  if (pressed) player.open(entry.folder);
}

void draw_list(App& app, LessonPlayer& player) {
  if (player.list().empty())
    small_text(app, Words{"No lessons were found.", "授業が見つからない。"}.in(app.language()), app.look.palette.dim);
  for (const LessonEntry& entry : player.list()) draw_entry(app, player, entry);
  ImGui::Dummy({1, app.look.px(14)});
  draw_lecture_log(app);
}

// Back to the list, the step's number, and the arrows.
void draw_head(App& app, LessonPlayer& player) {
  Look& look = app.look;
  const Language l = app.language();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  if (button(app, "list",
             {.label = Words{"‹ Lessons", "‹ 一覧"}.in(l), .tip = {"All lessons", "授業の一覧"}, .quiet = true})) {
    player.refresh_list();
    player.close();
    return;
  }
  const Action& back = action(Do::previous_step);
  const Action& on = action(Do::next_step);
  const std::string where =
      player.lesson() ? std::to_string(player.step() + 1) + " / " + std::to_string(player.lesson()->steps.size()) : "…";
  const float arrow = button_width(app, "◀"), text = text_width(look.fonts.mono, where);
  float x = at.x + room - 2 * arrow - text - look.px(16);
  ImGui::SetCursorScreenPos({x, at.y});
  if (button(app, "back",
             {.label = "◀", .tip = back.label, .shortcut = back.keys, .enabled = player.has_previous(), .quiet = true}))
    perform(app, Do::previous_step);
  x += arrow + look.px(8);
  set_text(ImGui::GetWindowDrawList(), look.fonts.mono, {x, at.y + look.px(22)}, look.palette.text, where);
  ImGui::SetCursorScreenPos({x + text + look.px(8), at.y});
  if (button(app, "on",
             {.label = "▶", .tip = on.label, .shortcut = on.keys, .enabled = player.has_next(), .quiet = true}))
    perform(app, Do::next_step);
  ImGui::SetCursorScreenPos({at.x, at.y + look.px(40)});
}

// Opens the panel that the step speaks of.
void draw_panel_button(App& app, const std::string& panel) {
  for (std::size_t i = 0; i < names_of<Side>.size(); ++i) {
    if (panel.empty() || names_of<Side>[i].id != panel) continue;
    const std::string label = std::string(Words{"Panel: ", "パネル："}.in(app.language())) +
                              std::string(names_of<Side>[i].label.in(app.language()));
    if (button(app, "panel",
               {.label = label, .tip = {"The text comes back with the tab Lesson", "本文には「授業」のタブで戻る"}}))
      app.settings.side = Side(int(i));
    ImGui::Dummy({1, app.look.px(4)});
  }
}

void draw_text(App& app, LessonPlayer& player, bool presenting) {
  const Language l = app.language();
  if (player.error()) error_text(app, *player.error(), player.folder());
  const LessonStep* step = player.current();
  if (!step) return;
  std::size_t questions = 0;
  const TextOfNumber number = [&](std::string_view name) { return player.number(name, app.scene); };
  if (player.step() == 0 && !presenting)
    draw_blocks(app, player, filled(player.lesson()->in(l).blocks, number), questions);
  const TextRun title{TextRun::strong, step->in(l).title};
  set_runs(app, std::span(&title, 1), body_style(app));
  ImGui::Dummy({1, app.look.px(4)});
  if (!presenting) draw_panel_button(app, step->view.panel);
  draw_blocks(app, player, filled(step->in(l).blocks, number), questions);
}

// "lights.0" stands for all of its slots.
bool offers(const std::string& offered, const std::string& path) {
  return path == offered || (path.starts_with(offered) && path[offered.size()] == '.');
}

// Of the challenge while it is played, else of the lesson's step.
std::vector<std::string> offered_paths(App& app) {
  if (app.challenge && app.challenge->playing() && app.settings.side == Side::challenge)
    return app.challenge->offered();
  const LessonStep* step = lessons_of(app).current();
  return step ? step->offered : std::vector<std::string>{};
}

// The "1" of "lights.1.position".
std::string index_in(const std::string& path) {
  const std::size_t dot = path.find('.');
  return path.substr(dot + 1, path.find('.', dot + 1) - dot - 1);
}

// What a path belongs to, as a heading: "LIGHT0", "Object 3: left-wall", "Material", "Shading".
std::string group_of(const std::string& path, const Scene& scene, Language language) {
  const std::string first = path.substr(0, path.find('.'));
  if (first == "lights") return std::string(Words{"Light", "光源"}.in(language)) + " LIGHT" + index_in(path);
  if (first == "objects") {
    const std::size_t i = std::size_t(std::atoi(index_in(path).c_str()));
    const std::string name = i < scene.objects.size() ? scene.objects[i].name : "";
    const std::string number = std::string(Words{"Object", "物体"}.in(language)) + " " + index_in(path);
    return name.empty() ? number : number + std::string(Words{": ", "："}.in(language)) + name;
  }
  std::string label;
  std::apply(
      [&](const auto&... f) { ((f.about.name == first ? void(label = f.about.label.in(language)) : void()), ...); },
      fields_of<Scene>);
  return label;
}

// In the text's window.
void turn_page(App& app, Reading& reading) {
  reading.at = ImGui::GetScrollY(), reading.most = ImGui::GetScrollMaxY(), reading.page = ImGui::GetWindowHeight();
  if (reading.turn == 0) return;
  const float step = std::max(reading.page - app.look.px(40), app.look.px(40));  // a line stays in sight
  ImGui::SetScrollY(std::clamp(reading.at + float(reading.turn) * step, 0.0f, reading.most));
  reading.turn = 0;
  app.animating = true;
}

void draw_row(App& app, const Slot& slot) {
  if (!slot.path.ends_with(".tessellation")) return parameter(app, slot);
  const std::size_t object = std::size_t(std::atoi(index_in(slot.path).c_str()));
  if (object < app.scene.objects.size()) tessellation(app, slot, app.scene.objects[object]);
}

}  // namespace

void draw_lesson_step(App& app, bool presenting) {
  LessonPlayer& player = lessons_of(app);
  const LessonStep* step = player.current();
  const bool offered = presenting && step && !step->offered.empty();
  const float room = ImGui::GetContentRegionAvail().y;
  ImGuiStorage* store = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID("offered height");
  const float below = offered ? std::min(store->GetFloat(key, app.look.px(40)), room * 0.5f) : 0;
  const std::string id = "text of " + player.place();  // each step is read from its beginning
  ImGui::BeginChild(id.c_str(), {0, std::max(1.0f, room - below)});
  draw_text(app, player, presenting);
  if (presenting) turn_page(app, player.reading);
  ImGui::EndChild();
  if (!offered) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(
      {at.x, at.y}, {at.x + ImGui::GetContentRegionAvail().x, at.y + app.look.px(1)}, app.look.palette.line);
  ImGui::BeginChild("offered", {0, 0});
  ImGui::Dummy({1, app.look.px(2)});
  draw_offered_parameters(app);
  const float height = ImGui::GetCursorPosY() + app.look.px(6);
  ImGui::EndChild();
  if (height != store->GetFloat(key)) {
    store->SetFloat(key, height);
    app.animating = true;
  }
}

bool draw_offered_parameters(App& app) {
  const std::vector<std::string> wanted = offered_paths(app);
  if (wanted.empty()) return false;
  const Slots all = slots(app.scene);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), app.look.px(4)});
  std::string last;
  for (const std::string& offered : wanted)
    for (const Slot& slot : all) {
      if (!offers(offered, slot.path)) continue;
      const std::string group = group_of(slot.path, app.scene, app.language());
      const bool says_it_itself = slot.about->symbol.empty() && slot.about->label.in(app.language()) == group;
      if (group != last && !says_it_itself) heading(app, noted(app, group));
      last = group;
      draw_row(app, slot);
    }
  ImGui::PopStyleVar();
  return true;
}

void draw_lesson_panel(App& app) {
  LessonPlayer& player = lessons_of(app);
  if (!player.is_open()) return draw_list(app, player);
  draw_head(app, player);
  draw_lesson_step(app, false);
}

}  // namespace cg
