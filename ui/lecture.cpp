#include "ui/lecture.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <chrono>
#include <ctime>
#include <filesystem>

#include "ui/app.h"
#include "ui/lesson_player.h"
#include "ui/lines.h"
#include "ui/opening.h"
#include "ui/widgets.h"
#include "workbench/environment.h"
#include "workbench/isolate.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

LessonView view_of(const App& app) {
  const Settings& s = app.settings;
  const auto id = [&](int i) { return app.techniques[std::size_t(i)].id; };
  const int count = int(app.techniques.size());
  LessonView view;
  if (app.left >= 0 && app.left < count) view.left = id(app.left);
  if (app.right >= 0 && app.right < count) view.right = id(app.right);
  view.view = s.view;
  for (int term = 0; term < int(names_of<LightTerm>.size()); ++term)
    if (quantity_of(LightTerm(term)) == app.isolated.term) view.term = LightTerm(term);
  view.light = app.isolated.light;
  view.handles = s.handles, view.axes = s.axes, view.wireframe = s.wireframe, view.clamped = s.clamped;
  view.vertex_normals = s.vertex_normals, view.face_normals = s.face_normals;
  return view;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
  return text;
}

// Where lessons of one's own stand; the first name that is free.
fs::path free_folder() {
  const fs::path base = data_home_folder().value_or(fs::path(".")) / "lessons";
  std::error_code error;
  for (int i = 1; i < 1000; ++i) {
    const fs::path folder = base / ("lecture-" + today() + (i > 1 ? "-" + std::to_string(i) : ""));
    if (!fs::exists(folder, error)) return folder;
  }
  return base / "lecture";
}

void save(App& app, const fs::path& folder) {
  app.errands->run(app, [folder, entries = app.lecture->log.entries()]() -> Errands::Done {
    save_lecture(entries, folder, {"Lecture " + today(), "講義 " + today()});
    return [folder](App& a) {
      lessons_of(a).refresh_list();
      say_saved(a, folder);
    };
  });
}

}  // namespace

void note_lecture(App& app) {
  if (!app.lecture) app.lecture = std::make_shared<LectureDesk>();
  const bool held = app.gesture || app.sweep.item != 0 || (ImGui::IsMouseDown(0) && ImGui::IsAnyItemActive());
  app.lecture->log.note(app.scene, view_of(app), app.now, held || app.turntable);
}

void draw_lecture_log(App& app) {
  if (!app.lecture) return;
  std::optional<std::string>& folder = app.lecture->folder;
  const Language l = app.language();
  const std::size_t changes = app.lecture->log.entries().empty() ? 0 : app.lecture->log.entries().size() - 1;
  const std::string n = std::to_string(changes);
  heading(app, Words{"This lecture", "この講義の記録"}.in(l));
  small_text(app,
             Text("Changes since the start: " + n + ". Saved as a lesson, students step through them afterwards.",
                  "始めてからの変更は " + n + " 回。保存すると、学生があとでたどれる授業になる。")
                 .in(l),
             app.look.palette.dim);
  if (!folder) {
    if (button(app, "log", {.label = Words{"Save as a lesson…", "授業として保存…"}.in(l), .enabled = changes > 0})) {
      folder = free_folder().string();
      app.lecture->reveal = 3;  // the panel grows by what is drawn in the first of them
    }
    return;
  }
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool entered = ImGui::InputText("##lecture", &*folder, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::Dummy({1, app.look.px(2)});
  const bool pressed = button(app, "save log", {.label = Words{"Save", "保存"}.in(l)});
  ImGui::SameLine(0, app.look.px(6));
  const bool dropped = button(app, "keep log", {.label = Words{"Cancel", "やめる"}.in(l), .quiet = true});
  if (app.lecture->reveal > 0) {
    --app.lecture->reveal;
    ImGui::SetScrollHereY(1);
  }
  if ((entered || pressed) && !folder->empty()) save(app, *folder);
  if (entered || pressed || dropped) folder.reset();
}

}  // namespace cg
