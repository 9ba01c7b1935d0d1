#include "scene/bundled_models.h"

#include <array>

#include "params/numbers.h"
#include "scene/cornell_box.h"
#include "scene/radiosity_scenes.h"
#include "scene/shape.h"
#include "scene/write_obj.h"

namespace cg {

namespace {

constexpr std::string_view sources = R"(# Where the models come from

All files here are written by `shadebench-models` (`src/scene/models_main.cpp`); a test checks that they are what it
writes. They carry no licence beyond that of this project.

| file | origin |
|---|---|
| `teapot.obj` | Martin Newell's control points, University of Utah, 1975 (The Utilization of Procedure Models in Digital Image Synthesis), given away by him and freely used since; the bottom was added later (Frank Crow, The Origins of the Teapot, 1987). Tessellated here with exact normals. |
| `uv-sphere.obj` `icosphere.obj` `torus.obj` `torus-knot.obj` `cube.obj` `cylinder.obj` `cone.obj` `plane.obj` | From their equations (`src/scene/shape_round.cpp`, `src/scene/shape_flat.cpp`), with exact normals and uv. |
| `cornell-box.obj` `cornell-box.mtl` | Measurements published for public use by the Cornell University Program of Computer Graphics, <https://www.graphics.cornell.edu/online/box/data.html>. See below. |
| `parallel-squares` `perpendicular-squares` `closed-cube` `sphere-interior` `furnished-room` `corridor`, each `.obj` and `.mtl` | Made for this project (`src/scene/radiosity_scenes.cpp`): squares, a cube and a sphere whose radiosity is known in closed form, a room with a window and a corridor of thin strips to look at. Walls face into the room, furniture outwards; each but the squares is closed. |
| `*.json` | Presets of those: a camera that looks into them, no lamp, the ambient term from radiosity. |

## The Cornell box

Published millimetres, here in metres and turned half about y, so that the open side looks towards +z as the default
camera expects; red is on the left, green on the right. The walls face into the box, the blocks outwards; blocks have
no underside, as published. The ceiling is cut around the light, which lies in its plane.

The reflectances are those of the published spectra (400 to 700 nm in steps of 4 nm): for each of the three channels the
mean of the spectrum, weighted by the channel's matching function under light of equal energy, so that a perfect white
is (1, 1, 1). The matching functions are those of the linear sRGB primaries, from the CIE 1931 observer as approximated
by Wyman, Sloan and Shirley (2013). The light's emission is the same mean of its published spectrum (0, 8, 15.6, 18.4 at
400, 500, 600, 700 nm), its reflectance the published 0.78. All are rounded to three decimals.
)";

std::string shape_text(const Shape& shape) {
  const MeshHandle mesh = make_shape(shape);
  const std::array part{ObjPart{shape.id, {}, &mesh->data()}};
  return obj_text(part, "Shadebench: " + std::string(shape.label.en) + ", level " + std::to_string(shape.level));
}

std::string scene_text(const BundledScene& scene) {
  std::vector<ObjPart> out;
  for (const BundledPart& p : scene.parts) out.push_back({p.name, p.material, &p.mesh});
  return obj_text(out, "Shadebench: " + scene.comment + "; see SOURCES.md", scene.name + ".mtl");
}

std::string materials_text(const BundledScene& scene) {
  std::string out = "# Shadebench: materials of " + scene.name + ", linear sRGB; see SOURCES.md\n";
  for (const BundledMaterial& m : scene.materials) {
    const auto add = [&](const char* key, const glm::dvec3& v) {
      out += key;
      for (int i = 0; i < 3; ++i) out += " " + number_text(v[i]);
      out += '\n';
    };
    out += "newmtl " + m.name + "\n";
    add("Ka", m.reflectance);
    add("Kd", m.reflectance);
    add("Ks", glm::dvec3(0));
    add("Ke", m.emission);
  }
  return out;
}

std::string list_text(const glm::dvec3& v) {
  return "[" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + "]";
}

// The scene lit by its own light alone.
std::string preset_text(const BundledScene& scene) {
  std::string display = "{\"transform\": \"photographic\"";
  if (scene.exposure != 0) display += ", \"exposure\": " + number_text(scene.exposure);
  return "{\n  \"schema\": 1,\n  \"model\": \"" + scene.name +
         ".obj\",\n  \"camera\": {\"position\": " + list_text(scene.eye) + ", \"target\": " + list_text(scene.target) +
         ", \"fov\": " + number_text(scene.fov) + ", \"near\": 0.01},\n  \"lights\": {\"0\": {\"enabled\": false}},\n" +
         "  \"shading\": {\"ambient_source\": \"radiosity\", \"clamp\": false},\n" +
         "  \"radiosity\": {\"patch_size\": " + number_text(scene.patch_size) + "},\n  \"display\": " + display +
         "}\n}\n";
}

}  // namespace

std::vector<BundledFile> bundled_models() {
  std::vector<BundledFile> out;
  for (const Shape& s : shapes()) out.push_back({std::string(s.id) + ".obj", shape_text(s)});
  std::vector<BundledScene> scenes = radiosity_scenes();
  scenes.push_back({.name = "cornell-box",
                    .comment = "the Cornell box, in metres",
                    .parts = cornell_parts(),
                    .materials = cornell_materials(),
                    .eye = {0, 0, 2.6},
                    .fov = 40});
  for (const BundledScene& scene : scenes) {
    out.push_back({scene.name + ".obj", scene_text(scene)});
    out.push_back({scene.name + ".mtl", materials_text(scene)});
    out.push_back({scene.name + ".json", preset_text(scene)});
  }
  out.push_back({"SOURCES.md", std::string(sources)});
  return out;
}

}  // namespace cg
