// Extremes through the software pipeline that are seen in how one picture follows another.
#include <gtest/gtest.h>

#include "raster/software.h"
#include "scene/shape.h"

namespace cg {
namespace {

constexpr View picture{48, 48, 1, true, true};

Frame draw(const Scene& scene) {
  static const Technique software = software_technique();
  Progress progress;
  return software.render(scene, software.plan(scene, picture), picture, progress);
}

MeshHandle sphere() { return make_shape(*find_shape("uv-sphere"), 24); }

Scene scene_of(MeshHandle mesh) {
  Scene scene;
  scene.objects.emplace_back().mesh = std::move(mesh);
  scene.camera.position = {0, 0, 3.5};
  return scene;
}

// The largest difference of two pictures' colours; coverage must be the same but for `edge` pixels.
double largest_difference(const Frame& a, const Frame& b, int edge = 0) {
  double largest = 0;
  int mismatch = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    if (a.covered.pixels()[i] != b.covered.pixels()[i]) {
      ++mismatch;
      continue;
    }
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(a.colour.pixels()[i][c]) - double(b.colour.pixels()[i][c])));
  }
  EXPECT_LE(mismatch, edge);
  return largest;
}

// A light behind the eye, in each of its kinds, at the scene's middle.
Scene lit_by(LightKind kind) {
  Scene scene = scene_of(sphere());
  scene.shading.mode = ShadingMode::phong;
  scene.shading.clamp = false;
  scene.shading.ambient = glm::dvec3(0);
  scene.lights[0].kind = kind;
  scene.lights[0].position = {0, 0, 5};
  scene.lights[0].direction = {0, 0, -1};
  return scene;
}

TEST(Extremes, HighlightsThinWithTheExponent) {
  double previous = 1e9;
  for (const double n : {10.0, 128.0, 129.0, 1e4, 1e6}) {
    Scene scene = lit_by(LightKind::directional);
    scene.material.n = n;
    scene.material.k_d = glm::dvec3(0);
    double sum = 0;
    const Frame f = draw(scene);
    for (const glm::vec3& c : f.colour.pixels()) sum += c.r;
    EXPECT_LE(sum, previous);
    EXPECT_GE(sum, 0);
    previous = sum;
  }
}

TEST(Extremes, SpotCutOffs) {
  Scene scene = lit_by(LightKind::spot);
  scene.lights[0].cutoff = 180;
  const Frame open = draw(scene);
  scene.lights[0].cutoff = 90;
  EXPECT_EQ(largest_difference(draw(scene), open), 0);  // all of the ball lies in the half-space
  scene.lights[0].exponent = 128;
  scene.lights[0].cutoff = 0;
  std::size_t lit = 0;
  const Frame f = draw(scene);
  for (const glm::vec3& c : f.colour.pixels()) lit += c.r > 0;
  EXPECT_LE(lit, 1u);
}

TEST(Extremes, MirrorAndNonUniformScale) {
  Scene scene = scene_of(sphere());
  scene.shading.mode = ShadingMode::phong;  // the mirrored sphere's faces are cut along the other diagonal
  const Frame ordinary = draw(scene);
  scene.objects[0].transform.scale = {-1, 1, 1};
  EXPECT_LT(largest_difference(draw(scene), ordinary, 4), 0.02);
  // An ellipsoid's normals follow M^-T: (x, y, z) / (a^2, b^2, c^2).
  scene.objects[0].transform.scale = {1, 0.3, 1};
  const Frame f = draw(scene);
  const glm::vec3 n = f.normal.at(24, 20);
  EXPECT_NEAR(glm::length(n), 1, 1e-5);
  EXPECT_GT(n.y, 0.5f);
}

TEST(Extremes, TwentyLightsOfATwentiethAreOne) {
  Scene one = lit_by(LightKind::point), many = one;
  one.lights[0].diffuse = one.lights[0].specular = glm::dvec3(1);
  many.lights.assign(20, one.lights[0]);
  for (Light& l : many.lights) l.diffuse = l.specular = glm::dvec3(1.0 / 20);
  EXPECT_LT(largest_difference(draw(many), draw(one)), 1e-6);
}

}  // namespace
}  // namespace cg
