#include "workbench/preset.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "params/file.h"
#include "params/input_error.h"
#include "params/slots.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr int schema = 1;
constexpr std::size_t object_limit = 100000;

// ---- writing ----

// The model as it is named in a preset that stands in `folder`.
std::string name_for(const std::string& model, const fs::path& folder) {
  const fs::path path(model);
  if (folder.empty() || !path.is_absolute()) return model;
  std::error_code error;
  const fs::path near = path.lexically_relative(fs::absolute(folder, error).lexically_normal());
  return near.empty() || *near.begin() == ".." ? model : near.string();
}

// Gives `base` the length of `list` and writes what that took: {} for an item more, null for one less.
template <class Item>
void write_length(Tree& out, std::string_view key, std::vector<Item>& base, const std::vector<Item>& list) {
  for (std::size_t i = base.size(); i < list.size(); ++i) out.at(key).at(std::to_string(i)) = Tree(Tree::Members{});
  for (std::size_t i = list.size(); i < base.size(); ++i) out.at(key).at(std::to_string(i)) = Tree();
  base.resize(list.size());
}

// ---- reading ----

[[noreturn]] void refuse(const std::string& where, const InputError& e) {
  throw InputError(where + ": " + e.where, e.found, e.accepted, e.line, e.byte);
}

std::optional<std::size_t> index_of(std::string_view key) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
  const bool plain = error == std::errc() && end == key.data() + key.size() && (key == "0" || key[0] != '0');
  return plain ? std::optional(index) : std::nullopt;
}

void check_head(const Tree& preset, const std::string& where) {
  if (!preset.members())
    throw InputError(
        where, {"this is no preset", "プリセットではありません"},
        {"a preset is a JSON object with \"schema\": 1", "\"schema\": 1 を持つ JSON オブジェクトが必要です"});
  const Tree* version = preset.find("schema");
  if (!version || !version->number() || *version->number() != schema) {
    const std::string found = version ? to_json(*version, 0) : "";
    throw InputError(where + ": schema",
                     version ? Text{"version " + found + " is not known", "版 " + found + " は扱えません"}
                             : Text{"the preset has no version", "プリセットに版がありません"},
                     {"this program reads \"schema\": 1", "このプログラムが読めるのは \"schema\": 1 です"});
  }
}

// Which items of a list the preset adds and takes away.
struct ListChange {
  std::size_t length;                // after adding
  std::vector<std::size_t> removed;  // ascending
};

ListChange list_change(const Tree& preset, const std::string& key, std::size_t length, std::size_t limit,
                       const std::string& where) {
  ListChange change{length, {}};
  const Tree* list = preset.find(key);
  if (!list) return change;
  if (!list->members())
    throw InputError(where + ": " + key, {"this is no list", "リストではありません"},
                     {"write it as an object with the indices as keys: {\"0\": {...}}",
                      "番号をキーにしたオブジェクト {\"0\": {...}} で書いてください"});
  std::vector<std::size_t> named;
  for (const auto& [name, item] : *list->members()) {
    const auto index = index_of(name);
    if (!index || (!item.is_null() && !item.members()))
      throw InputError(where + ": " + key + "." + name, {"this is no item of the list", "リストの要素ではありません"},
                       {"give an index and an object, or null to take it away: \"0\": {...}",
                        "番号とオブジェクト（取り除くなら null）を \"0\": {...} のように書いてください"});
    (item.is_null() ? change.removed : named).push_back(*index);
  }
  std::sort(named.begin(), named.end());
  std::sort(change.removed.begin(), change.removed.end());
  for (const std::size_t index : named)
    if (index == change.length && change.length < limit) ++change.length;
  for (const std::vector<std::size_t>& indices : {named, change.removed})
    if (!indices.empty() && indices.back() >= change.length) {
      const std::string next = std::to_string(change.length);
      throw InputError(where + ": " + key + "." + std::to_string(indices.back()),
                       {"there is no such item", "そのような要素はありません"},
                       change.length < limit
                           ? Text{"the next new one is " + next, "次に加えられるのは " + next + " です"}
                           : Text{"there may be " + next, "最大 " + next + " 個です"});
    }
  return change;
}

