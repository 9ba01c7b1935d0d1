// Extremes of single parameters through the software pipeline: the right picture, not only a finite one.
#include <gtest/gtest.h>

#include "raster/software.h"
#include "scene/shape.h"
#include "shading/light_model.h"

namespace cg {
namespace {

constexpr View picture{48, 48, 1, true, true};

Frame draw(const Scene& scene) {
  static const Technique software = software_technique();
  Progress progress;
  return software.render(scene, software.plan(scene, picture), picture, progress);
}

MeshHandle sphere() { return make_shape(*find_shape("uv-sphere"), 24); }

MeshHandle changed(const MeshHandle& mesh, double scale, const glm::dvec3& offset, double normal_length = 1) {
  MeshData data = mesh->data();
  for (glm::dvec3& p : data.positions) p = p * scale + offset;
  for (glm::dvec3& n : data.normals) n *= normal_length;
  return Mesh::make(std::move(data));
}

Scene scene_of(MeshHandle mesh) {
  Scene scene;
  scene.objects.emplace_back().mesh = std::move(mesh);
  scene.camera.position = {0, 0, 3.5};
  return scene;
}

const glm::vec3& centre(const Frame& f) { return f.colour.at(24, 24); }

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

TEST(Extremes, ShininessZeroIsOneWhereverTheLightFalls) {
  Scene scene = lit_by(LightKind::directional);
  scene.material.k_d = glm::dvec3(0);
  scene.material.n = 0;
  for (const Precision p : {Precision::single_precision, Precision::double_precision}) {
    scene.shading.precision = p;
    const Frame f = draw(scene);
    for (std::size_t i = 0; i < f.colour.size(); ++i) {
      const bool lit = f.covered.pixels()[i] && f.normal.pixels()[i].z > 0.1f;
      EXPECT_NEAR(f.colour.pixels()[i].r, lit ? 0.5 : f.colour.pixels()[i].r, 1e-6);
    }
  }
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

TEST(Extremes, GrazingLightHasNoHighlight) {
  const Scene scene = lit_by(LightKind::directional);
  const auto lighting = lighting_in_eye_space<double>(scene, glm::dmat4(1));
  const auto m = eye_material<double>(scene.material, ColorMaterial::off);
  for (const double z : {0.0, -0.0, -1e-8})
    EXPECT_EQ(light_point(lighting, m, glm::dvec3(0), glm::dvec3(1, 0, z)), glm::dvec3(0)) << z;
}

TEST(Extremes, LightOnInBehindAndFarFromTheSurface) {
  for (const LightKind kind : {LightKind::point, LightKind::spot}) {
    Scene scene = lit_by(kind);
    scene.shading.mode = ShadingMode::gouraud;
    for (const glm::dvec3 p : {glm::dvec3(0, 0, 1), glm::dvec3(0), glm::dvec3(0, 0, -5)}) {
      scene.lights[0].position = p;
      EXPECT_EQ(draw(scene).nan_pixels, 0u);
    }
    scene.lights[0].position = {0, 0, -5};
    scene.lights[0].direction = {0, 0, 1};
    EXPECT_EQ(centre(draw(scene)), glm::vec3(0));
    // Infinitely far is directional.
    Scene far = lit_by(LightKind::point), directional = lit_by(LightKind::directional);
    far.lights[0].position = {0, 0, 1e20};
    EXPECT_LT(largest_difference(draw(far), draw(directional)), 1e-6);
    far.lights[0].k_2 = 1;  // and fades to nothing, without 0 times infinity
    EXPECT_LT(centre(draw(far)).r, 1e-30f);
  }
}

TEST(Extremes, AttenuationOfNothingIsNone) {
  Scene scene = lit_by(LightKind::point);
  const Frame none = draw(scene);
  scene.lights[0].k_0 = 0;
  EXPECT_EQ(largest_difference(draw(scene), none), 0);
  scene.lights[0].k_0 = 1e20;
  EXPECT_LT(centre(draw(scene)).r, 1e-19f);
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

TEST(Extremes, HomogeneousCoordinateOfTheLight) {
  Scene scene = lit_by(LightKind::point);
  const Frame directional = draw(lit_by(LightKind::directional));
  for (const double w : {0.0, 1e-30, 1e-7}) {
    scene.lights[0].w = w;
    EXPECT_EQ(largest_difference(draw(scene), directional), 0) << w;
  }
  scene.lights[0].w = -1;  // mirrored: now behind
  EXPECT_EQ(centre(draw(scene)), glm::vec3(0));
  scene.lights[0].w = 0;
  scene.lights[0].position = {0, 0, 0};
  EXPECT_EQ(centre(draw(scene)), glm::vec3(0));
}

TEST(Extremes, NormalsOfAnyLengthAreNormalized) {
  const Frame ordinary = draw(scene_of(sphere()));
  for (const double length : {1e-30, 1e-20, 1e20, 1e30})
    EXPECT_LT(largest_difference(draw(scene_of(changed(sphere(), 1, glm::dvec3(0), length))), ordinary), 2e-6)
        << length;
  const Frame without = draw(scene_of(changed(sphere(), 1, glm::dvec3(0), 0)));
  EXPECT_EQ(without.nan_pixels, 0u);
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

TEST(Extremes, CoordinatesOfAnySizeAndPlace) {
  for (const double scale : {1e-20, 1e-6, 1e6, 1e20}) {
    Scene unit = scene_of(sphere());
    unit.lights[0].kind = LightKind::directional;
    Scene scaled = unit;
    scaled.objects[0].mesh = changed(sphere(), scale, glm::dvec3(0));
    scaled.camera.position *= scale;
    scaled.camera.near_plane *= scale, scaled.camera.far_plane *= scale;
    EXPECT_LT(largest_difference(draw(scaled), draw(unit), 2), 1.0 / 255) << scale;
  }
  Scene unit = scene_of(sphere()), far = unit;
  const glm::dvec3 offset(1e6, -2e6, 3e6);
  far.objects[0].mesh = changed(sphere(), 1, offset);
  far.camera.position += offset, far.camera.target += offset, far.lights[0].position += offset;
  EXPECT_LT(largest_difference(draw(far), draw(unit), 2), 1.0 / 255);
}

TEST(Extremes, DegenerateCameras) {
  Scene scene = scene_of(sphere());
  scene.camera.target = scene.camera.position;  // then along -z
  EXPECT_GT(draw(scene).covered.at(24, 24), 0);
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, 1};  // parallel to the view
  EXPECT_GT(draw(scene).covered.at(24, 24), 0);
  scene.camera.near_plane = scene.camera.far_plane = 3;
  EXPECT_EQ(draw(scene).nan_pixels, 0u);
  for (const double near_plane : {1e-20, 1e-6, 1e20}) {
    scene.camera.near_plane = near_plane;
    EXPECT_EQ(draw(scene).nan_pixels, 0u) << near_plane;
  }
}

TEST(Extremes, EyeInsideTheObjectSeesItsInside) {
  Scene scene = scene_of(sphere());
  scene.camera.position = {0, 0, 0.1};
  const Frame f = draw(scene);
  for (const std::uint8_t c : f.covered.pixels()) EXPECT_EQ(c, 1);
}

TEST(Extremes, NoLightsAndMany) {
  Scene scene = scene_of(sphere());
  scene.lights.clear();
  EXPECT_NEAR(centre(draw(scene)).r, 0.2 * 0.2, 1e-7);
  Scene one = lit_by(LightKind::point), many = one;
  one.lights[0].diffuse = one.lights[0].specular = glm::dvec3(1);
  many.lights.assign(20, one.lights[0]);
  for (Light& l : many.lights) l.diffuse = l.specular = glm::dvec3(1.0 / 20);
  EXPECT_LT(largest_difference(draw(many), draw(one)), 1e-6);
}

TEST(Extremes, IntensitiesWithoutLimit) {
  Scene scene = lit_by(LightKind::point);
  scene.lights[0].diffuse = glm::dvec3(1e20);
  EXPECT_GT(centre(draw(scene)).r, 1e19f);
  scene.shading.clamp = true;
  EXPECT_EQ(centre(draw(scene)), glm::vec3(1));
  scene.lights[0].diffuse = glm::dvec3(-1e20);
  EXPECT_EQ(centre(draw(scene)), glm::vec3(0));
  scene.lights[0].diffuse = glm::dvec3(std::nan(""));
  EXPECT_EQ(draw(scene).nan_pixels, 0u);  // such a light is left out
}

}  // namespace
}  // namespace cg
