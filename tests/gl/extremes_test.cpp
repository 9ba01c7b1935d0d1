// Sizes, by each rule for the normals' length: every frame is finite and, where OpenGL can say it at all, right (to
// 2/255 of the colour, or of 1 where the colour is darker), clamped and not.
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
        const ReferenceError errors = against_reference(scene, frame);
        EXPECT_LT(errors.largest, limit) << e.name << ", mode " << int(mode) << ", " << errors.pixels << " pixels";
      }
  }
};

TEST_P(Extremes, Surfaces) { check(surfaces()); }

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

// I = E + I_a k_a, a constant: no interpolation, so to rounding.
TEST_P(Extremes, WithoutLightOnlyAmbientAndEmission) {
  Scene scene = scene_with(sphere_mesh());
  scene.shading.ambient = {0.3, 0.5, 0.7}, scene.material.k_a = {0.9, 0.4, 0.2},
  scene.material.emission = {0.1, 0, 0.3};
  const glm::dvec3 right = scene.material.emission + scene.shading.ambient * scene.material.k_a;
  const std::vector<Technique> techniques = gl_techniques();
  const Technique& t = find(techniques, GetParam());
  for (const bool switched_off : {false, true})
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong}) {
      scene.lights.assign(switched_off ? 9 : 0, Light{});
      for (Light& light : scene.lights) light.enabled = false;
      scene.shading.mode = mode;
      if (t.unsupported(scene)) continue;
      const Frame frame = draw(t, scene, view_of(64, 64, true));
      std::size_t covered = 0;
      for (std::size_t i = 0; i < frame.covered.pixels().size(); ++i) {
        if (!frame.covered.pixels()[i]) continue;
        ++covered;
        const glm::dvec3 off = glm::abs(glm::dvec3(frame.colour.pixels()[i]) - right);
        ASSERT_LT(std::max({off.r, off.g, off.b}), 1e-6) << "mode " << int(mode);
      }
      EXPECT_GT(covered, 500u);
    }
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
