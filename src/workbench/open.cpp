#include "workbench/open.h"

#include "params/input_error.h"
#include "params/slots.h"
#include "workbench/data_folder.h"
#include "workbench/lesson.h"
#include "workbench/preset.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// Adds the item that a path begins with ("lights.1.") where it is the next of the list.
template <class Item>
void add_next(std::vector<Item>& list, std::string_view path, std::string_view key, std::size_t limit) {
  const std::string next = std::string(key) + std::to_string(list.size()) + ".";
  if (list.size() < limit && path.starts_with(next)) list.emplace_back();
}

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
  add_next(changed.lights, path, "lights.", light_limit);
  add_next(changed.objects, path, "objects.", std::size_t(-1));
  const std::vector<Object> before = changed.objects;
  assign_text(find_slot(slots(changed), path), path_and_value.substr(equals + 1));
  for (std::size_t i = 0; i < before.size(); ++i)
    if (std::string& model = changed.objects[i].model; model != before[i].model) model = find_model(model);
  scene = std::move(changed);
}

}  // namespace cg
