// Extreme values: every frame is finite and, where OpenGL can say it at all, right (to 2/255 of the colour, or of 1
// where the colour is darker), clamped and not.
#include <gtest/gtest.h>

#include "gl_scenes.h"

namespace cg {
namespace {

constexpr double tolerance = 2.0 / 255;
constexpr double not_compared = 1e30;

struct Extreme {
  std::string name;
  std::function<void(Scene&)> change;
  double fixed = tolerance, glsl = tolerance;  // what the two may be off by
};

// The first light stands in a vertex of the sphere, or as near as `away` to it: there rounding decides the direction
// to the light, so that only finiteness can be asked for.
void light_at_a_vertex(Scene& s, double away) {
  s.lights[0].position = glm::dvec3(0, 1 + away, 0);
  s.lights[0].k_2 = 1;
}

std::vector<Extreme> lights_in_odd_places() {
  std::vector<Extreme> all{
      {"light at a vertex", [](Scene& s) { light_at_a_vertex(s, 0); }, not_compared, not_compared},
      {"light 1e-20 from a vertex", [](Scene& s) { light_at_a_vertex(s, 1e-20); }, not_compared, not_compared},
      {"light inside",
       [](Scene& s) {
         s.lights[0].position = {0, 0, 0};
       }},
      {"light behind",
       [](Scene& s) {
         s.lights[0].position = {0, 0, -5};
       }},
      {"light at the eye", [](Scene& s) { s.lights[0].position = s.camera.position; }},
      {"light in the plane of the faces",
       [](Scene& s) {
         s.objects[0].mesh = square_mesh(), s.lights[0].position = {3, 0, 0}, s.camera.position = {0, 0, 4};
       }},
      {"attenuation 0, 0, 0", [](Scene& s) { s.lights[0].k_0 = 0; }},
      {"attenuation 1e20", [](Scene& s) { s.lights[0].k_0 = s.lights[0].k_1 = s.lights[0].k_2 = 1e20; }},
      {"quadratic and 1e20 away",
       [](Scene& s) {
         s.lights[0].position = {0, 0, 2e20}, s.lights[0].k_2 = 1;
       }},
      {"far and dark",
       [](Scene& s) {
         s.lights[0].k_0 = 0, s.lights[0].k_2 = 1e-36, s.lights[0].position = {0, 0, 1e18};
       }},
  };
  for (const double d : {1e-30, 1e-20, 1e-10, 1e10, 1e18, 1e20, 1e30})
    all.push_back({"light at " + std::to_string(std::log10(d)),
                   [d](Scene& s) { s.lights[0].position = glm::dvec3(0.6, 0.3, 0.5) * d; }});
  for (const double w : {0.0, 1e-30, 1e-6, -1.0, 1e20, 1e-20})
    for (const LightKind kind : {LightKind::point, LightKind::spot, LightKind::directional})
      all.push_back({"w", [w, kind](Scene& s) {
                       s.lights[0].w = w, s.lights[0].kind = kind, s.lights[0].cutoff = 75;
                       s.lights[0].position = {2, 3, 2}, s.lights[0].direction = {-2, -3, -2};
                     }});
  all.push_back({"zero position, w = 0", [](Scene& s) { s.lights[0].position = {0, 0, 0}, s.lights[0].w = 0; }});
  return all;
}

std::vector<Extreme> cones() {
  std::vector<Extreme> all;
  for (const double cutoff : {0.0, 1e-3, 90.0, 180.0})
    for (const double exponent : {0.0, 128.0})
      for (const LightKind kind : {LightKind::spot, LightKind::directional})
        all.push_back({"cut-off " + std::to_string(cutoff), [=](Scene& s) {
                         s.lights[0].kind = kind, s.lights[0].cutoff = cutoff, s.lights[0].exponent = exponent;
                         s.lights[0].position = {1, 1, 3}, s.lights[0].direction = {-1, -1.1, -3};
                       }});
  all.push_back({"no axis", [](Scene& s) {
                   s.lights[0].kind = LightKind::spot, s.lights[0].direction = {0, 0, 0}, s.lights[0].cutoff = 90;
                 }});
  return all;
}

std::vector<Extreme> surfaces() {
  std::vector<Extreme> all;
  for (const double size : {1e-30, 1e-20, 1e-9, 1e-4, 1e4, 1e9, 1e20})
    for (const NormalLength length : {NormalLength::normalize, NormalLength::rescale, NormalLength::off}) {
      const auto scaled = [=](Scene& s) {
        s.camera.position *= size, s.camera.near_plane = size, s.camera.far_plane = 10 * size;
        s.lights[0].position = glm::dvec3(2, 3, 4) * size;
        s.shading.normal_length = length;
      };
      all.push_back({"mesh of size 1e" + std::to_string(std::log10(size)), [=](Scene& s) {
                       scaled(s);
                       s.objects[0].mesh = sphere_mesh(24, 12, size);
                     }});
      if (length != NormalLength::off)
        all.push_back({"scaled by 1e" + std::to_string(std::log10(size)), [=](Scene& s) {
                         scaled(s);
                         s.objects[0].transform.scale = glm::dvec3(size);
                       }});
    }
  for (const double offset : {1e6, 1e9})
    all.push_back({"offset", [=](Scene& s) {
                     const glm::dvec3 o(offset, -offset, offset / 2);
                     s.objects[0].mesh = sphere_mesh(24, 12, 1, o);
                     s.camera.position += o, s.camera.target += o, s.lights[0].position += o;
                   }});
  all.push_back({"stretched", [](Scene& s) { s.objects[0].transform.scale = {1, 1e-3, 1}; }});
  all.push_back({"mirrored twice", [](Scene& s) { s.objects[0].transform.scale = {-1, -1, 1}; }});
  all.push_back({"flat", [](Scene& s) { s.objects[0].transform.scale = {1, 1, 0}; }, not_compared, tolerance});
  all.push_back({"scaled to nothing", [](Scene& s) { s.objects[0].transform.scale = {0, 0, 0}; }});
  all.push_back({"normals of length 1e-19", [](Scene& s) {
                   s.shading.normal_length = NormalLength::off, s.objects[0].transform.scale = glm::dvec3(1e19);
                   s.camera.position *= 1e19, s.camera.near_plane = 1e19, s.camera.far_plane = 1e20;
                 }});
  return all;
}

std::vector<Extreme> colours_and_exponents() {
  std::vector<Extreme> all{
      {"no light", [](Scene& s) { s.lights.clear(); }},
      {"lights switched off", [](Scene& s) { s.lights[0].enabled = false; }},
      {"nine lights", [](Scene& s) { s.lights.resize(9, s.lights[0]); }, not_compared, tolerance},
      {"64 lights", [](Scene& s) { s.lights.resize(64, s.lights[0]); }, not_compared, tolerance},
      {"1e20",
       [](Scene& s) {
         s.lights[0].diffuse = {1e20, 1e20, 1e20};
       }},
      {"negative",
       [](Scene& s) {
         s.lights[0].diffuse = {-0.5, -0.5, 0.5};
       }},
      {"NaN", [](Scene& s) { s.lights[0].diffuse.g = std::nan(""); }},
      {"infinite", [](Scene& s) { s.lights[0].specular.g = HUGE_VAL; }},
      {"NaN place", [](Scene& s) { s.lights[0].position.g = std::nan(""); }},
  };
  for (const double n : {0.0, 1e-9, 128.0})
    all.push_back({"n = " + std::to_string(n), [n](Scene& s) { s.material.n = n; }});
  // Highlights smaller than a triangle: whether a vertex shows them is the same, and so is how far they are smeared.
  for (const double n : {129.0, 1e3, 1e4, 1e6})
    all.push_back({"n = " + std::to_string(n), [n](Scene& s) { s.material.n = n; }, not_compared, tolerance});
  return all;
}

class Extremes : public testing::TestWithParam<const char*> {
 protected:
  void check(const std::vector<Extreme>& all) {
    const std::vector<Technique> techniques = gl_techniques();
    const Technique& t = find(techniques, GetParam());
    const bool fixed = t.id == "gl-fixed";
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
      for (std::size_t i = 0; i < 2 * all.size(); ++i) {
        const Extreme& e = all[i / 2];
        Scene scene = scene_with(sphere_mesh());
        scene.material.n = 5;
        scene.shading.mode = mode;
        scene.shading.clamp = i % 2 == 0;
        e.change(scene);
        if (t.unsupported(scene)) continue;
        const Frame frame = draw(t, scene, view_of(64, 64, true));
        EXPECT_EQ(frame.nan_pixels, 0u) << e.name << ", mode " << int(mode);
        const double limit = fixed ? e.fixed : e.glsl;
        if (limit == not_compared) continue;
        const Errors errors = against_reference(scene, frame);
        EXPECT_LT(errors.largest, limit) << e.name << ", mode " << int(mode) << ", " << errors.pixels << " pixels";
      }
  }
};

TEST_P(Extremes, LightsInOddPlaces) { check(lights_in_odd_places()); }
TEST_P(Extremes, Cones) { check(cones()); }
TEST_P(Extremes, Surfaces) { check(surfaces()); }
TEST_P(Extremes, ColoursAndExponents) { check(colours_and_exponents()); }

// A file's own normals of any length, under GL_NORMALIZE; a normal of length 0 gets no diffuse and no specular light.
TEST_P(Extremes, LengthsOfAFilesNormals) {
  MeshData data = sphere_mesh()->data();
  const double lengths[] = {1, 1e-20, 1e20, 1e-30, 3e30, 0};
  for (std::size_t i = 0; i < data.positions.size(); ++i) data.normals.push_back(data.positions[i] * lengths[i % 6]);
  for (Corner& c : data.corners) c.normal = c.position;
  const std::vector<Technique> techniques = gl_techniques();
  const Technique& t = find(techniques, GetParam());
  Scene scene = scene_with(Mesh::make(std::move(data)));
  const View view = view_of(64, 64, true);
  const Frame frame = draw(t, scene, view);
  EXPECT_EQ(frame.nan_pixels, 0u);
  EXPECT_LT(against_reference(scene, frame).largest, tolerance);
  bool noted = false;
  for (const Text& note : t.plan(scene, view).notes) noted = noted || note.en.find("no normal") != std::string::npos;
  EXPECT_TRUE(noted);
}

TEST_P(Extremes, WhatIsInfiniteBecomesZeroAndIsCounted) {
  Scene scene = scene_with(sphere_mesh());
  scene.shading.clamp = false;
  scene.lights[0].diffuse = {1e20, 0, 0};
  scene.lights[0].k_0 = 0, scene.lights[0].k_1 = 1e-20;
  scene.lights.resize(4, scene.lights[0]);
  const std::vector<Technique> techniques = gl_techniques();
  const Frame frame = draw(find(techniques, GetParam()), scene, view_of(32, 32));
  EXPECT_GT(frame.nan_pixels, 0u);
  for (const glm::vec3& c : frame.colour.pixels()) ASSERT_TRUE(is_finite(c));
}

INSTANTIATE_TEST_SUITE_P(OpenGL, Extremes, testing::Values("gl-fixed", "gl"),
                         [](const auto& info) { return std::string(info.param) == "gl" ? "gl" : "gl_fixed"; });

}  // namespace
}  // namespace cg
