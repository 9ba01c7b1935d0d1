// What a radiosity solution does to a picture, in every technique, against closed forms and against the picture without
// it. Parity between the techniques is in tests/parity.
#include <gtest/gtest.h>

#include <limits>

#include "tests/all_techniques.h"
#include "tests/gl/gl_scenes.h"
#include "tests/radiosity_fields.h"
#include "workbench/isolate.h"
#include "workbench/measured_plan.h"
#include "workbench/probe.h"

namespace cg {
namespace {

class RadiosityPicture : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const auto& why = technique().unavailable) GTEST_SKIP() << why->en;
  }
  const Technique& technique() const { return find(all_techniques(), GetParam()); }
  bool draws(const Scene& scene) const { return !technique().unsupported(scene); }
  Frame picture(const Scene& scene, int width = 64, int height = 64, bool all = false) const {
    return draw(technique(), scene, view_of(width, height, all));
  }
  Plan plan(const Scene& scene) const { return technique().plan(scene, view_of(64, 64)); }
};

constexpr ShadingMode modes[] = {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong};

// The square of z = 0 fills a picture whose pixel (x, y) stands at -1 + (x + 1/2)/32, 1 - (y + 1/2)/32.
Scene flat_square() {
  Scene s = scene_with(square_mesh());
  s.camera.projection = Projection::orthographic;
  s.camera.height = 2;
  s.camera.position = {0, 0, 5};
  s.lights.clear();
  s.shading.clamp = false;
  return s;
}

RadiosityHandle field_of_corners(const Scene& s, std::vector<glm::vec3> corners) {
  const auto field = std::make_shared<RadiosityField>();
  field->objects.push_back({s.objects[0].mesh, std::move(corners), s.objects[0].mesh});
  return field;
}

// Linear over the whole square, so each triangle of it has the plane's own value at every pixel.
TEST_P(RadiosityPicture, IsThePlaneThroughTheCornersOfOneQuad) {
  const auto plane = [](double x, double y) { return glm::vec3(0.5 + 0.4 * x, 0.3 - 0.2 * y, 1.5 + x + 0.4 * y); };
  Scene s = flat_square();
  s.radiosity_field = field_of_corners(s, {plane(-1, -1), plane(1, -1), plane(1, 1), plane(-1, 1)});
  s.shading.ambient_source = AmbientSource::radiosity;
  s.shading.ambient = {7, 7, 7};  // does nothing here
  s.material.emission = {0.25, 0, 0};
  for (const ShadingMode mode : modes)
    for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
      s.shading.mode = mode, s.shading.precision = precision;
      if (!draws(s)) continue;
      const Frame f = picture(s);
      double worst = 0;
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
          ASSERT_TRUE(f.covered.at(x, y));
          const double px = -1 + (x + 0.5) / 32, py = 1 - (y + 0.5) / 32;
          const glm::vec3 right =
              glm::vec3(s.material.emission) + (mode == ShadingMode::flat ? plane(-1, 1) : plane(px, py));
          const glm::vec3 off = glm::abs(f.colour.at(x, y) - right);
          worst = std::max({worst, double(off.x), double(off.y), double(off.z)});
        }
      EXPECT_LE(worst, 2e-6) << int(mode) << int(precision);
    }
}

// Not linear over the square: half of it has the plane of its own triangle, with the value of one corner alone.
TEST_P(RadiosityPicture, HasTheTrianglesOfItsElements) {
  Scene s = flat_square();
  s.radiosity_field = field_of_corners(s, {glm::vec3(0), glm::vec3(0), glm::vec3(1), glm::vec3(0)});
  s.shading.ambient_source = AmbientSource::radiosity;
  s.shading.mode = ShadingMode::gouraud;
  const Frame f = picture(s);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double px = -1 + (x + 0.5) / 32, py = 1 - (y + 0.5) / 32;
      EXPECT_NEAR(double(f.colour.at(x, y).g), std::max((px + py) / 2, 0.0), 1e-6);
    }
}

