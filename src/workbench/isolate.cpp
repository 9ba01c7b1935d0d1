#include "workbench/isolate.h"

#include "shading/ambient_term.h"

namespace cg {

namespace {

constexpr glm::dvec3 black{0};

// Colour material would bring back what is zeroed: the tracked reflectances are written into the material.
void resolve_color_material(Material& m, ColorMaterial tracked) {
  const EyeMaterial<double> k = eye_material<double>(m, tracked);
  m.k_a = k.k_a, m.k_d = k.k_d, m.k_s = k.k_s, m.emission = k.emission;
}

void keep(Material& m, Quantity term, bool emission) {
  if (term != Quantity::none && term != Quantity::ambient) m.k_a = black;
  if (term != Quantity::none && term != Quantity::diffuse) m.k_d = black;
  if (term != Quantity::none && term != Quantity::specular) m.k_s = black;
  if (term != Quantity::none && term != Quantity::reflection) m.k_r = black;
  if (term != Quantity::none && term != Quantity::transmission) m.k_t = black;
  if (!emission) m.emission = black;
}

// The elements stay and their light goes: the other terms are those of the same vertices.
void leave_radiosity_out(Scene& scene) {
  const RadiosityField* field = drawn_field(scene);
  if (!field) return;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Object& object = scene.objects[i];
    if (!field->objects[i].mesh) continue;
    object.material = material_of(scene, object), object.own_material = true;
    object.material.k_a = black;
    object.mesh = field->objects[i].mesh, object.model.clear();  // no name would bring that mesh back
  }
  scene.shading.ambient_source = AmbientSource::constant;
}

}  // namespace

Scene isolated(Scene scene, Quantity term, int light) {
  if (term == Quantity::none && light == all_lights) return scene;
  const bool emission = (term == Quantity::none || term == Quantity::emission) && light < 0;
  const auto edit = [&](Material& m) {
    resolve_color_material(m, scene.shading.color_material);
    keep(m, term, emission);
  };
  edit(scene.material);
  for (Object& object : scene.objects) edit(object.material);
  scene.shading.color_material = ColorMaterial::off;
  if (light >= 0 || (term != Quantity::none && term != Quantity::ambient)) leave_radiosity_out(scene);
  if (light >= 0) scene.shading.ambient = black;
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (light != all_lights && int(i) != light) scene.lights[i].enabled = false;
  return scene;
}

}  // namespace cg
