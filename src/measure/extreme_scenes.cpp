#include "measure/extreme_scenes.h"

#include <cmath>

#include "workbench/model_library.h"

namespace cg {

namespace {

Scene shape_scene(const char* shape, int tessellation) {
  Scene s;
  Object& object = s.objects.emplace_back();
  object.name = object.model = shape;
  object.tessellation = tessellation;
  load_meshes(s);
  return s;
}

}  // namespace

Scene sphere_scene() {
  Scene s = shape_scene("uv-sphere", 24);
  s.material.n = 5;
  return s;
}

Scene square_scene() {
  Scene s = shape_scene("plane", 1);
  s.objects[0].transform.rotate = {90, 0, 0};
  s.objects[0].transform.scale = glm::dvec3(std::sqrt(2.0));
  s.camera.position = {0, 0, 4};
  s.material.n = 32;
  return s;
}

Scene even_square(double theta) {
  Scene s = square_scene();
  s.lights[0].kind = LightKind::directional;
  s.lights[0].position = {std::sin(theta), 0, std::cos(theta)};
  return s;
}

glm::dvec3 even_colour(const Scene& s, double theta) {
  const Light& light = s.lights[0];
  const Material& m = s.material;
  return m.emission + s.shading.ambient * m.k_a + light.ambient * m.k_a + light.diffuse * m.k_d * std::cos(theta) +
         light.specular * m.k_s * std::pow(std::cos(theta / 2), m.n);
}

MeshHandle mesh_of_faces(std::vector<glm::dvec3> positions, const std::vector<std::vector<std::uint32_t>>& polygons) {
  MeshData d;
  d.positions = std::move(positions);
  for (const auto& polygon : polygons) {
    std::vector<Corner> corners;
    for (const std::uint32_t i : polygon) corners.push_back({i, no_index, no_index});
    d.add_face(corners.data(), corners.data() + corners.size());
  }
  return Mesh::make(std::move(d));
}

MeshHandle changed_mesh(const Mesh& mesh, double scale, const glm::dvec3& offset, double normal_length) {
  MeshData data = mesh.data();
  for (glm::dvec3& p : data.positions) p = p * scale + offset;
  for (glm::dvec3& n : data.normals) n *= normal_length;
  return Mesh::make(std::move(data));
}

void unlit(Scene& s) { s.lights.clear(); }

Change nothing_changed() {
  return [](Scene&) {};
}

Change both(Change a, Change b) {
  return [=](Scene& s) { a(s), b(s); };
}

Change mesh_change(MeshHandle mesh) {
  return [mesh](Scene& s) {
    Object& object = s.objects[0];
    object.model.clear();  // made here, not by a name
    object.tessellation = 0;
    object.transform = {};
    object.mesh = mesh;
  };
}

Change light_kind(LightKind kind) {
  return [kind](Scene& s) { s.lights[0].kind = kind; };
}

Change light_at(const glm::dvec3& position, double w, LightKind kind) {
  return [=](Scene& s) { s.lights[0].position = position, s.lights[0].w = w, s.lights[0].kind = kind; };
}

ExtremeCase picture_case(PictureRow row) {
  PictureCheck check = row.check;
  const bool beside = bool(row.same);
  if (!check) check = row.same ? same_as(row.start, row.same) : as_reference();
  if (row.fixed_same) check = by_technique(same_as(row.start, row.fixed_same), std::move(check));
  ExtremeCase out;
  out.id = std::move(row.id), out.group = std::move(row.group), out.name = std::move(row.name);
  out.parameter = std::move(row.parameter), out.value = std::move(row.value), out.right = std::move(row.right);
  out.tolerance = row.tolerance > 0 ? row.tolerance : beside ? 1.0 / 255 : 2.0 / 255;
  ExtremeScene scene;
  scene.make = [start = row.start, change = row.change] {
    Scene s = start();
    if (change) change(s);
    return s;
  };
  scene.check = std::move(check);
  scene.note = row.note;
  scene.fixed_note = row.fixed_note.empty() ? row.note : row.fixed_note;
  scene.variants = std::move(row.variants);
  out.scene = std::move(scene);
  return out;
}

Text as_without_light() {
  return Words{"As without the light: I_a k_a alone.", "光源がないときと同じで、I_a k_a だけになる。"};
}

Text as_directional() {
  return Words{"As a directional light from the same side (the limit).", "同じ方向の平行光源と同じ（極限）。"};
}

Text as_ordinary() { return Words{"As the ordinary scene, unchanged.", "通常のシーンと同じ画像になる。"}; }

Text as_the_reference() {
  return Words{"As the light model in double at the point that the pixel's ray meets.",
               "画素の光線が当たる点で、double の照明モデルが与える色と同じ。"};
}

}  // namespace cg
