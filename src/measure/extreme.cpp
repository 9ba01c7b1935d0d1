#include "measure/extreme.h"

#include <algorithm>

#include "measure/extreme_tables.h"
#include "params/input_error.h"

namespace cg {

namespace {

constexpr Name groups[] = {
    {"lights", {"Lights", "光源"}},
    {"attenuation", {"Attenuation", "減衰"}},
    {"spots", {"Spots", "スポット"}},
    {"materials", {"Materials", "素材"}},
    {"normals", {"Normals", "法線"}},
    {"meshes", {"Meshes", "メッシュ"}},
    {"places", {"Sizes and places", "大きさと位置"}},
    {"cameras", {"Cameras", "カメラ"}},
    {"pictures", {"Pictures", "画像"}},
    {"files", {"Files", "ファイル"}},
    {"values", {"Values as text", "文字で与える値"}},
    {"radiosity", {"Radiosity", "ラジオシティ"}},
    {"arithmetic", {"Naive and robust", "素朴な式と頑健な式"}},
};

constexpr void (*tables[])(ExtremeTable&) = {
    add_light_extremes,     add_attenuation_extremes, add_spot_extremes,     add_material_extremes,
    add_normal_extremes,    add_mesh_extremes,        add_place_extremes,    add_camera_extremes,
    add_picture_extremes,   add_file_extremes,        add_value_extremes,    add_radiosity_extremes,
    add_shading_arithmetic, add_geometry_arithmetic,  add_number_arithmetic, add_radiosity_arithmetic};

}  // namespace

std::span<const Name> extreme_groups() { return groups; }

std::span<const ExtremeCase> extreme_cases() {
  static const ExtremeTable all = [] {
    ExtremeTable table;
    for (const auto add : tables) add(table);
    return table;
  }();
  return all;
}

std::vector<const ExtremeCase*> find_extremes(std::string_view name, std::span<const ExtremeCase> all) {
  std::vector<const ExtremeCase*> found;
  for (const ExtremeCase& c : all)
    if (name.empty() || c.id == name || c.group == name) found.push_back(&c);
  if (!found.empty()) return found;
  std::string known;
  for (const Name& group : groups) known += (known.empty() ? "" : ", ") + std::string(group.id);
  throw InputError(
      std::string(name), {"there is no such case or group", "そのような事例や分類はない"},
      {"the groups are " + known + "; --list shows the cases", "分類は " + known + "。事例は --list で一覧できる"});
}

}  // namespace cg
