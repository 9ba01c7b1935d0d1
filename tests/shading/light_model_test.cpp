// The light model against closed forms.
#include "shading/light_model.h"

#include <gtest/gtest.h>

namespace cg {
namespace {

// REFERENCES: the half-maximum half-angle of cos^n is acos(2^(-1/n)).
TEST(LobePower, HalfMaximumAngle) {
  for (double n : {1.0, 10.0, 100.0, 1e3, 1e4, 1e6}) {
    const double half = std::acos(std::pow(2.0, -1 / n));
    const glm::dvec3 a(0, 0, 1), b(std::sin(half), 0, std::cos(half));
    EXPECT_NEAR(lobe_power(a, b, b.z, n), 0.5, 1e-9) << n;
  }
}

TEST(LobePower, FloatKeepsLargeExponents) {
  for (float n : {1e4f, 1e5f, 1e6f}) {
    const double half = std::acos(std::pow(2.0, -1.0 / double(n)));
    const glm::vec3 a(0, 0, 1), b(float(std::sin(half)), 0, float(std::cos(half)));
    EXPECT_NEAR(lobe_power(a, b, b.z, n), 0.5f, 1e-3f) << n;
  }
}

TEST(LightModel, DefaultLightOnAFacingSurface) {
  Scene scene;
  scene.lights[0].kind = LightKind::directional;
  scene.lights[0].position = {0, 0, 5};
  const auto lighting = lighting_in_eye_space<double>(scene, glm::dmat4(1));
  const auto material = eye_material<double>(scene.material, ColorMaterial::off);
  const glm::dvec3 I = light_point(lighting, material, glm::dvec3(0, 0, -3), glm::dvec3(0, 0, 1));
  EXPECT_NEAR(I.r, 1.0, 1e-15);  // 0.2*0.2 + 0.8 + 0.5, clamped
  scene.shading.clamp = false;
  const glm::dvec3 J = light_point(lighting_in_eye_space<double>(scene, glm::dmat4(1)), material, glm::dvec3(0, 0, -3),
                                   glm::dvec3(0, 0, 1));
  EXPECT_NEAR(J.r, 1.34, 1e-15);
}

}  // namespace
}  // namespace cg
