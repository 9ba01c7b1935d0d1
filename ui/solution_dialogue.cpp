// The dialogues that save the solution of the scene's radiosity, and take one from a file in its place.
#include <imgui.h>

#include <filesystem>

#include "radiosity/solution_file.h"
#include "ui/app.h"
#include "ui/layout.h"
#include "ui/radiosity_desk.h"
#include "ui/widgets.h"
#include "workbench/environment.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

void save(App& app, const SolutionHandle& solution, fs::path file) {
  if (file.extension() != ".ply") file += ".ply";
  app.errands->run(app, [solution, file]() -> Errands::Done {
    save_solution(*solution, file);
    return [file](App& a) { say_saved(a, file); };
  });
}

// The solution's parameters come with it: it stays until one of them, or the scene, is changed.
void take(App& app, const SceneRadiosity& solution, const std::string& name) {
  app.history.end_gesture();
  app.scene.radiosity = solution.solution->options;
  app.scene.shading.ambient_source = AmbientSource::radiosity;
  desk_of(app).take(app.scene, solution);
  say(app, Text("The light of " + name + " is drawn: " + solution.field->summary.en,
                name + " の光を表示しています：" + solution.field->summary.ja));
  for (const Text& note : solution.solution->notes) say(app, note);
}

void open(App& app, const fs::path& file) {
  app.errands->run(app, [file, scene = app.scene]() mutable -> Errands::Done {
    load_meshes(scene);
    Progress progress;
    SceneRadiosity solution;
    solution.solution = read_solution(file, scene, progress);
    solution.field = drawable(scene, *solution.solution);
    return [solution, name = file.filename().string(), scene](App& a) {
      if (same_places(radiosity_inputs(scene), a.scene)) take(a, solution, name);
    };
  });
}

}  // namespace

bool draw_solution_dialogue(App& app) {
  const Language l = app.language();
  const bool saves = app.dialogue.kind == Dialogue::save_solution;
  const SolutionHandle solution = desk_of(app).state().newest.solution;
  if (saves && !solution) return true;
  heading(app, (saves ? Words{"Patches and radiosity as PLY: other viewers show it",
                              "パッチと放射輝度を PLY に保存（ほかのビューアでも見られる）"}
                      : Words{"A solution of this scene, as it was saved here", "ここで保存した、このシーンの解"})
                   .in(l));
  const bool entered =
      saves ? save_field(app, {"solution.ply", "solution.ply"}) : path_field(app, {"solution.ply", "solution.ply"});
  ImGui::Dummy({1, app.look.px(4)});
  const Words label = saves ? Words{"Save", "保存"} : Words{"Open", "開く"};
  if (!(button(app, "solution", {.label = label.in(l), .chosen = true}) || entered) || app.dialogue.text.empty())
    return false;
  saves ? save(app, solution, typed_path(app.dialogue.text)) : open(app, typed_path(app.dialogue.text));
  return true;
}

}  // namespace cg
