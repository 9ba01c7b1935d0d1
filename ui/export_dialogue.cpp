#include "ui/export_dialogue.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/lines.h"
#include "ui/opening.h"
#include "ui/widgets.h"
#include "workbench/environment.h"
#include "workbench/export.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> usual_names{"scene.json", "lighting.c", "scene.c", "scene.obj"};

// What it is for, and what there is to do with it.
Words use_of(ExportFormat format) {
  switch (format) {
    case ExportFormat::json:
      return {"What differs from the defaults: to come back to, to hand in, to grade.",
              "既定値と違うところだけの記録。後で開く、提出する、採点するときに。"};
    case ExportFormat::c:
      return {"C functions to call from a program that you have already.", "手元のプログラムから呼び出す C の関数。"};
    case ExportFormat::glut:
      return {"A whole program that draws this scene, and its meshes beside it as OBJ.",
              "このシーンを描くプログラム全体。形は OBJ として隣に保存する。"};
    case ExportFormat::obj:
      return {"The meshes alone, with their normals.", "形だけを法線とともに保存する。"};
  }
  return {};
}

// What the toast says after where it went.
Text afterwards(ExportFormat format, const std::string& file) {
  const std::string word = fs::path(file).stem().string();
  const std::string compile = "cc -o " + word + " " + fs::path(file).filename().string() + " -lglut -lGLU -lGL -lm";
  switch (format) {
    case ExportFormat::glut:
      return {". With freeglut3-dev: " + compile, "。freeglut3-dev があれば: " + compile};
    case ExportFormat::c:
      return {". Call its functions from your display()", "。display() から関数を呼び出してください"};
    default:
      return {};
  }
}

void save(App& app, ExportFormat format, const std::string& file) {
  app.errands->run(app, [scene = app.scene, format, file, language = app.language()]() -> Errands::Done {
    save_export(scene, format, file, language);
    return [format, file](App& a) { say_saved(a, file, afterwards(format, file)); };
  });
}

void copy(App& app, ExportFormat format) {
  app.errands->run(app, [scene = app.scene, format, language = app.language()]() -> Errands::Done {
    auto text = std::make_shared<std::string>(export_text(scene, format, language));
    return [format, text](App& a) {
      ImGui::SetClipboardText(text->c_str());
      const Text more = afterwards(format, usual_names[std::size_t(format)]);
      say(a, Text("Copied to the clipboard" + (format == ExportFormat::glut ? more.en : std::string()),
                  "クリップボードにコピーしました" + (format == ExportFormat::glut ? more.ja : std::string())));
    };
  });
}

// The formats as buttons; a name that was not changed follows.
void choose_format(App& app) {
  Dialogue& d = app.dialogue;
  for (int i = 0; i < int(names_of<ExportFormat>.size()); ++i) {
    if (i > 0) ImGui::SameLine(0, app.look.px(6));
    ImGui::PushID(i);
    if (button(app, "format",
               {.label = names_of<ExportFormat>[std::size_t(i)].label.in(app.language()), .chosen = d.format == i})) {
      if (d.text.empty() || d.text == usual_names[std::size_t(d.format)])
        d.text = usual_names[std::size_t(i)];
      else
        d.text = fs::path(d.text).replace_extension(fs::path(usual_names[std::size_t(i)]).extension()).string();
      d.format = i;
    }
    ImGui::PopID();
  }
}

}  // namespace

bool draw_export_dialogue(App& app) {
  Dialogue& d = app.dialogue;
  const Language l = app.language();
  d.format = std::clamp(d.format, 0, int(usual_names.size()) - 1);
  if (d.text.empty() && ImGui::IsWindowAppearing()) d.text = usual_names[std::size_t(d.format)];
  choose_format(app);
  const ExportFormat format = ExportFormat(d.format);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + app.look.px(560));
  write(app, use_of(format));
  ImGui::PopTextWrapPos();
  const bool entered = save_field(app, Words{}, 560);
  ImGui::Dummy({1, app.look.px(4)});
  if ((button(app, "save", {.label = Words{"Save", "保存"}.in(l), .chosen = true}) || entered) && !d.text.empty()) {
    save(app, format, typed_path(d.text).string());
    return true;
  }
  ImGui::SameLine(0, app.look.px(6));
  if (button(app, "copy", {.label = Words{"Copy to the clipboard", "クリップボードにコピー"}.in(l)})) {
    copy(app, format);
    return true;
  }
  return false;
}

}  // namespace cg
