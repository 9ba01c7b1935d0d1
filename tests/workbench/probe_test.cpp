// The probe against closed forms: a square that faces the eye, with one light.
#include "workbench/probe.h"

#include <gtest/gtest.h>

#include "params/input_error.h"
#include "raster/software.h"
#include "tests/square_mesh.h"
#include "workbench/isolate.h"

namespace cg {
namespace {

// Seen from z = 4 with parallel rays: pixel (x, y) of 64 shows ((x + 0.5)/16 - 2, 2 - (y + 0.5)/16, 0).
Scene square_scene(ShadingMode mode) {
  Scene scene;
  scene.objects.emplace_back();
  scene.objects[0].mesh = square_mesh();
  scene.camera.position = {0, 0, 4};
  scene.camera.projection = Projection::orthographic, scene.camera.height = 4;
  scene.material.k_a = {0.3, 0.3, 0.3}, scene.material.k_d = {0.5, 0.6, 0.7}, scene.material.k_s = {0.2, 0.2, 0.2};
  scene.material.n = 4;
  scene.shading.mode = mode;
  scene.shading.ambient = {0.1, 0.2, 0.3};
  scene.lights[0].position = {0, 0, 3};
  return scene;
}

Probe probe_of(const Scene& scene, glm::ivec2 pixel) {
  const Technique technique = software_technique();
  const View view{64, 64};
  Progress progress;
  const Frame frame = technique.render(scene, technique.plan(scene, view), view, progress);
  return probe(scene, technique, view, frame, pixel, progress);
}

const ProbedTerm& term(const std::vector<ProbedTerm>& all, std::string_view name, int light) {
  for (const ProbedTerm& t : all)
    if (t.name == name && t.light == light) return t;
  throw std::out_of_range(std::string(name));
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-7) {
  EXPECT_LT(glm::distance(a, b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Probe, PhongAtAPixel) {
  const Scene scene = square_scene(ShadingMode::phong);
  const Probe p = probe_of(scene, {40, 20});
  const glm::dvec3 P(40.5 / 16 - 2, 2 - 20.5 / 16, 0), L = unit(glm::dvec3(0, 0, 3) - P), V(0, 0, 1), H = unit(L + V),
                                                       R = 2 * L.z * V - L;
  ASSERT_TRUE(p.covered);
  EXPECT_EQ(p.object, 0);
  EXPECT_TRUE(p.front);
  EXPECT_TRUE(p.vertices.empty());
  expect_near(p.here.P, P, 1e-6);
  expect_near(p.here.N, V);
  expect_near(p.here.V, V);
  ASSERT_EQ(p.here.lights.size(), 1u);
  const ProbedLight& light = p.here.lights[0];
  expect_near(light.L, L, 1e-6);
  expect_near(light.R, R, 1e-6);
  expect_near(light.H, H, 1e-6);
  EXPECT_NEAR(light.n_dot_l, L.z, 1e-6);
  EXPECT_NEAR(light.lobe_cosine, H.z, 1e-6);
  EXPECT_NEAR(light.lobe, std::pow(H.z, 4), 1e-6);
  EXPECT_NEAR(light.distance, glm::length(glm::dvec3(0, 0, 3) - P), 1e-6);
  expect_near(term(p.terms, "global-ambient", -1).rgb, glm::dvec3(0.03, 0.06, 0.09));
  expect_near(term(p.terms, "diffuse", 0).rgb, scene.material.k_d * L.z, 1e-6);
  expect_near(term(p.terms, "specular", 0).rgb, glm::dvec3(0.2 * std::pow(H.z, 4)), 1e-6);
  expect_near(p.sum, p.frame, 1e-6);
}

TEST(Probe, GouraudClampsAtTheVertices) {
  Scene scene = square_scene(ShadingMode::gouraud);
  scene.lights[0].diffuse = {2, 2, 2};
  scene.lights[0].position = {1, 1, 0.5};  // over one corner, which it clamps
  const Probe p = probe_of(scene, {40, 20});
  ASSERT_EQ(p.vertices.size(), 3u);
  double weights = 0;
  glm::dvec3 sum(0), clamped(0);
  for (const LitPoint& v : p.vertices) {
    weights += v.weight;
    sum += v.weight * v.sum, clamped += v.weight * v.clamped;
    const glm::dvec3 L = unit(scene.lights[0].position - v.P);
    EXPECT_NEAR(v.lights[0].n_dot_l, L.z, 1e-6);
    expect_near(term(v.terms, "diffuse", 0).rgb, 2.0 * scene.material.k_d * L.z, 1e-6);
    expect_near(v.clamped, glm::min(v.sum, glm::dvec3(1)));
  }
  EXPECT_NEAR(weights, 1, 1e-9);
  expect_near(p.sum, sum, 1e-9);
  expect_near(p.clamped, clamped, 1e-9);
  expect_near(p.clamped, p.frame, 1e-6);
  EXPECT_GT(glm::distance(p.sum, p.clamped), 0.05);
}

TEST(Probe, FlatTakesTheLastVertex) {
  const Probe p = probe_of(square_scene(ShadingMode::flat), {40, 20});
  ASSERT_EQ(p.vertices.size(), 1u);
  expect_near(p.vertices[0].P, {-1, 1, 0});
  const double n_dot_l = 3 / std::sqrt(11.0);
  EXPECT_NEAR(p.vertices[0].lights[0].n_dot_l, n_dot_l, 1e-6);
  expect_near(term(p.terms, "diffuse", 0).rgb, glm::dvec3(0.5, 0.6, 0.7) * n_dot_l, 1e-6);
  expect_near(p.sum, p.frame, 1e-6);
}

TEST(Probe, TheBackIsLitWithTheNormalReversed) {
  Scene scene = square_scene(ShadingMode::phong);
  scene.objects[0].transform.rotate = {0, 180, 0};
  Probe p = probe_of(scene, {32, 32});
  EXPECT_FALSE(p.front);
  expect_near(p.here.N, {0, 0, -1});
  EXPECT_LT(p.here.lights[0].cosine, 0);
  EXPECT_EQ(p.here.lights[0].n_dot_l, 0);
  scene.shading.two_sided = true;
  p = probe_of(scene, {32, 32});
  expect_near(p.here.N, {0, 0, 1});
  EXPECT_GT(p.here.lights[0].n_dot_l, 0.9);
  expect_near(p.sum, p.frame, 1e-6);
}

TEST(Probe, AScaleWithoutNormalizeMakesTheNormalsShort) {
  Scene scene = square_scene(ShadingMode::phong);
  scene.objects[0].transform.scale = {2, 2, 2};
  scene.shading.normal_length = NormalLength::off;
  const Probe p = probe_of(scene, {32, 32});
  EXPECT_NEAR(p.here.normal_length, 0.5, 1e-9);
  expect_near(p.here.N, {0, 0, 1});
  EXPECT_NEAR(p.here.lights[0].n_dot_l, 0.5, 1e-3);
  expect_near(p.sum, p.frame, 1e-6);
}

TEST(Probe, TheBackgroundIsATermOfItsOwn) {
  Scene scene = square_scene(ShadingMode::phong);
  scene.display.background = {0.1, 0.2, 0.3};
  const Probe p = probe_of(scene, {2, 2});
  EXPECT_FALSE(p.covered);
  ASSERT_EQ(p.terms.size(), 1u);
  EXPECT_EQ(p.terms[0].name, "background");
  expect_near(p.sum, p.frame, 1e-7);
  EXPECT_EQ(p.depth, 1);
}

TEST(Probe, OneTermAloneIsAllThereIs) {
  const Probe p = probe_of(isolated(square_scene(ShadingMode::phong), Quantity::diffuse, 0), {40, 20});
  expect_near(p.sum, term(p.terms, "diffuse", 0).rgb);
  expect_near(p.sum, p.frame, 1e-6);
}

TEST(Probe, FixedFunctionEndsAt128) {
  Scene scene = square_scene(ShadingMode::gouraud);
  scene.material.n = 500;
  Technique fixed = software_technique();
  fixed.id = "gl-fixed";  // only its limits matter here
  const View view{64, 64};
  Progress progress;
  scene.lights.resize(9);
  const Frame frame = fixed.render(scene, fixed.plan(scene, view), view, progress);
  const Probe p = probe(scene, fixed, view, frame, {40, 20}, progress);
  EXPECT_EQ(p.material.n, 128);
  EXPECT_EQ(p.here.lights.size(), 8u);
}

TEST(Probe, OutsideThePictureIsAMistake) {
  EXPECT_THROW(probe_of(square_scene(ShadingMode::phong), {64, 0}), InputError);
  EXPECT_THROW(probe_of(square_scene(ShadingMode::phong), {0, -1}), InputError);
}

TEST(Probe, JsonHasWhatItPromises) {
  const Scene scene = square_scene(ShadingMode::gouraud);
  const Tree tree = parse_json(to_json(json_of(probe_of(scene, {40, 20}), scene)), "probe");
  for (const char* key : {"pixel", "technique", "terms", "sum", "clamped", "frame", "covered", "N", "V", "lights"})
    EXPECT_TRUE(tree.find(key)) << key;
  EXPECT_EQ(tree.find("vertices")->list()->size(), 3u);
  const Tree& light = tree.find("lights")->list()->at(0);
  for (const char* key : {"L", "R", "H", "n_dot_l", "n_dot_h", "lobe", "attenuation", "spot"})
    EXPECT_TRUE(light.find(key)) << key;
  for (const Tree& t : *tree.find("terms")->list())
    EXPECT_TRUE(t.find("name")->string() && t.find("light") && t.find("rgb")->list()->size() == 3);
}

TEST(Probe, TextIsWholeInBothLanguages) {
  const Scene scene = square_scene(ShadingMode::phong);
  const Probe p = probe_of(scene, {40, 20});
  EXPECT_NE(text_of(p, scene, Language::english).find("in the picture"), std::string::npos);
  EXPECT_NE(text_of(p, scene, Language::japanese).find("画像の値"), std::string::npos);
  EXPECT_EQ(text_of(p, scene, Language::japanese).find("light"), std::string::npos);
}

}  // namespace
}  // namespace cg
