#include "ui/presets.h"

#include <charconv>
#include <filesystem>

#include "params/slots.h"
#include "ui/app.h"

namespace cg {
namespace {

// The index in "lights.1", where that is the whole path; -1 for anything else.
int item_of(std::string_view path, std::string_view list) {
  if (!path.starts_with(list) || path.size() <= list.size() + 1) return -1;
  path.remove_prefix(list.size() + 1);
  int index = -1;
  const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), index);
  return error == std::errc() && end == path.data() + path.size() ? index : -1;
}

// The item of `from` at `index`, which is taken away where `from` has none.
template <class Item>
void take_item(std::vector<Item>& list, const std::vector<Item>& from, std::size_t index) {
  if (index >= from.size()) {
    list.resize(std::min(list.size(), index));
  } else if (index < list.size()) {
    list[index] = from[index];
  } else {
    list.push_back(from[index]);
  }
}

}  // namespace

const std::vector<ParameterDifference>& PresetShelf::differences(const Scene& in_hand) {
  const Scene& a = kept[0] ? *kept[0] : in_hand;
  const Scene& b = kept[1] ? *kept[1] : in_hand;
  if (a_ == a && b_ == b) return differences_;
  a_ = a, b_ = b;
  return differences_ = scene_differences(a, b);
}

void store_preset(App& app, int which) {
  app.presets.kept[std::size_t(which)] = app.scene;
  std::string name = app.preset;
  if (name.empty() && !app.scene.objects.empty()) name = app.scene.objects[0].model;
  app.presets.names[std::size_t(which)] = std::filesystem::path(name).filename().string();
}

void show_preset(App& app, int which) {
  const std::optional<Scene>& scene = app.presets.kept[std::size_t(which)];
  if (!scene) return;
  app.scene = *scene;
  app.isolated = {};
}

void flip_presets(App& app) {
  const auto& kept = app.presets.kept;
  if (!kept[0] && !kept[1]) {
    say(app,
        Text(Words{"Nothing is kept yet: store A or B first", "まだ何も控えていません。先に A か B に控えてください"}));
    return;
  }
  const bool shows_a = kept[0] && app.scene == *kept[0];
  show_preset(app, kept[1] && (shows_a || !kept[0]) ? 1 : 0);
}

void take_over(App& app, const std::string& path, int which) {
  const std::optional<Scene>& kept = app.presets.kept[std::size_t(which)];
  if (!kept) return;
  Scene from = *kept;
  if (const int i = item_of(path, "lights"); i >= 0) return take_item(app.scene.lights, from.lights, std::size_t(i));
  if (const int i = item_of(path, "objects"); i >= 0) return take_item(app.scene.objects, from.objects, std::size_t(i));
  try {
    assign(find_slot(slots(app.scene), path), slot_tree(find_slot(slots(from), path)));
  } catch (const InputError& e) {
    say(app, e);
  }
}

}  // namespace cg
