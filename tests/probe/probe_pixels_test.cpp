// The probe against the pictures: at random pixels of three scenes, in every technique and shading mode, the terms
// come to what was drawn, within 1e-5 in software and 1/255 in OpenGL.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "gl/techniques.h"
#include "params/slots.h"
#include "raster/software.h"
#include "workbench/isolate.h"
#include "workbench/open.h"
#include "workbench/probe.h"

namespace cg {
namespace {

constexpr int pixels = 200;
constexpr double software_limit = 1e-5, gl_limit = 1.0 / 255;

Light light_at(LightKind kind, const glm::dvec3& position, const glm::dvec3& colour) {
  Light light;
  light.kind = kind, light.position = position;
  light.diffuse = colour, light.specular = colour * 0.8, light.ambient = colour * 0.05;
  return light;
}

// Lights of all kinds, with colours, attenuation and a soft cone; the viewer near.
Scene many_lights() {
  Scene scene = open_scene("teapot");
  scene.material.k_d = {0.6, 0.4, 0.25}, scene.material.k_s = {0.4, 0.45, 0.5}, scene.material.n = 24;
  scene.material.emission = {0.02, 0.01, 0.03};
  scene.lights = {light_at(LightKind::directional, {1, 2, 3}, {0.5, 0.5, 0.4}),
                  light_at(LightKind::point, {-2, 1, 2}, {0.4, 0.6, 1.0}),
                  light_at(LightKind::spot, {1.5, 2, 2.5}, {1.0, 0.6, 0.5})};
  scene.lights[1].k_0 = 0.5, scene.lights[1].k_1 = 0.2, scene.lights[1].k_2 = 0.05;
  scene.lights[2].direction = {-1.5, -2, -2.4}, scene.lights[2].cutoff = 25, scene.lights[2].exponent = 8;
  scene.shading.local_viewer = true;
  return scene;
}

// Three objects, one mirrored, one flattened and shinier than OpenGL can say, seen from so near that the view volume
// cuts them; both sides lit.
Scene many_objects() {
  Scene scene = open_scene("torus");
  const Scene sphere = open_scene("icosphere"), plane = open_scene("plane");
  scene.objects.push_back(sphere.objects[0]);
  scene.objects.push_back(plane.objects[0]);
  scene.objects[0].transform.scale = {-1, 1, 1}, scene.objects[0].transform.rotate = {40, 10, 0};
  scene.objects[1].transform.scale = {0.8, 0.3, 0.5}, scene.objects[1].transform.translate = {0.2, 0.3, 0.1};
  scene.objects[2].transform.scale = {3, 3, 3}, scene.objects[2].transform.translate = {0, -0.6, 0};
  scene.objects[1].own_material = true;
  scene.objects[1].material.k_d = {0.2, 0.7, 0.3}, scene.objects[1].material.n = 200;
  scene.lights = {light_at(LightKind::point, {2, 2, 1}, {0.9, 0.9, 0.9}),
                  light_at(LightKind::directional, {-1, -1, 0.5}, {0.3, 0.2, 0.4})};
  scene.camera.position = {0.4, 0.5, 1.1}, scene.camera.near_plane = 0.3;
  scene.shading.two_sided = true;
  scene.display.background = {0.1, 0.2, 0.3};
  return scene;
}

// A scaled object whose normals keep the scale, without clamping, through glColor.
Scene scaled() {
  Scene scene = open_scene("torus-knot");
  scene.objects[0].transform.scale = {0.9, 1.1, 1.3};
  scene.shading.normal_length = NormalLength::off;
  scene.shading.clamp = false;
  scene.shading.color_material = ColorMaterial::ambient_and_diffuse;
  scene.material.color = {0.7, 0.3, 0.2}, scene.material.n = 12;
  scene.lights = {light_at(LightKind::point, {3, 4, 5}, {1.2, 1.1, 1.0}),
                  light_at(LightKind::spot, {-2, 1, 2}, {0.5, 0.7, 0.9})};
  scene.lights[1].direction = {2, -1, -2}, scene.lights[1].cutoff = 60;
  scene.camera.position = {1, 1, 5};
  return scene;
}

struct Worst {
  double error = 0;
  std::string where;
};

// Nine of ten pixels are covered ones.
std::vector<glm::ivec2> some_pixels(const Frame& frame, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<glm::ivec2> out;
  while (int(out.size()) < pixels) {
    const glm::ivec2 at(int(random() % unsigned(frame.colour.width())),
                        int(random() % unsigned(frame.colour.height())));
    if (frame.covered.at(at.x, at.y) || out.size() % 10 == 0) out.push_back(at);
  }
  return out;
}

Worst worst_of(const Scene& scene, const Technique& technique, bool ids, unsigned seed) {
  View view;
  view.width = 320, view.height = 240, view.ids = ids;
  Progress progress;
  const Frame frame = technique.render(scene, technique.plan(scene, view), view, progress);
  Worst worst;
  for (const glm::ivec2 at : some_pixels(frame, seed)) {
    const Probe p = probe_with_numbers(scene, technique, view, frame, at, progress);
    EXPECT_EQ(p.covered, frame.covered.at(at.x, at.y) != 0);
    EXPECT_EQ(p.covered, p.object >= 0);
    glm::dvec3 sum(0);
    for (const ProbedTerm& term : p.terms) sum += term.rgb;
    EXPECT_LT(glm::distance(sum, p.sum), 1e-12);
    // Where nothing was clamped the terms themselves come to the colour; else what clamping left of them.
    const bool clamped = p.covered && p.clamps && glm::distance(p.sum, p.clamped) > 1e-9;
    const glm::dvec3 result = clamped ? p.clamped : sum;
    if (p.mode != ShadingMode::gouraud && clamped) {
      EXPECT_EQ(result, saturate(sum));
    }
    for (int c = 0; c < 3; ++c)
      if (const double error = std::abs(result[c] - double(frame.colour.at(at.x, at.y)[c])); error > worst.error)
        worst = {error, std::to_string(at.x) + "," + std::to_string(at.y)};
  }
  return worst;
}

class ProbedPixels : public testing::TestWithParam<const char*> {
 protected:
  static Scene scene_of(const std::string& name) {
    return name == "many lights" ? many_lights() : name == "many objects" ? many_objects() : scaled();
  }
  static std::vector<Technique> techniques() {
    std::vector<Technique> all = gl_techniques();
    for (Technique& t : all) find_availability(t);
    all.push_back(software_technique());
    return all;
  }
  static void expect_small(const Scene& scene, const Technique& technique, bool ids, const std::string& what) {
    const bool software = technique.id == "software";
    const Worst worst = worst_of(scene, technique, ids, 7);
    const double limit = software ? software_limit : gl_limit;
    EXPECT_LE(worst.error, limit) << what << " at " << worst.where;
    std::printf("%-60s worst %.2e\n", what.c_str(), worst.error);
  }
};

TEST_P(ProbedPixels, TermsComeToWhatWasDrawn) {
  for (const Technique& technique : techniques()) {
    if (technique.unavailable) continue;
    for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
      for (const Precision precision : {Precision::single_precision, Precision::double_precision})
        for (const Reflection reflection : {Reflection::half_vector, Reflection::reflection_vector}) {
          Scene scene = scene_of(GetParam());
          scene.shading.mode = mode, scene.shading.precision = precision, scene.shading.reflection = reflection;
          if (technique.unsupported(scene)) continue;
          if (technique.id != "software" && precision == Precision::double_precision) continue;
          const std::string what =
              std::string(GetParam()) + ' ' + technique.id + ' ' +
              std::string(names_of<ShadingMode>[std::size_t(mode)].id) + ' ' +
              std::string(names_of<Reflection>[std::size_t(reflection)].id) + ' ' +
              (technique.id == "software" ? std::string(names_of<Precision>[std::size_t(precision)].id) : "");
          expect_small(scene, technique, true, what);
          expect_small(scene, technique, false, what + " by software's visibility");
        }
  }
}

TEST_P(ProbedPixels, OneTermAlone) {
  for (const Technique& technique : techniques()) {
    if (technique.unavailable) continue;
    for (const Quantity term : {Quantity::ambient, Quantity::diffuse, Quantity::specular}) {
      Scene scene = isolated(scene_of(GetParam()), term, 1);
      if (technique.unsupported(scene)) continue;
      expect_small(scene, technique, true, std::string(GetParam()) + ' ' + technique.id + " alone");
    }
  }
}

// The fixed function draws what the mistakes make of the scene, and so the probe says.
TEST_P(ProbedPixels, MistakesOfTheFixedFunction) {
  const std::vector<Technique> all = techniques();
  if (all[0].unavailable) GTEST_SKIP();
  ASSERT_EQ(all[0].id, "gl-fixed");
  Mistakes mistakes;
  for (const Slot& slot : slots(mistakes)) {
    bool& on = **std::get_if<bool*>(&slot.value);
    on = true;
    Scene scene = scene_of(GetParam());
    scene.mistakes = mistakes;
    on = false;
    expect_small(scene, all[0], true, std::string(GetParam()) + ' ' + slot.path);
    expect_small(scene, all[0], false, std::string(GetParam()) + ' ' + slot.path + " by software's visibility");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProbedPixels, testing::Values("many lights", "many objects", "scaled"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace cg
