#include "shading/fixed_function_scene.h"

#include <algorithm>

#include "shading/ambient_term.h"
#include "shading/light_model.h"

namespace cg {

namespace {

// glColor does nothing where GL_COLOR_MATERIAL is not enabled, and what it was to set nobody else has set either.
void ignore_color(Material& m, ColorMaterial tracked) {
  const glm::dvec3 k_a(0.2), k_d(0.8), black(0);  // GL 2.1, table 2.10
  const bool both = tracked == ColorMaterial::off || tracked == ColorMaterial::ambient_and_diffuse;
  if (both || tracked == ColorMaterial::ambient) m.k_a = k_a;
  if (both || tracked == ColorMaterial::diffuse) m.k_d = k_d;
  if (tracked == ColorMaterial::specular) m.k_s = black;
  if (tracked == ColorMaterial::emission) m.emission = black;
}

}  // namespace

Scene as_fixed_function(Scene scene) {
  if (!drawn_field(scene, DrawnBy::fixed_function)) scene.shading.ambient_source = AmbientSource::constant;
  const auto edit = [&](Material& m) {
    m.n = std::min(m.n, gl_shininess_limit);
    if (scene.mistakes.no_color_material) ignore_color(m, scene.shading.color_material);
  };
  edit(scene.material);
  for (Object& object : scene.objects) edit(object.material);
  if (scene.mistakes.no_color_material) scene.shading.color_material = ColorMaterial::off;
  if (scene.mistakes.no_normalize) scene.shading.normal_length = NormalLength::off;
  const auto lit = lighting_in_eye_space<double>(scene, view_matrix(scene.camera)).lights;
  for (std::size_t i = std::size_t(gl_light_limit); i < lit.size(); ++i)
    scene.lights[std::size_t(lit[i].index)].enabled = false;
  return scene;
}

Scene with_mistaken_lights(Scene scene) {
  if (scene.mistakes.directional_w)
    for (Light& light : scene.lights) light.w = 0;
  // Eye coordinates are those of a camera that was never moved.
  if (scene.mistakes.light_before_view)
    scene.camera.position = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
  return scene;
}

}  // namespace cg
