// Eight points at once give what one point gives.
#include "shading/light_batch.h"

#include <gtest/gtest.h>

#include <random>

namespace cg {
namespace {

TEST(Power, AgainstTheLibrary) {
  for (const float n : {0.0f, 0.25f, 1.0f, 2.0f, 10.0f, 33.3f, 128.0f})
    for (float x = 1e-7f; x < 1.02f; x *= 1.0007f) {
      const double exact = std::pow(double(x), double(n));
      ASSERT_NEAR(power(x, n), exact, std::max(4e-6 * exact, 2e-7)) << x << '^' << n;
    }
}

TEST(Power, AtTheEndsOfItsRange) {
  EXPECT_EQ(power(0.0f, 0.0f), 1);
  EXPECT_LT(power(0.0f, 1.0f), 1e-37f);
  EXPECT_LT(power(-1.0f, 3.0f), 1e-37f);
  EXPECT_LT(power(std::nanf(""), 3.0f), 1e-37f);
  EXPECT_EQ(power(1.0f, 128.0f), 1);
}

template <class Real>
class LightBatch : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LightBatch, Reals);

Scene random_scene(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto vector = [&](double s) {
    return s * glm::dvec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
  };
  Scene scene;
  scene.lights.resize(std::size_t(1 + random() % 4));
  for (Light& l : scene.lights) {
    l.kind = LightKind(random() % 3);
    l.position = vector(10);
    l.direction = vector(1);
    l.cutoff = random() % 4 ? 90 * unit(random) : 180;
    l.exponent = random() % 2 ? 128 * unit(random) : 0;
    l.k_1 = unit(random), l.k_2 = unit(random);
  }
  scene.material.n = random() % 4 ? 128 * unit(random) : random() % 2 ? 0 : 1e5 * unit(random);
  scene.shading.reflection = Reflection(random() % 2);
  scene.shading.local_viewer = random() % 2;
  scene.shading.clamp = random() % 2;
  return scene;
}

TYPED_TEST(LightBatch, EqualsOnePointAtATime) {
  using Real = TypeParam;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3<Real>(Real(normal(random)), Real(normal(random)), Real(normal(random))); };
  for (int trial = 0; trial < 3000; ++trial) {
    const Scene scene = random_scene(random);
    const auto lighting = lighting_in_eye_space<Real>(scene, glm::dmat4(1));
    const auto material = eye_material<Real>(scene.material, ColorMaterial::off);
    EightVectors<Real> P, N, I;
    for (int i = 0; i < batch_size; ++i) P.set(i, vector()), N.set(i, unit(vector()));
    if (trial % 5 == 0) N.set(3, Vec3<Real>(0));
    if (trial % 7 == 0) P.set(2, Vec3<Real>(scene.lights[0].position));
    if (trial % 11 == 0) P.set(1, Real(1e20) * P.get(1));
    light_points(lighting, material, P, N, I);
    for (int i = 0; i < batch_size; ++i) {
      bool on_edge = false;  // of a spot's cone, where the two may differ
      const Vec3<Real> V = towards_viewer(lighting.local_viewer, P.get(i));
      for (const auto& light : lighting.lights) {
        const auto f = light_factors(light, lighting.reflection, material.n, P.get(i), N.get(i), V);
        on_edge = on_edge || std::abs(-glm::dot(f.L, light.spot_direction) - light.spot_cosine) < Real(1e-5) ||
                  std::abs(glm::dot(N.get(i), f.L)) < Real(1e-6);
      }
      const Vec3<Real> one = light_point(lighting, material, P.get(i), N.get(i));
      for (int c = 0; c < 3 && !on_edge; ++c)
        ASSERT_NEAR(I.get(i)[c], one[c], (sizeof(Real) == 4 ? 2e-5 : 1e-12) * (1 + std::abs(double(one[c])))) << trial;
    }
  }
}

}  // namespace
}  // namespace cg