template <class Item>
void remove(std::vector<Item>& list, const std::vector<std::size_t>& removed) {
  for (auto i = removed.rbegin(); i != removed.rend(); ++i) list.erase(list.begin() + std::ptrdiff_t(*i));
}

void assign_members(const Slots& all, const Tree& tree, const std::string& prefix) {
  for (const auto& [key, value] : *tree.members()) {
    const std::string path = prefix + key;
    if (prefix.empty() && (key == "schema" || key == "model")) continue;
    const std::string below = path + ".";
    const bool inner = std::any_of(all.begin(), all.end(), [&](const Slot& s) { return s.path.starts_with(below); });
    const bool list = prefix.empty() && (key == "lights" || key == "objects");
    if (list && value.members()->empty()) continue;
    if (prefix == "lights." || prefix == "objects.")
      if (value.is_null()) continue;
    if (value.members() && inner && key.find('.') == key.npos)
      assign_members(all, value, below);
    else if (key.find('.') != key.npos)
      throw InputError(
          path, {"a dot in a key", "キーに点があります"},
          {"nest the objects: {\"material\": {\"n\": 8}}", "{\"material\": {\"n\": 8}} のように入れ子にしてください"});
    else
      assign(find_slot(all, path), value);
  }
}

// The base that the preset changes.
Scene base_of(const Tree& preset, const std::string& where, const fs::path& folder) {
  const Tree* model = preset.find("model");
  if (!model) return Scene{};
  if (!model->string())
    throw InputError(where + ": model",
                     {to_json(*model, 0) + " is no name", to_json(*model, 0) + " は名前ではありません"},
                     {"name a model: \"teapot\"", "\"teapot\" のようにモデルの名前を書いてください"});
  try {
    return open_model(find_model(*model->string(), folder));
  } catch (const InputError& e) {
    refuse(where, e);
  }
}

}  // namespace

Tree preset_of(const Scene& scene, const fs::path& folder) {
  Tree out;
  out.at("schema") = schema;
  Scene base;
  if (!scene.objects.empty() && !scene.objects[0].model.empty()) {
    base = open_model(scene.objects[0].model);
    out.at("model") = name_for(scene.objects[0].model, folder);
  }
  write_length(out, "objects", base.objects, scene.objects);
  write_length(out, "lights", base.lights, scene.lights);
  Scene named = scene;  // slots point into it; its meshes stay behind
  for (Scene* s : {&named, &base})
    for (Object& object : s->objects) object.model = name_for(object.model, folder);
  const Slots now = slots(named), before = slots(base);
  // As text, so that -0 and 0 differ and the file reads back the same bits.
  for (std::size_t i = 0; i < now.size(); ++i)
    if (const Tree value = slot_tree(now[i]); to_json(value, 0) != to_json(slot_tree(before[i]), 0))
      at_path(out, now[i].path) = value;
  return out;
}

Scene scene_of(const Tree& preset, const std::string& where, const fs::path& folder) {
  check_head(preset, where);
  Scene scene = base_of(preset, where, folder);
  const ListChange objects = list_change(preset, "objects", scene.objects.size(), object_limit, where);
  const ListChange lights = list_change(preset, "lights", scene.lights.size(), light_limit, where);
  scene.objects.resize(objects.length);
  scene.lights.resize(lights.length);
  try {
    std::vector<std::string> before;
    for (const Object& object : scene.objects) before.push_back(object.model);
    assign_members(slots(scene), preset, "");
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (std::string& model = scene.objects[i].model; model != before[i]) model = find_model(model, folder);
    remove(scene.objects, objects.removed);
    remove(scene.lights, lights.removed);
    load_meshes(scene);
  } catch (const InputError& e) {
    refuse(where, e);
  }
  return scene;
}

void save_preset(const Scene& scene, const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  save_file(file, to_json(preset_of(scene, folder)) + "\n");
}

Scene read_preset(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return scene_of(parse_json(read_file(file, std::size_t(16) << 20), file.string()), file.string(), folder);
}

}  // namespace cg
