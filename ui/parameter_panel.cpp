// The left side: what a student turns first, and under it, folded, all the rest.
#include <algorithm>
#include <cmath>

#include "scene/named_materials.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/lesson_panel.h"
#include "ui/parameter.h"
#include "ui/widgets.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

// A line of small numbered tabs, one an item, and one to add and one to take away.
struct TabLine {
  bool add = false, remove = false;
};
TabLine numbered_tabs(App& app, std::string_view title, int count, int& chosen, bool can_add, bool can_remove,
                      const Words& add_tip, const Words& remove_tip) {
  TabLine out;
  Look& look = app.look;
  const float side = look.px(26), gap = look.px(3);
  ImGui::PushID(title.data(), title.data() + title.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, look.fonts.small, {at.x, at.y + look.px(18)}, look.palette.dim, noted(app, title));
  const int shown = std::min(count, 8), first = std::clamp(chosen - 7, 0, std::max(0, count - 8));
  const int buttons = shown + (can_add ? 1 : 0) + (can_remove ? 1 : 0);
  float x = at.x + std::max(room - float(buttons) * (side + gap), look.px(52));
  auto chip = [&](const char* id, std::string_view label, bool on, const Words& tip) {
    ImGui::SetCursorScreenPos({x, at.y});
    const bool pressed = ImGui::InvisibleButton(id, {side, side});
    const bool hovered = ImGui::IsItemHovered();
    if (on || hovered)
      draw->AddRectFilled({x, at.y}, {x + side, at.y + side}, on ? look.palette.accent : look.palette.raised_hover,
                          look.px(4));
    set_text(draw, look.fonts.mono,
             {x + 0.5f * (side - text_width(look.fonts.mono, label)), at.y + 0.5f * (side + look.px(11))},
             on ? look.palette.on_accent : look.palette.dim, noted(app, label));
    if (wants_tooltip(app) && !tip.en.empty()) tooltip(app, {}, tip.in(app.language()), {});
    x += side + gap;
    return pressed;
  };
  for (int i = first; i < first + shown; ++i) {
    ImGui::PushID(i);
    if (chip("tab", std::to_string(i), i == chosen, {})) chosen = i;
    ImGui::PopID();
  }
  if (can_remove) out.remove = chip("remove", "−", false, remove_tip);
  if (can_add) out.add = chip("add", "+", false, add_tip);
  ImGui::SetCursorScreenPos({at.x, at.y + side + look.px(4)});
  ImGui::PopID();
  return out;
}

void draw_light_tabs(App& app) {
  Scene& scene = app.scene;
  const int count = int(scene.lights.size());
  app.light = count == 0 ? 0 : std::clamp(app.light, 0, count - 1);
  const std::string title = std::string(Words{"Light", "光源"}.in(app.language())) +
                            (count > 0 ? " LIGHT" + std::to_string(app.light) : std::string());
  const TabLine line = numbered_tabs(app, title, count, app.light, count<light_limit, count> 0,
                                     {"Add a light", "光源を加える"}, {"Remove this light", "この光源を消す"});
  if (line.add) {
    Light light = count > 0 ? scene.lights[std::size_t(app.light)] : Light{};
    light.position = {-light.position.x, light.position.y, light.position.z};
    if (count > 0) light.diffuse *= 0.5, light.specular *= 0.5;
    scene.lights.push_back(light);
    app.light = count;
  } else if (line.remove) {
    scene.lights.erase(scene.lights.begin() + app.light);
    app.light = std::max(0, app.light - 1);
    app.isolated = {};
  }
}

std::string light_prefix(const App& app) { return "lights." + std::to_string(app.light) + "."; }

void draw_light_details(App& app, const Slots& all) {
  if (app.scene.lights.empty()) return;
  const LightKind kind = app.scene.lights[std::size_t(app.light)].kind;
  const std::string prefix = light_prefix(app);
  parameters(app, all, prefix, {"enabled", "kind", "ambient", "diffuse", "specular"});
  if (kind == LightKind::spot) parameters(app, all, prefix, {"direction", "cutoff", "exponent"});
  if (kind != LightKind::directional) parameters(app, all, prefix, {"k_0", "k_1", "k_2"});
}

Object* chosen_object(App& app) {
  if (app.scene.objects.empty()) return nullptr;
  app.object = std::clamp(app.object, 0, int(app.scene.objects.size()) - 1);
  return &app.scene.objects[std::size_t(app.object)];
}

std::string material_prefix(App& app) {
  const Object* o = chosen_object(app);
  return o && o->own_material ? "objects." + std::to_string(app.object) + ".material." : "material.";
}

// A list of the classic materials, which shows the one whose numbers stand there now.
void choose_named_material(App& app) {
  Object* o = chosen_object(app);
  Material& material = o && o->own_material ? o->material : app.scene.material;
  std::string shown(Words{"choose …", "選ぶ…"}.in(app.language()));
  for (const NamedMaterial& named : named_materials)
    if (with(material, named) == material) shown = named.label.in(app.language());
  heading(app, Words{"Classic material", "代表的な素材"}.in(app.language()));
  noted(app, shown);
  if (!begin_list(app, "##named", shown.c_str(), ImGui::GetContentRegionAvail().x)) return;
  for (const NamedMaterial& named : named_materials)
    if (ImGui::Selectable(std::string(noted(app, named.label)).c_str())) material = with(material, named);
  ImGui::EndCombo();
}

