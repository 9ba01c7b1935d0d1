// The terms of the light model alone, at random points: they sum to the whole.
#include "workbench/isolate.h"

#include <gtest/gtest.h>

#include <random>

#include "shading/light_model.h"

namespace cg {
namespace {

class Random {
 public:
  double in(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  glm::dvec3 vector(double low, double high) { return {in(low, high), in(low, high), in(low, high)}; }
  template <class E>
  E one_of() {
    return E(engine_() % names_of<E>.size());
  }

 private:
  std::mt19937_64 engine_{5};
};

Scene random_scene(Random& r) {
  Scene s;
  s.shading.clamp = false;
  s.shading.ambient = r.vector(0, 1);
  s.shading.color_material = r.one_of<ColorMaterial>();
  s.shading.reflection = r.one_of<Reflection>();
  Material& m = s.material;
  m.k_a = r.vector(0, 1), m.k_d = r.vector(0, 1), m.k_s = r.vector(0, 1), m.emission = r.vector(0, 1);
  m.color = r.vector(0, 1), m.n = r.in(0, 50);
  s.lights.resize(3);
  for (Light& l : s.lights) {
    l.kind = r.one_of<LightKind>();
    l.position = r.vector(-5, 5), l.direction = r.vector(-1, 1), l.cutoff = 90;
    l.ambient = r.vector(0, 1), l.diffuse = r.vector(0, 1), l.specular = r.vector(0, 1);
    l.k_1 = r.in(0, 1);
  }
  return s;
}

glm::dvec3 light(const Scene& s, const glm::dvec3& P, const glm::dvec3& N) {
  return light_point(lighting_in_eye_space<double>(s, glm::dmat4(1)),
                     eye_material<double>(s.material, s.shading.color_material), P, N);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12 * (1 + std::abs(b[i])));
}

TEST(Isolate, TermsSumToTheWhole) {
  Random r;
  for (int round = 0; round < 500; ++round) {
    const Scene s = random_scene(r);
    const glm::dvec3 P = r.vector(-2, 2), N = unit(r.vector(-1, 1));
    const auto alone = [&](Quantity q, int i) { return light(isolated(s, q, i), P, N); };
    const glm::dvec3 whole = light(s, P, N);
    glm::dvec3 by_term(0), by_light = alone(Quantity::none, no_light), each = by_light;
    for (const Quantity q : {Quantity::ambient, Quantity::diffuse, Quantity::specular, Quantity::emission})
      by_term += alone(q, all_lights);
    for (int i = 0; i < 3; ++i) {
      by_light += alone(Quantity::none, i);
      for (const Quantity q : {Quantity::ambient, Quantity::diffuse, Quantity::specular}) each += alone(q, i);
    }
    expect_near(by_term, whole);
    expect_near(by_light, whole);
    expect_near(each, whole);
    expect_near(alone(Quantity::emission, no_light) + alone(Quantity::ambient, no_light),
                alone(Quantity::none, no_light));
    expect_near(alone(Quantity::emission, 1), glm::dvec3(0));
    expect_near(alone(Quantity::diffuse, no_light), glm::dvec3(0));
    EXPECT_EQ(isolated(s, Quantity::none, all_lights), s);
  }
}

}  // namespace
}  // namespace cg
