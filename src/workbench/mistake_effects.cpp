#include "workbench/mistake_effects.h"

#include <cmath>

#include "params/numbers.h"
#include "shading/eye_normal.h"
#include "shading/surface_cache.h"
#include "workbench/mistake_scene.h"

namespace cg {

namespace {

MistakeObject object_of(const Scene& scene, int index, const glm::dmat4& view) {
  const Object& object = scene.objects[std::size_t(index)];
  MistakeObject out;
  out.index = index;
  out.surface = surface_cache().get(object.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
  out.to_world = matrix(object.transform) * out.surface->to_mesh();
  const glm::dmat4 to_eye = view * out.to_world;
  const auto normals = normals_to_eye<double>(view * matrix(object.transform), scene.shading.normal_length);
  glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
  for (std::size_t i = 0; i < out.surface->positions.size(); ++i) {
    const glm::dvec3 p(out.surface->positions[i]);
    low = glm::min(low, p), high = glm::max(high, p);
    out.P.emplace_back(to_eye * glm::dvec4(p, 1));
    out.N.push_back(eye_normal(normals, glm::dvec3(out.surface->normals[i])));
  }
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    out.box.emplace_back(out.to_world * glm::dvec4(p, 1));
  }
  out.middle = glm::dvec3(out.to_world * glm::dvec4((low + high) * 0.5, 1));
  return out;
}

MistakeEffect hidden(Words why) { return {.shows = false, .value = 0, .text = why}; }

}  // namespace

MistakeScene::MistakeScene(const Scene& given)
    : scene(given),
      view(view_matrix(given.camera)),
      world_lights(lighting_in_eye_space<double>(given, glm::dmat4(1))),
      eye_lights(lighting_in_eye_space<double>(given, view)) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!object.visible || !object.mesh) continue;
    MistakeObject o = object_of(scene, int(i), view);
    if (o.surface->triangle_count() > 0) objects.push_back(std::move(o));
  }
}

std::string short_number(double v) {
  if (v == 0 || !std::isfinite(v)) return number_text(v);
  const double step = std::pow(10, 2 - std::floor(std::log10(std::abs(v))));
  return number_text(std::round(v * step) / step);
}

std::string percent(double share) { return short_number(share * 100) + "%"; }

std::optional<MistakeEffect> mistake_effect(const Scene& scene, std::string_view mistake, const View& view) {
  using Effect = MistakeEffect (*)(const MistakeScene&);
  using PictureEffect = MistakeEffect (*)(const MistakeScene&, const View&);
  static constexpr std::pair<std::string_view, Effect> of_lights[] = {
      {"light_before_view", light_before_view_effect}, {"directional_w", directional_w_effect},
      {"flipped_normals", flipped_normals_effect},     {"no_normals", no_normals_effect},
      {"no_normalize", no_normalize_effect},           {"no_gate", no_gate_effect},
      {"long_light_vector", long_light_vector_effect}, {"no_color_material", no_color_material_effect}};
  static constexpr std::pair<std::string_view, PictureEffect> of_pictures[] = {
      {"no_depth_test", no_depth_test_effect}, {"swapped_front_face", swapped_front_face_effect}};
  const auto of = [&](const auto& list) {
    return std::find_if(std::begin(list), std::end(list), [&](const auto& e) { return e.first == mistake; });
  };
  const auto light = of(of_lights);
  const auto picture = of(of_pictures);
  if (light == std::end(of_lights) && picture == std::end(of_pictures)) return std::nullopt;
  const MistakeScene s(scene);
  if (s.objects.empty())
    return hidden({"Nothing is drawn here: open a model to see it.", "描かれる物体がない。モデルを開けば見える。"});
  if (picture != std::end(of_pictures)) return picture->second(s, view);
  if (s.world_lights.lights.empty())
    return hidden({"No light is on: switch one on to see it.", "点灯した光源がない。点ければ見える。"});
  return light->second(s);
}

}  // namespace cg
