// What a scene does not use is not in its shaders.
#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include "gl/gl_plan.h"
#include "gl_scenes.h"

namespace cg {
namespace {

ShaderSource shaders_of(const Scene& scene, const View& view = View{}) {
  const Plan plan = gl_plan(scene, view);
  return surface_shaders(shader_features(scene.shading, plan,
                                         lighting_in_eye_space<float>(scene, view_matrix(scene.camera)),
                                         eye_material<float>(scene.material, scene.shading.color_material)));
}

bool mentions(const ShaderSource& s, const char* word) {
  return s.vertex.find(word) != std::string::npos || s.fragment.find(word) != std::string::npos;
}

// A word of the shaders, the pass of the plan that it belongs to, and what switches both on.
struct Part {
  const char* word;
  const char* pass;
  std::function<void(Scene&, View&)> switch_on;
};

std::vector<Part> parts() {
  return {
      {"lobe_power", "highlights",
       [](Scene& s, View&) {
         s.material.k_s = {1, 1, 1};
       }},
      {"back", "two-sides", [](Scene& s, View&) { s.shading.two_sided = true; }},
      {"k_1", "attenuation", [](Scene& s, View&) { s.lights[0].kind = LightKind::point, s.lights[0].k_1 = 1; }},
      {"spot_cosine", "spot-cones", [](Scene& s, View&) { s.lights[0].kind = LightKind::spot; }},
      {"unit(-P)", "local-viewer",
       [](Scene& s, View&) {
         s.material.k_s = {1, 1, 1}, s.shading.local_viewer = true;
       }},
      {"gl_PrimitiveID", "ids", [](Scene&, View& v) { v.ids = true; }},
      {"normal_out", "normals", [](Scene&, View& v) { v.normals = true; }},
      {"return saturate(I)", "clamp", [](Scene& s, View&) { s.shading.clamp = true; }},
      {"facing", "pixel-lighting", [](Scene& s, View&) { s.shading.mode = ShadingMode::phong; }},
  };
}

Scene plain_scene() {
  Scene s = scene_with(sphere_mesh());
  s.lights[0].kind = LightKind::directional;
  s.material.k_s = {0, 0, 0};
  s.shading.clamp = false;
  return s;
}

TEST(ShaderSource, ThePlainestSceneHasNothingItDoesNotUse) {
  const Scene scene = plain_scene();
  const Plan plan = gl_plan(scene, View{});
  const ShaderSource source = shaders_of(scene);
  for (const Part& part : parts()) {
    EXPECT_FALSE(plan.runs(part.pass)) << part.pass;
    EXPECT_FALSE(mentions(source, part.word)) << part.word;
  }
  EXPECT_FALSE(mentions(source, "#if"));
  EXPECT_FALSE(mentions(source, "surface_to_eye"));
}

TEST(ShaderSource, EachPartComesAlone) {
  for (const Part& part : parts()) {
    Scene scene = plain_scene();
    View view;
    part.switch_on(scene, view);
    EXPECT_TRUE(gl_plan(scene, view).runs(part.pass)) << part.pass;
    EXPECT_TRUE(mentions(shaders_of(scene, view), part.word)) << part.word;
  }
}

TEST(ShaderSource, WithoutLightThereIsNoLight) {
  Scene scene = plain_scene();
  scene.lights.clear();
  const ShaderSource source = shaders_of(scene);
  EXPECT_FALSE(mentions(source, "lights["));
  EXPECT_FALSE(mentions(source, "normal"));
}

TEST(ShaderSource, LightIsInOneShaderOnly) {
  Scene scene = plain_scene();
  EXPECT_EQ(shaders_of(scene).fragment.find("light_point"), std::string::npos);
  scene.shading.mode = ShadingMode::phong;
  EXPECT_EQ(shaders_of(scene).vertex.find("light_point"), std::string::npos);
}

TEST(Specialise, ResolvesNestedConditions) {
  const std::string source =
      "a\n#ifdef X\nb\n#ifdef Y\nc\n#else\nd\n#endif\n#else\ne\n#endif\n#ifndef X\nf\n#endif\ng\n";
  EXPECT_EQ(specialise(source, {}), "a\ne\nf\ng\n");
  EXPECT_EQ(specialise(source, {{"X"}, 0}), "a\nb\nd\ng\n");
  EXPECT_EQ(specialise(source, {{"X", "Y"}, 0}), "a\nb\nc\ng\n");
  EXPECT_EQ(specialise(source, {{"Y"}, 0}), "a\ne\nf\ng\n");
}

TEST(GlPlan, EveryPassHasAReasonInBothLanguages) {
  for (auto* plan_of : {gl_plan, gl_fixed_plan})
    for (const bool on : {false, true}) {
      Scene scene = plain_scene();
      View view;
      if (on)
        for (const Part& part : parts()) part.switch_on(scene, view);
      if (!on) scene.objects.clear();
      for (const Pass& pass : plan_of(scene, view).passes) {
        EXPECT_FALSE(pass.reason.en.empty()) << pass.id;
        EXPECT_FALSE(pass.reason.ja.empty()) << pass.id;
        EXPECT_TRUE(pass.needed || pass.bytes == 0) << pass.id;
      }
    }
}

TEST(GlPlan, SaysWhichLimitsAreMet) {
  const auto notes = [](auto change) {
    Scene scene = scene_with(sphere_mesh());
    change(scene);
    return gl_fixed_plan(scene, View{}).notes.size();
  };
  EXPECT_EQ(notes([](Scene&) {}), 0u);
  EXPECT_EQ(notes([](Scene& s) { s.lights.resize(9, s.lights[0]); }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.material.n = 129; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.material.n = 0; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.lights[0].k_0 = 0; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.lights[0].position = {0, 0, 1e20}; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.lights[0].w = 1e-30, s.lights[0].position = {1, 1, 1}; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.objects[0].transform.scale.z = 0; }), 1u);
  EXPECT_EQ(notes([](Scene& s) { s.material.k_r = {1, 1, 1}; }), 1u);
}

}  // namespace
}  // namespace cg
