// Measurements of one point of a surface: the factors of its light, and a vertex on its way to the screen.
#include <array>

#include "params/input_error.h"
#include "shading/clip_position.h"
#include "shading/eye_normal.h"
#include "shading/light_model.h"
#include "workbench/measurement_picture.h"
#include "workbench/probe.h"
#include "workbench/technique_list.h"

namespace cg {

glm::dvec4 in_space(const glm::dvec3& world, Space space, const Scene& scene, int object, int size) {
  const glm::dvec4 p(world, 1);
  if (space == Space::object) return glm::inverse(matrix(scene.objects[std::size_t(object)].transform)) * p;
  if (space == Space::world) return p;
  const glm::dvec4 eye = view_matrix(scene.camera) * p;
  if (space == Space::eye) return eye;
  const glm::dvec4 clip = projection_matrix(scene.camera, 1) * eye;
  if (space == Space::clip) return clip;
  const glm::dvec3 device = glm::dvec3(clip) / clip.w;
  if (space == Space::device) return {device, 1};
  return {glm::dvec3((device.x + 1) / 2 * size, (device.y + 1) / 2 * size, (device.z + 1) / 2), 1};
}

double component_of(const glm::dvec4& v, Component component) {
  return component == Component::length ? glm::length(glm::dvec3(v)) : v[int(component)];
}

const Object& object_at(const Scene& scene, int index) {
  const std::string count = std::to_string(scene.objects.size());
  if (std::size_t(index) >= scene.objects.size() || !scene.objects[std::size_t(index)].mesh)
    throw InputError("object", {"there is no such object", "そのような物体はない"},
                     {"the scene has " + count, "シーンの物体は " + count + " 個"});
  return scene.objects[std::size_t(index)];
}

namespace {

// What the software reference's picture shows at the options' place. Terms are not isolated: the factors of a light do
// not depend on them.
Probe probed(const MeasureInput& in) {
  MeasurementOptions options = in.options;
  options.term = LightTerm::all;
  options.light = -1;
  const Scene scene = as_asked(in.scene, options);
  View view;
  view.width = view.height = options.size;
  view.ids = true;
  const Technique& software = find_technique(in.techniques, "software");
  const Frame frame = software.render(scene, software.plan(scene, view), view, in.progress);
  const Probe p = probe(scene, software, view, frame, pixel_of(options), in.progress);
  if (!p.covered) nothing_there();
  return p;
}

double point(const MeasureInput& in) {
  const Probe p = probed(in);
  return component_of(in_space(p.here.P, in.options.space, as_asked(in.scene, in.options), p.object, in.options.size),
                      in.options.component);
}

const Object& object_of(const MeasureInput& in) { return object_at(in.scene, in.options.object); }

glm::dvec3 vertex_position(const MeasureInput& in) {
  const auto& positions = object_of(in).mesh->data().positions;
  const std::size_t index = std::size_t(in.options.vertex);
  if (index >= positions.size())
    throw InputError("vertex", {"there is no such vertex", "そのような頂点はない"},
                     {"the mesh has " + std::to_string(positions.size()),
                      "メッシュの頂点は " + std::to_string(positions.size()) + " 個"});
  return positions[index];
}

double vertex(const MeasureInput& in) {
  const Scene scene = as_asked(in.scene, in.options);
  const glm::dvec3 world(matrix(object_of(in).transform) * glm::dvec4(vertex_position(in), 1));
  return component_of(in_space(world, in.options.space, scene, in.options.object, in.options.size),
                      in.options.component);
}

// The vertex's normal as the scene's rule makes it, where the light model takes it: in eye coordinates.
glm::dvec3 eye_normal_of_vertex(const MeasureInput& in, const Scene& scene) {
  const Object& object = object_of(in);
  const glm::dvec3 position = vertex_position(in);
  const SurfaceHandle surface = make_surface(*object.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
  const auto to_eye =
      normals_to_eye<double>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
  for (std::size_t i = 0; i < surface->positions.size(); ++i) {
    const glm::dvec3 p = glm::dvec3(surface->positions[i]) * surface->radius + surface->centre;
    if (glm::length(p - position) <= 1e-6 * surface->radius) return eye_normal(to_eye, glm::dvec3(surface->normals[i]));
  }
  return glm::dvec3(0);
}

double vertex_normal(const MeasureInput& in) {
  const Scene scene = as_asked(in.scene, in.options);
  const glm::dvec3 eye = eye_normal_of_vertex(in, scene);
  const glm::dvec3 world = glm::transpose(glm::dmat3(view_matrix(scene.camera))) * eye;
  return component_of(glm::dvec4(in.options.space == Space::eye ? eye : world, 0), in.options.component);
}

double vertex_light(const MeasureInput& in) {
  const Scene scene = as_asked(in.scene, in.options);
  const glm::dmat4 view = view_matrix(scene.camera);
  const Object& object = object_of(in);
  const glm::dvec3 P(view * matrix(object.transform) * glm::dvec4(vertex_position(in), 1));
  const glm::dvec3 I = light_point(lighting_in_eye_space<double>(scene, view),
                                   eye_material<double>(material_of(scene, object), scene.shading.color_material), P,
                                   eye_normal_of_vertex(in, scene));
  return channel_of(glm::vec3(I), in.options.channel);
}

// The factors of one light at the point that a pixel shows, by the surface's normal there.
ProbedLight factors(const MeasureInput& in) {
  const int index = std::max(0, in.options.light);
  for (const ProbedLight& light : probed(in).here.lights)
    if (light.light == index) return light;
  throw InputError("light", {"the light is off or not there", "光源が消えているか存在しない"},
                   {"switch light " + std::to_string(index) + " on", "光源 " + std::to_string(index) + " を点ける"});
}

// As many as light is computed at in Gouraud shading: a position with two normals counts twice.
double lit_vertices(const MeasureInput& in) {
  const Shading& shading = in.scene.shading;
  double count = 0;
  for (const Object& object : in.scene.objects)
    if (object.visible && object.mesh)
      count += double(make_surface(*object.mesh, normal_rule(shading), shading.crease_angle)->positions.size());
  return count;
}

double triangles(const MeasureInput& in) {
  double count = 0;
  for (const Object& object : in.scene.objects)
    if (object.visible && object.mesh) count += double(object.mesh->triangles().size());
  return count;
}

constexpr std::array table{
    Measurement{"n-dot-l",
                {"N·L at a pixel", "画素の N·L"},
                "1",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).n_dot_l; }},
    Measurement{"lobe-cosine",
                {"N·H or R·V at a pixel", "画素の N·H または R·V"},
                "1",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).lobe_cosine; }},
    Measurement{"lobe",
                {"(N·H)^n or (R·V)^n at a pixel", "画素の (N·H)^n または (R·V)^n"},
                "1",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).lobe; }},
    Measurement{"attenuation",
                {"Attenuation at a pixel", "画素での減衰"},
                "1",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).attenuation; }},
    Measurement{"distance",
                {"Distance of the light from a pixel's point", "画素に写る点から光源までの距離"},
                "m",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).distance; }},
    Measurement{"spot",
                {"Factor of the spot at a pixel", "画素でのスポットの係数"},
                "1",
                {"x, y; light", "x、y、light"},
                [](const MeasureInput& in) { return factors(in).spot; }},
    Measurement{"point",
                {"Coordinate of the point at a pixel", "画素に写る点の座標"},
                "1",
                {"x, y; space, component", "x、y、space、component"},
                point},
    Measurement{"vertex",
                {"Coordinate of a vertex", "頂点の座標"},
                "1",
                {"object, vertex; space, component", "object、vertex、space、component"},
                vertex},
    Measurement{"vertex-normal",
                {"Normal of a vertex", "頂点の法線"},
                "1",
                {"object, vertex; space (world or eye), component", "object、vertex、space（world か eye）、component"},
                vertex_normal},
    Measurement{"lit-vertices", {"Vertices that are lit", "光を計算する頂点の数"}, "1", {"—", "—"}, lit_vertices},
    Measurement{"triangles", {"Triangles that are drawn", "描く三角形の数"}, "1", {"—", "—"}, triangles},
    Measurement{"vertex-light",
                {"Light computed at a vertex", "頂点で計算した光"},
                "1",
                {"object, vertex; channel; term, light", "object、vertex、channel、term、light"},
                vertex_light},
};

}  // namespace

std::span<const Measurement> point_measurements() { return table; }

}  // namespace cg
