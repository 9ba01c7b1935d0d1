#include "workbench/scene_change.h"

#include <algorithm>

namespace cg {

namespace {

bool same_shape(const Object& a, const Object& b) {
  return a.mesh == b.mesh && a.visible == b.visible && a.transform == b.transform;
}

bool same_material(const Object& a, const Object& b) {
  return a.own_material == b.own_material && a.material == b.material;
}

}  // namespace

SceneChange scene_change(const Scene& a, const Scene& b) {
  const auto objects = [&](auto same) {
    return a.objects.size() == b.objects.size() &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), same);
  };
  const bool face_normals = (a.shading.mode == ShadingMode::flat) != (b.shading.mode == ShadingMode::flat);
  const bool other_normals = a.shading.normals != b.shading.normals || a.shading.crease_angle != b.shading.crease_angle;
  SceneChange c;
  c.geometry = !objects(same_shape) || face_normals || other_normals;
  c.camera = a.camera != b.camera;
  Shading shading = b.shading;
  shading.normals = a.shading.normals, shading.crease_angle = a.shading.crease_angle;
  c.light = a.lights != b.lights || a.shading != shading || a.mistakes != b.mistakes;
  c.radiosity = a.radiosity_field != b.radiosity_field;
  c.material = a.material != b.material || !objects(same_material);
  c.background = a.display.background != b.display.background;
  c.display = a.display.transform != b.display.transform || a.display.exposure != b.display.exposure;
  return c;
}

Text text_of(const SceneChange& c) {
  Text out;
  const auto add = [&](bool changed, Words name) {
    if (!changed) return;
    out.en += (out.en.empty() ? "" : ", ") + std::string(name.en);
    out.ja += (out.ja.empty() ? "" : "、") + std::string(name.ja);
  };
  add(c.geometry, {"the shapes", "形"});
  add(c.camera, {"the camera", "カメラ"});
  add(c.light, {"the light", "光"});
  add(c.radiosity, {"the radiosity solution", "ラジオシティの解"});
  add(c.material, {"the material", "素材"});
  add(c.background, {"the background", "背景"});
  add(c.display, {"the display", "表示変換"});
  return out;
}

}  // namespace cg
