// All there is to draw: a plain value to copy, compare and save. Meshes are shared and immutable, so a copy is
// cheap and undo is a stack of scenes. Nothing derived is stored in it but the radiosity solution that is to be drawn,
// which no file keeps.
#pragma once
#include <string>
#include <vector>

#include "image/display.h"
#include "params/slots.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/mapping_parameters.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/mistakes.h"
#include "scene/radiosity.h"
#include "scene/radiosity_field.h"
#include "scene/shading.h"
#include "scene/transform.h"

namespace cg {

struct Object {
  std::string name;
  std::string model;     // a shape's name ("teapot") or a file ("teapot.obj")
  std::string part;      // the object in that file; empty: the whole
  int tessellation = 0;  // of a shape: its level, 0 is the shape's own choice; files have none
  bool visible = true;
  Transform transform;
  bool own_material = false;  // false: the scene's
  Material material;
  Unwrapping unwrapping;  // of its mesh, for the layers of textures that ask for it
  MeshHandle mesh;        // what model, part and tessellation stand for; null until it is loaded
  friend bool operator==(const Object&, const Object&) = default;
};

template <>
inline constexpr auto fields_of<Object> = std::tuple{
    field(&Object::name, {.name = "name", .label = {"Name", "名前"}}),
    field(&Object::model, {.name = "model", .label = {"Model", "モデル"}}),
    field(&Object::part, {.name = "part", .label = {"Part", "部分"}}),
    field(&Object::tessellation, {.name = "tessellation",
                                  .range = {0, 2000},
                                  .slider = Range{0, 64},
                                  .label = {"Tessellation", "細分割"},
                                  .help = {"How finely a shape is cut into faces; 0 is its own choice.",
                                           "形を面に分ける細かさ。0 は形に任せる。"}}),
    field(&Object::visible, {.name = "visible", .label = {"Visible", "表示"}}),
    field(&Object::transform, {.name = "transform", .label = {"Transform", "変換"}}),
    field(&Object::own_material, {.name = "own_material",
                                  .label = {"Own material", "専用の素材"},
                                  .help = {"The object has a material of its own instead of the scene's.",
                                           "シーンの素材でなく専用の素材を使う。"}}),
    field(&Object::material, {.name = "material", .label = {"Material", "素材"}}),
    field(&Object::unwrapping, {.name = "unwrapping", .label = {"Unwrap", "展開図"}}),
};

inline constexpr std::size_t object_limit = 100000;  // of a scene

struct Scene {
  std::vector<Object> objects;
  Material material;  // of every object without its own
  std::vector<Light> lights{Light{}};
  Camera camera;
  Shading shading;
  Radiosity radiosity;
  RadiosityHandle radiosity_field;  // the solution that Shading::ambient_source may name; null: there is none
  Display display;
  Mistakes mistakes;
  friend bool operator==(const Scene&, const Scene&) = default;
};

template <>
inline constexpr auto fields_of<Scene> = std::tuple{
    field(&Scene::objects, {.name = "objects", .most = object_limit, .label = {"Objects", "物体"}}),
    field(&Scene::material, {.name = "material", .label = {"Material", "素材"}}),
    field(&Scene::lights, {.name = "lights", .most = light_limit, .label = {"Lights", "光源"}}),
    field(&Scene::camera, {.name = "camera", .label = {"Camera", "カメラ"}}),
    field(&Scene::shading, {.name = "shading", .label = {"Shading", "シェーディング"}}),
    field(&Scene::radiosity, {.name = "radiosity", .label = {"Radiosity", "ラジオシティ"}}),
    field(&Scene::display, {.name = "display", .label = {"Display", "表示"}}),
    field(&Scene::mistakes, {.name = "mistakes", .label = {"Break it on purpose", "わざと間違える"}}),
};

extern template Slots slots<Scene>(Scene&);  // in scene.cpp: long, and wanted in many files

inline const Material& material_of(const Scene& scene, const Object& object) {
  return object.own_material ? object.material : scene.material;
}

}  // namespace cg
