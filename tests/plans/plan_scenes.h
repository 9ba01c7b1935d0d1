// Scenes whose plans are held against what ran: plain, full, and odd ones.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tests/gl/gl_scenes.h"
#include "tests/radiosity_fields.h"

namespace cg {

// One mesh under one directional light that is diffuse: nothing else.
inline Scene plain_scene() {
  Scene s = scene_with(sphere_mesh());
  s.lights[0].kind = LightKind::directional;
  s.material.k_a = s.material.k_s = {0, 0, 0};
  s.shading.ambient = {0, 0, 0};
  s.shading.normal_length = NormalLength::off;
  s.shading.clamp = false;
  s.camera.position = {0, 1, 6};  // nothing is clipped
  return s;
}

// Everything that there is, at once: three kinds of light, two objects with materials of their own, both sides, a
// texture.
inline Scene full_scene() {
  Scene s = scene_with(sphere_mesh());
  s.objects.push_back(s.objects[0]);
  s.objects[1].mesh = square_mesh();
  s.objects[1].transform.translate = {1, 0, 0.5};
  s.objects[1].own_material = true;
  s.objects[1].material.emission = {0.1, 0, 0};
  s.objects[1].material.layers.emplace_back();
  s.objects[1].material.layers[0].texture = TextureImage::placeholder();
  s.objects[1].material.layers[0].uv = UvSource::projector;
  s.shading.transparency = Transparency::test;
  s.material.k_s = {0.5, 0.5, 0.5};
  s.lights.resize(3, s.lights[0]);
  s.lights[0].kind = LightKind::directional;
  s.lights[0].ambient = {0.1, 0.1, 0.1};
  s.lights[1].k_1 = 0.1;
  s.lights[2].kind = LightKind::spot;
  s.shading.local_viewer = s.shading.two_sided = true;
  s.camera.position = {0, 0, 1.5};  // something is clipped
  return s;
}

// The same, one object with light of a radiosity solution beside the other's constant ambient term.
inline Scene full_scene_with_radiosity() {
  Scene s = full_scene();
  s.radiosity_field = cut_field(s, 1, smooth_light, {1});
  s.shading.ambient_source = AmbientSource::radiosity;
  return s;
}

// A layer for each target that there is, their uv from three sources.
inline void add_textures(Scene& s) {
  Image<glm::u8vec4> texels(4, 4);
  for (int i = 0; i < 16; ++i) texels.at(i % 4, i / 4) = glm::u8vec4(16 * i, 255 - 16 * i, 128, i % 2 == 0 ? 255 : 60);
  const TextureHandle picture = TextureImage::make(texels, Encoding::as_stored);
  for (std::size_t target = 0; target < names_of<LayerTarget>.size(); ++target) {
    TextureLayer layer;
    layer.texture = picture;
    layer.target = LayerTarget(target);
    layer.uv = target % 2 == 0 ? UvSource::projector : target % 4 == 1 ? UvSource::mesh : UvSource::unwrap;
    s.material.layers.push_back(layer);
  }
}

struct OddScene {
  std::string name;
  std::function<void(Scene&)> change;  // of full_scene()
};

inline std::vector<OddScene> odd_scenes() {
  const auto mistake = [](bool Mistakes::*which) { return [which](Scene& s) { s.mistakes.*which = true; }; };
  return {
      {"plain", [](Scene& s) { s = plain_scene(); }},
      {"full", [](Scene&) {}},
      {"textures", add_textures},
      {"textures under an alpha test",
       [](Scene& s) {
         add_textures(s);
         s.shading.transparency = Transparency::test;
       }},
      {"textures of the normal alone",
       [](Scene& s) {
         add_textures(s);
         std::erase_if(s.material.layers, [](const TextureLayer& l) { return l.target != LayerTarget::normal; });
       }},
      {"no object", [](Scene& s) { s.objects.clear(); }},
      {"hidden", [](Scene& s) { s.objects[0].visible = s.objects[1].visible = false; }},
      {"mesh not loaded", [](Scene& s) { s.objects[0].mesh = nullptr; }},
      {"same mesh twice", [](Scene& s) { s.objects[1].mesh = s.objects[0].mesh; }},
      {"no light", [](Scene& s) { s.lights.clear(); }},
      {"lights off",
       [](Scene& s) {
         for (Light& l : s.lights) l.enabled = false;
       }},
      {"black lights",
       [](Scene& s) {
         for (Light& l : s.lights) l.ambient = l.diffuse = l.specular = {0, 0, 0};
       }},
      {"ambient lights",
       [](Scene& s) {
         for (Light& l : s.lights) l.diffuse = l.specular = {0, 0, 0};
       }},
      {"black material",
       [](Scene& s) {
         s.material.k_a = s.material.k_d = s.material.k_s = {0, 0, 0}, s.objects.pop_back();
       }},
      {"colours that do not meet",
       [](Scene& s) {
         s.material.k_s = {1, 0, 0};
         for (Light& l : s.lights) l.specular = {0, 1, 1};
         s.objects.pop_back();
       }},
      {"twelve lights", [](Scene& s) { s.lights.resize(12, s.lights[0]), s.lights[11].kind = LightKind::spot; }},
      {"ninth light alone is a spot",
       [](Scene& s) {
         s.lights.resize(9, s.lights[0]);
         for (Light& l : s.lights) l.kind = LightKind::directional;
         s.lights[8].kind = LightKind::spot;
       }},
      {"far away",
       [](Scene& s) {
         s.objects[0].transform.translate = {1e30, 0, 0};
       }},
      {"too far",
       [](Scene& s) {
         s.objects[0].transform.translate = {1e300, 0, 0};
       }},
      {"all too far",
       [](Scene& s) {
         s.objects[0].transform.translate = {1e300, 0, 0}, s.objects.pop_back();
       }},
      {"tiny",
       [](Scene& s) {
         s.objects[0].transform.scale = {1e-12, 1e-12, 1e-12};
       }},
      {"flat",
       [](Scene& s) {
         s.objects[0].transform.scale = {1, 0, 1};
       }},
      {"far light",
       [](Scene& s) {
         s.lights[1].position = {1e18, 1e18, 1e18};
       }},
      {"all in view",
       [](Scene& s) {
         s.camera.position = {0, 0, 9};
       }},
      {"inside",
       [](Scene& s) {
         s.camera.position = {0, 0, 0.1};
       }},
      {"behind",
       [](Scene& s) {
         s.camera.position = {0, 0, 20}, s.camera.target = {0, 0, 40};
       }},
      {"orthographic", [](Scene& s) { s.camera.projection = Projection::orthographic; }},
      {"NaN emission", [](Scene& s) { s.material.emission = glm::dvec3(std::nan("")); }},
      {"colour material", [](Scene& s) { s.shading.color_material = ColorMaterial::ambient_and_diffuse; }},
      {"colour material, specular", [](Scene& s) { s.shading.color_material = ColorMaterial::specular; }},
      {"reflection vector", [](Scene& s) { s.shading.reflection = Reflection::reflection_vector; }},
      {"normals as they come", [](Scene& s) { s.shading.normal_length = NormalLength::off; }},
      {"not clamped", [](Scene& s) { s.shading.clamp = false; }},
      {"w next to 0", [](Scene& s) { s.lights[1].w = 1e-30; }},
      {"attenuation 0 0 0", [](Scene& s) { s.lights[1].k_0 = s.lights[1].k_1 = s.lights[1].k_2 = 0; }},
      {"cone of 180 degrees", [](Scene& s) { s.lights[2].cutoff = 180; }},
      {"cone without an axis",
       [](Scene& s) {
         s.lights[2].direction = {0, 0, 0};
       }},
      {"n over 128", [](Scene& s) { s.material.n = 1000; }},
      {"radiosity", [](Scene& s) { take_radiosity(s); }},
      {"radiosity without a solution", [](Scene& s) { s.shading.ambient_source = AmbientSource::radiosity; }},
      {"radiosity that is not asked for",
       [](Scene& s) { take_radiosity(s), s.shading.ambient_source = AmbientSource::constant; }},
      {"radiosity of one object", [](Scene& s) { s = full_scene_with_radiosity(); }},
      {"radiosity of what is hidden",
       [](Scene& s) {
         s.radiosity_field = cut_field(s, 1, smooth_light, {0});
         s.shading.ambient_source = AmbientSource::radiosity, s.objects[0].visible = false;
       }},
      {"radiosity of other shapes", [](Scene& s) { take_radiosity(s), s.objects.pop_back(); }},
      {"radiosity of another mesh", [](Scene& s) { take_radiosity(s), s.objects[0].mesh = square_mesh(); }},
      {"radiosity that is NaN", [](Scene& s) { take_radiosity(s, [](auto...) { return glm::vec3(NAN); }); }},
      {"radiosity alone", [](Scene& s) { take_radiosity(s), s.lights.clear(); }},
      {"radiosity and colour material",
       [](Scene& s) { take_radiosity(s), s.shading.color_material = ColorMaterial::ambient_and_diffuse; }},
      {"radiosity and NaN emission",
       [](Scene& s) { take_radiosity(s), s.material.emission = glm::dvec3(std::nan("")); }},
      {"radiosity, mistake: no gate", [](Scene& s) { take_radiosity(s), s.mistakes.no_gate = true; }},
      {"radiosity, mistake: no colour material",
       [](Scene& s) { take_radiosity(s), s.mistakes.no_color_material = true; }},
      {"radiosity, mistake: flipped normals", [](Scene& s) { take_radiosity(s), s.mistakes.flipped_normals = true; }},
      {"mistake: no GL_NORMALIZE", mistake(&Mistakes::no_normalize)},
      {"mistake: no gate", mistake(&Mistakes::no_gate)},
      {"mistake: long L", mistake(&Mistakes::long_light_vector)},
      {"mistake: w = 0", mistake(&Mistakes::directional_w)},
      {"mistake: light before view", mistake(&Mistakes::light_before_view)},
      {"mistake: no colour material", mistake(&Mistakes::no_color_material)},
      {"mistake: flipped normals", mistake(&Mistakes::flipped_normals)},
      {"mistake: no normals", mistake(&Mistakes::no_normals)},
      {"mistake: no depth test", mistake(&Mistakes::no_depth_test)},
      {"mistake: swapped front face", mistake(&Mistakes::swapped_front_face)},
  };
}

}  // namespace cg