void draw_material_details(App& app, const Slots& all) {
  choose_named_material(app);
  parameters(app, all, material_prefix(app), {"k_r", "k_t", "emission"});
  if (app.scene.shading.color_material != ColorMaterial::off) parameters(app, all, material_prefix(app), {"color"});
}

void draw_tessellation(App& app, const Slots& all) {
  const Object* o = chosen_object(app);
  const std::string path = "objects." + std::to_string(app.object) + ".tessellation";
  for (const Slot& slot : all)
    if (o && slot.path == path) tessellation(app, slot, *o);
}

void draw_objects(App& app, const Slots& all) {
  Scene& scene = app.scene;
  const TabLine line =
      numbered_tabs(app, Words{"Object", "物体"}.in(app.language()), int(scene.objects.size()), app.object,
                    scene.objects.size() < 64, scene.objects.size() > 1,
                    {"Add a copy of this object", "この物体の複製を加える"}, {"Remove this object", "この物体を消す"});
  if (line.add && !scene.objects.empty()) {
    Object copy = scene.objects[std::size_t(app.object)];
    copy.transform.translate.x += 1;
    scene.objects.push_back(std::move(copy));
    app.object = int(scene.objects.size()) - 1;
    return;  // the slots are stale
  }
  if (line.remove) {
    scene.objects.erase(scene.objects.begin() + app.object);
    app.object = std::max(0, app.object - 1);
    return;
  }
  if (const Object* o = chosen_object(app)) {
    ImGui::PushFont(app.look.fonts.small_mono);
    write(app, o->part.empty() ? o->model : o->model + " / " + o->part);
    ImGui::PopFont();
    const std::string prefix = "objects." + std::to_string(app.object) + ".";
    parameters(app, all, prefix, {"visible", "own_material"});
    parameters(app, all, prefix + "transform.", {"translate", "rotate", "scale"});
  }
}

void draw_overlay_settings(App& app) {
  const Slots all = slots(app.settings);
  parameters(app, all, "", {"handles", "vertex_normals", "face_normals", "wireframe", "axes", "clamped", "square"});
  if (app.settings.vertex_normals || app.settings.face_normals) parameters(app, all, "", {"normal_length"});
  toggle(app, "turntable", Words{"Turntable", "回転台"}.in(app.language()), app.turntable);
}

void gap(const App& app) { ImGui::Dummy({1, app.look.px(6)}); }

}  // namespace

void draw_parameters(App& app) {
  // In a lesson what the step is about stands first, and all the rest is folded away.
  if (draw_offered_parameters(app)) {
    gap(app);
    if (!section(app, "all", {"All parameters", "すべてのパラメータ"}, false)) return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {app.look.px(8), app.look.px(4)});
  draw_light_tabs(app);
  const Slots all = slots(app.scene);
  const Language language = app.language();
  if (!app.scene.lights.empty()) {
    parameters(app, all, light_prefix(app), {"position"}, false);
    if (app.scene.lights[std::size_t(app.light)].kind != LightKind::directional)
      parameters(app, all, light_prefix(app), {"w"});
  }
  gap(app);
  heading(app, Words{"Material", "素材"}.in(language));
  parameters(app, all, material_prefix(app), {"k_a", "k_d", "k_s", "n"});
  gap(app);
  parameters(app, all, "shading.", {"mode"});
  gap(app);
  draw_tessellation(app, all);
  gap(app);
  const std::size_t objects = app.scene.objects.size();
  if (section(app, "light", {"Light: kind, colours, attenuation", "光源の種類・色・減衰"}, false))
    draw_light_details(app, all);
  if (section(app, "material", {"Material: classic ones, mirror, emission", "代表的な素材・鏡・透過・発光"}, false))
    draw_material_details(app, all);
  if (section(app, "shading", {"Shading: highlight, normals", "ハイライトの式・法線"}, false))
    parameters(app, all, "shading.",
               {"reflection", "normals", "crease_angle", "ambient", "ambient_source", "local_viewer", "two_sided",
                "normal_length", "color_material", "clamp", "precision"});
  if (section(app, "radiosity", {"Radiosity: patches, F_ij, solver", "ラジオシティ：パッチ・F_ij・解法"}, false))
    draw_radiosity(app, all);
  if (section(app, "camera", {"Camera", "カメラ"}, false)) {
    parameters(app, all, "camera.", {"projection"});
    parameters(app, all, "camera.",
               {app.scene.camera.projection == Projection::perspective ? "fov" : "height", "near", "far", "position",
                "target", "up"});
  }
  if (section(app, "display", {"Display", "表示"}, false)) {
    parameters(app, all, "display.", {"transform"});
    if (app.scene.display.transform == DisplayTransform::photographic) parameters(app, all, "display.", {"exposure"});
    parameters(app, all, "display.", {"background"});
  }
  if (section(app, "overlay", {"In the picture", "画面に重ねるもの"}, false)) draw_overlay_settings(app);
  if (section(app, "objects", {"Objects", "物体"}, false) && objects == app.scene.objects.size())
    draw_objects(app, all);
  ImGui::PopStyleVar();
}

}  // namespace cg
