#include "workbench/preset.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "params/file.h"
#include "params/input_error.h"
#include "params/lists.h"
#include "workbench/model_library.h"
#include "workbench/texture_library.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

constexpr int schema = 1;

// ---- writing ----

// The model as it is named in a preset that stands in `folder`.
std::string name_for(const std::string& model, const fs::path& folder) {
  const fs::path path(model);
  if (folder.empty() || !path.is_absolute()) return model;
  std::error_code error;
  const fs::path near = path.lexically_relative(fs::absolute(folder, error).lexically_normal());
  return near.empty() || *near.begin() == ".." ? model : near.string();
}

template <class Do>
void for_each_layer(Scene& scene, const Do& each) {
  for (TextureLayer& layer : scene.material.layers) each(layer);
  for (Object& object : scene.objects)
    for (TextureLayer& layer : object.material.layers) each(layer);
}

// Gives the lists of `base` the lengths of those of `scene` and writes what that took: {} for an item more, null for
// one less.
void write_lengths(Tree& out, Scene& base, Scene& scene) {
  const std::vector<ListSlot> now = lists(scene);
  std::size_t i = 0;  // the outer lists are alike by then, so the lists come in the same order
  for_each_list(base, [&](const ListSlot& before) {
    const ListSlot& list = now[i++];
    for (std::size_t k = before.size(); k < list.size(); ++k)
      at_path(out, list.path).at(std::to_string(k)) = Tree(Tree::Members{});
    for (std::size_t k = list.size(); k < before.size(); ++k) at_path(out, list.path).at(std::to_string(k)) = Tree();
    before.resize(list.size());
  });
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

// The value at a path of nested objects; null where there is none.
const Tree* find_path(const Tree& tree, std::string_view path) {
  const Tree* here = &tree;
  while (here && here->members() && !path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    here = here->find(path.substr(0, dot));
    path.remove_prefix(std::min(dot + 1, path.size()));
  }
  return path.empty() ? here : nullptr;
}

ListChange list_change(const Tree& preset, const std::string& key, std::size_t length, std::size_t limit,
                       const std::string& where) {
  ListChange change{length, {}};
  const Tree* list = find_path(preset, key);
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

// Gives each list of the scene the items that the preset adds; those that it takes away are returned, outer lists
// first.
std::vector<std::pair<std::string, std::vector<std::size_t>>> add_items(Scene& scene, const Tree& preset,
                                                                        const std::string& where) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> removed;
  for_each_list(scene, [&](const ListSlot& list) {
    ListChange change = list_change(preset, list.path, list.size(), list.about->most, where);
    list.resize(change.length);
    if (!change.removed.empty()) removed.emplace_back(list.path, std::move(change.removed));
  });
  return removed;
}

void remove_items(Scene& scene, const std::vector<std::pair<std::string, std::vector<std::size_t>>>& removed) {
  for (auto one = removed.rbegin(); one != removed.rend(); ++one) {
    const std::vector<ListSlot> all = lists(scene);
    const auto list = std::find_if(all.begin(), all.end(), [&](const ListSlot& l) { return l.path == one->first; });
    for (auto i = one->second.rbegin(); i != one->second.rend(); ++i) list->erase(*i);
  }
}

void assign_members(const Slots& all, const std::set<std::string>& list_paths, const Tree& tree,
                    const std::string& prefix) {
  const bool items = !prefix.empty() && list_paths.contains(prefix.substr(0, prefix.size() - 1));
  for (const auto& [key, value] : *tree.members()) {
    const std::string path = prefix + key;
    if (prefix.empty() && (key == "schema" || key == "model")) continue;
    if (items && value.is_null()) continue;
    if (list_paths.contains(path) && value.members()->empty()) continue;
    const std::string below = path + ".";
    const bool inner = std::any_of(all.begin(), all.end(), [&](const Slot& s) { return s.path.starts_with(below); });
    if (value.members() && inner && key.find('.') == key.npos)
      assign_members(all, list_paths, value, below);
    else if (list_paths.contains(path))
      continue;  // all its items are taken away
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
  Scene named = scene;  // slots point into it; its meshes stay behind
  write_lengths(out, base, named);
  for (Scene* s : {&named, &base}) {
    for (Object& object : s->objects) object.model = name_for(object.model, folder);
    for_each_layer(*s, [&](TextureLayer& layer) { layer.image = name_for(layer.image, folder); });
  }
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
  std::vector<std::string> before;
  for (const Object& object : scene.objects) before.push_back(object.model);
  const auto removed = add_items(scene, preset, where);
  before.resize(scene.objects.size());
  try {
    std::set<std::string> list_paths;
    for (const ListSlot& list : lists(scene)) list_paths.insert(list.path);
    assign_members(slots(scene), list_paths, preset, "");
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (std::string& model = scene.objects[i].model; model != before[i]) model = find_model(model, folder);
    for_each_layer(scene, [&](TextureLayer& layer) { layer.image = find_texture(layer.image, folder); });
    remove_items(scene, removed);
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
