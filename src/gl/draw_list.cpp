#include "gl/draw_list.h"

#include "shading/clip_position.h"
#include "shading/surface_cache.h"

namespace cg {

namespace {

bool is_finite(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

bool some(const glm::dvec3& c) { return c != glm::dvec3(0); }

}  // namespace

std::vector<DrawItem> draw_list(const Scene& scene, const View& view) {
  const glm::dmat4 world_to_eye = view_matrix(scene.camera);
  const glm::mat4 to_clip = eye_to_clip(scene, view.width, view.height);
  std::vector<DrawItem> items;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!object.visible || !object.mesh) continue;
    const SurfaceHandle surface =
        surface_cache().get(object.mesh, normal_rule(scene.shading), scene.shading.crease_angle);
    if (surface->triangle_count() == 0) continue;
    const glm::mat4 to_eye(surface_to_eye(scene, object, *surface));
    if (!is_finite(to_eye) || !is_finite(surface_to_clip(to_clip, to_eye))) continue;
    items.push_back({int(i), surface, &material_of(scene, object), world_to_eye * matrix(object.transform), to_eye});
  }
  return items;
}

UsedTerms used_terms(const EyeLighting<double>& lighting, const EyeMaterial<double>& m) {
  UsedTerms u;
  for (const EyeLight<double>& light : lighting.lights) {
    u.diffuse = u.diffuse || (some(light.diffuse) && some(m.k_d));
    u.specular = u.specular || (some(light.specular) && some(m.k_s));
    (light.directional ? u.directional : u.point) = true;
    const bool plain = light.k_0 == 1 && light.k_1 == 0 && light.k_2 == 0;
    u.attenuation = u.attenuation || (!light.directional && !plain);
    u.spot = u.spot || light.spot_cosine > -2;
  }
  u.eye_position = u.point || (u.specular && lighting.local_viewer);
  return u;
}

UsedTerms used_terms(const Scene& scene) {
  const EyeLighting<double> lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  UsedTerms all;
  for (const Object& object : scene.objects) {
    if (!object.visible) continue;
    const UsedTerms u =
        used_terms(lighting, eye_material<double>(material_of(scene, object), scene.shading.color_material));
    all.diffuse |= u.diffuse, all.specular |= u.specular;
    all.point |= u.point, all.directional |= u.directional;
    all.attenuation |= u.attenuation, all.spot |= u.spot, all.eye_position |= u.eye_position;
  }
  return all;
}

}  // namespace cg
