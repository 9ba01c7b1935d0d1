#include "workbench/open.h"

#include "params/input_error.h"
#include "params/lists.h"
#include "workbench/data_folder.h"
#include "workbench/lesson.h"
#include "workbench/preset.h"
#include "workbench/texture_library.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

}  // namespace

Scene open_scene(const std::string& what, std::vector<Text>* notes) {
  if (const auto step = find_step(what)) return scene_of_step(read_lesson(step->folder), step->step);
  if (fs::path(what).extension() != ".json") return open_model(find_model(what), notes);
  std::error_code error;
  const fs::path bundled = data_folder() / what;
  return read_preset(!fs::exists(what, error) && fs::exists(bundled, error) ? bundled : fs::path(what));
}

void set_parameter(Scene& scene, const std::string& path_and_value) {
  const std::size_t equals = path_and_value.find('=');
  if (equals == path_and_value.npos)
    throw InputError(path_and_value, {"there is no value", "値がありません"},
                     {"write path=value: material.k_d=0.5", "material.k_d=0.5 のように書いてください"});
  const std::string path = path_and_value.substr(0, equals);
  Scene changed = scene;
  add_next_items(changed, path);
  const std::vector<Object> before = changed.objects;
  assign_text(find_slot(slots(changed), path), path_and_value.substr(equals + 1));
  for (std::size_t i = 0; i < before.size(); ++i)
    if (std::string& model = changed.objects[i].model; model != before[i].model) model = find_model(model);
  if (path.ends_with(".image") && path.find("layers.") != path.npos)
    if (std::string* const image = std::get<std::string*>(find_slot(slots(changed), path).value))
      *image = find_texture(*image);
  scene = std::move(changed);
}

}  // namespace cg