TEST_P(RadiosityPicture, IsClampedAsTheSceneSays) {
  Scene s = flat_square();
  s.radiosity_field = field_of_corners(s, std::vector<glm::vec3>(4, {3, 0.5, 0}));
  s.shading.ambient_source = AmbientSource::radiosity;
  for (const ShadingMode mode : modes) {
    s.shading.mode = mode;
    if (!draws(s)) continue;
    s.shading.clamp = true;
    EXPECT_EQ(picture(s).colour.at(9, 9), glm::vec3(1, 0.5f, 0));
    s.shading.clamp = false;
    EXPECT_EQ(picture(s).colour.at(9, 9), glm::vec3(3, 0.5f, 0));
  }
}

// Across an edge between two faces light does not leak: a cube whose faces differ has six colours and no more.
TEST_P(RadiosityPicture, KeepsToItsFaceWhereNormalsAreShared) {
  Scene s = scene_with(sphere_mesh(4, 2));
  s.shading.normals = NormalRule::angle;  // one normal a position
  s.lights.clear();
  s.shading.mode = ShadingMode::gouraud;
  take_radiosity(s, [](const glm::dvec3&, const glm::dvec3& n) {
    return glm::vec3(n.x > 0 ? 0.75 : 0.25, n.y > 0 ? 0.75 : 0.25, n.z > 0 ? 0.75 : 0.25);
  });
  const Frame f = picture(s);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < f.colour.size(); ++i) {
    if (!f.covered.pixels()[i]) continue;
    ++covered;
    for (int c = 0; c < 3; ++c) {
      const float v = f.colour.pixels()[i][c];
      EXPECT_TRUE(std::abs(v - 0.75f) < 1e-6f || std::abs(v - 0.25f) < 1e-6f) << v;
    }
  }
  EXPECT_GT(covered, 500u);
}

Scene two_objects() {
  Scene s = scene_with(sphere_mesh());
  s.objects.push_back(s.objects[0]);
  s.objects[1].mesh = square_mesh();
  s.objects[1].transform.translate = {1, 0, 0.5};
  s.lights.resize(2, s.lights[0]);
  s.lights[1].kind = LightKind::directional;
  s.lights[0].ambient = s.lights[1].ambient = {0.3, 0.2, 0.1};
  s.material.k_s = {0.4, 0.4, 0.4}, s.material.emission = {0, 0.05, 0.1};
  s.shading.clamp = false;
  return s;
}

TEST_P(RadiosityPicture, IsTheTermThatIsIsolatedAndTheTermsSumToThePicture) {
  for (const ShadingMode mode : modes) {
    Scene s = two_objects();
    s.shading.mode = mode;
    if (!draws(s)) continue;
    s.display.background = {0, 0, 0};
    take_radiosity(s);
    const Frame whole = picture(s), ambient = picture(isolated(s, Quantity::ambient));
    ColourImage sum(64, 64, glm::vec3(0)), by_light(64, 64, glm::vec3(0));
    const auto add = [](ColourImage& to, const Frame& f) {
      for (std::size_t i = 0; i < to.size(); ++i) to.pixels()[i] += f.colour.pixels()[i];
    };
    for (const Quantity q : {Quantity::emission, Quantity::ambient, Quantity::diffuse, Quantity::specular})
      add(sum, picture(isolated(s, q)));
    add(by_light, picture(isolated(s, Quantity::none, no_light)));
    for (const int light : {0, 1}) add(by_light, picture(isolated(s, Quantity::none, light)));
    Scene alone = s;  // nothing but the solution
    alone.lights.clear(), alone.material.emission = {0, 0, 0};
    // OpenGL rounds each of the pictures to float on its way.
    const float rounding = technique().id == "software" ? 2e-6f : 2e-5f;
    const Frame interpolated = picture(alone);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      EXPECT_LE(glm::distance(sum.pixels()[i], whole.colour.pixels()[i]), rounding);
      EXPECT_LE(glm::distance(by_light.pixels()[i], whole.colour.pixels()[i]), rounding);
      EXPECT_EQ(ambient.colour.pixels()[i], interpolated.colour.pixels()[i]);
    }
  }
}

// What cannot be drawn leaves the picture of the constant term, bit by bit, and a note.
TEST_P(RadiosityPicture, IsTheConstantTermWhereThereIsNoneToDraw) {
  const Scene constant = two_objects();
  const Frame right = picture(constant);
  EXPECT_TRUE(plan(constant).notes.empty());
  EXPECT_FALSE(plan(constant).runs("radiosity"));
  const float infinity = std::numeric_limits<float>::infinity();
  const auto one_bad = [&](float bad) {
    Scene s = constant;
    take_radiosity(s);
    auto field = *s.radiosity_field;
    field.objects[1].corners[5].g = bad;
    s.radiosity_field = std::make_shared<RadiosityField>(field);
    return s;
  };
  std::vector<Scene> scenes{one_bad(NAN), one_bad(infinity), one_bad(-infinity), constant, constant,
                            constant,     constant};
  scenes[3].shading.ambient_source = AmbientSource::radiosity;
  take_radiosity(scenes[4]), take_radiosity(scenes[5]), take_radiosity(scenes[6]);
  auto other = *scenes[4].radiosity_field;
  other.objects.pop_back();
  scenes[4].radiosity_field = std::make_shared<RadiosityField>(other);
  other = *scenes[5].radiosity_field;
  other.objects[0].of = square_mesh();
  scenes[5].radiosity_field = std::make_shared<RadiosityField>(other);
  other = *scenes[6].radiosity_field;
  other.objects[0].corners.pop_back();
  scenes[6].radiosity_field = std::make_shared<RadiosityField>(other);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    SCOPED_TRACE(i);
    const Frame f = picture(scenes[i]);
    EXPECT_EQ(f.colour, right.colour);
    EXPECT_EQ(f.nan_pixels, 0u);
    ASSERT_EQ(plan(scenes[i]).notes.size(), 1u);
    EXPECT_NE(plan(scenes[i]).notes[0].en.find("the constant ambient term is drawn"), std::string::npos);
    EXPECT_FALSE(plan(scenes[i]).runs("radiosity"));
  }
}

TEST_P(RadiosityPicture, IsNotDrawnWhereTheTermIsConstant) {
  Scene s = two_objects();
  const Frame right = picture(s);
  take_radiosity(s);
  s.shading.ambient_source = AmbientSource::constant;
  EXPECT_EQ(picture(s).colour, right.colour);
}

TEST_P(RadiosityPicture, IsATermOfTheProbe) {
  for (const ShadingMode mode : modes) {
    Scene s = two_objects();
    s.shading.mode = mode;
    if (!draws(s)) continue;
    take_radiosity(s);
    const Frame f = picture(s, 64, 64, true);
    Progress progress;
    int probed = 0;
    for (int y = 3; y < 64; y += 7)
      for (int x = 3; x < 64; x += 7) {
        const Probe p = probe(s, technique(), view_of(64, 64), f, {x, y}, progress);
        if (!p.covered) continue;
        ++probed;
        EXPECT_LE(p.error(), 2e-5);
        EXPECT_TRUE(p.radiosity);
        glm::dvec3 light(0);
        for (const ProbedTerm& t : p.terms) {
          EXPECT_NE(t.name, "global-ambient");
          EXPECT_NE(t.name, "ambient");
          if (t.name == "radiosity") light = t.rgb;
        }
        EXPECT_GT(light.r, 0.05);
        EXPECT_NE(text_of(p, s, Language::english).find("radiosity, light of other surfaces"), std::string::npos);
      }
    EXPECT_GT(probed, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, RadiosityPicture, testing::Values("software", "gl", "gl-fixed"),
                         [](const auto& id) {
                           return std::string(id.param) == "gl-fixed" ? std::string("gl_fixed") : std::string(id.param);
                         });

}  // namespace
}  // namespace cg
