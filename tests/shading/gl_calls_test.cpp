// The list of OpenGL calls: each number is the parameter that it says it is, and what a student writes is there.
#include "shading/gl_calls.h"

#include <gtest/gtest.h>

#include "params/slots.h"
#include "scene/shape.h"
#include "tests/radiosity_fields.h"

namespace cg {
namespace {

Scene rich_scene() {
  Scene s;
  s.objects.resize(3);
  s.objects[0].transform = {{1, 2, 3}, {10, 20, 30}, {2, 3, 4}};
  s.objects[1].own_material = true;
  s.objects[1].material.emission = {0.1, 0.2, 0.3};
  s.lights.resize(4);
  s.lights[1] = {.kind = LightKind::spot, .position = {1, 2, 3}, .w = 2, .exponent = 4, .k_0 = 0.5, .k_1 = 1, .k_2 = 2};
  s.lights[2] = {.kind = LightKind::directional, .position = {0, 1, 0}, .diffuse = {0.5, 0.25, 0}};
  s.lights[3].enabled = false;
  s.shading.local_viewer = s.shading.two_sided = true;
  s.shading.clamp = false;
  return s;
}

std::size_t count(const std::vector<GlCall>& calls, std::string_view function, std::string_view token = {}) {
  return std::size_t(std::count_if(calls.begin(), calls.end(), [&](const GlCall& c) {
    return !c.missing && c.function == function &&
           (token.empty() || std::find(c.tokens.begin(), c.tokens.end(), token) != c.tokens.end());
  }));
}

TEST(GlCalls, EachNumberIsItsParameter) {
  std::vector<Scene> scenes(4, rich_scene());
  for (Object& o : scenes[3].objects) o.mesh = make_shape(*find_shape("cube"));
  take_radiosity(scenes[3]);
  scenes[3].shading.color_material = ColorMaterial::ambient_and_diffuse;
  scenes[1].camera.projection = Projection::orthographic;
  scenes[1].shading.color_material = ColorMaterial::specular;
  scenes[2].mistakes.no_color_material = true;
  for (Scene& scene : scenes) {
    const Slots all = slots(scene);
    std::size_t numbers = 0;
    for (const GlCall& call : gl_calls(scene))
      for (const GlNumber& number : call.numbers) {
        if (number.path.empty()) continue;
        ++numbers;
        const Slot& slot = find_slot(all, number.path);
        if (number.component < 0) {
          EXPECT_EQ(number.value, number.factor * **std::get_if<double*>(&slot.value)) << number.path;
        } else {
          EXPECT_EQ(number.value, (**std::get_if<glm::dvec3*>(&slot.value))[number.component]) << number.path;
        }
      }
    EXPECT_GT(numbers, 100u);
  }
}

TEST(GlCalls, SayWhatAStudentWrites) {
  const std::vector<GlCall> calls = gl_calls(rich_scene());
  EXPECT_EQ(count(calls, "glLightfv", "GL_POSITION"), 4u);
  EXPECT_EQ(count(calls, "glDisable", "GL_LIGHT3"), 1u);
  EXPECT_EQ(count(calls, "glLightf", "GL_SPOT_CUTOFF"), 1u);
  EXPECT_EQ(count(calls, "glLightf", "GL_LINEAR_ATTENUATION"), 1u);
  EXPECT_EQ(count(calls, "glRotated"), 3u);
  EXPECT_EQ(count(calls, "glTranslated"), 1u);
  EXPECT_EQ(count(calls, "glMaterialfv", "GL_DIFFUSE"), 3u);  // of the scene, of object 1, of the scene again
  EXPECT_EQ(count(calls, "draw_mesh"), 3u);
  EXPECT_EQ(count(calls, "glPushMatrix"), count(calls, "glPopMatrix"));
  for (std::size_t i = 1; i < calls.size(); ++i)
    if (calls[i].section != calls[i - 1].section && calls[i].section < GlSection::transform) {
      EXPECT_LT(calls[i - 1].section, calls[i].section);
    }
  const auto position =
      std::find_if(calls.begin(), calls.end(), [](const GlCall& c) { return c.variable == "light1_position"; });
  ASSERT_NE(position, calls.end());
  EXPECT_EQ(position->numbers.back(), (GlNumber{.value = 2, .path = "lights.1.w"}));
}

// The emission of what takes part follows glColor, one colour a vertex; what does not has its own, and its k_a.
TEST(GlCalls, DrawARadiositySolutionAsEmission) {
  Scene s;
  s.objects.resize(3);
  for (Object& o : s.objects) o.mesh = make_shape(*find_shape("cube"));
  s.shading.color_material = ColorMaterial::ambient_and_diffuse;
  EXPECT_EQ(count(gl_calls(s), "glColor3d"), 1u);
  s.radiosity_field = cut_field(s, 0, smooth_light, {0, 1});
  EXPECT_EQ(count(gl_calls(s), "glColor3d"), 1u);  // not asked for
  s.shading.ambient_source = AmbientSource::radiosity;
  const std::vector<GlCall> calls = gl_calls(s);
  EXPECT_EQ(count(calls, "glColor3d"), 0u);
  EXPECT_EQ(count(calls, "glColor3fv", "radiosity"), 1u);
  EXPECT_EQ(count(calls, "glColorMaterial", "GL_EMISSION"), 1u);
  EXPECT_EQ(count(calls, "glEnable", "GL_COLOR_MATERIAL"), 1u);  // of the first two objects together
  EXPECT_EQ(count(calls, "glDisable", "GL_COLOR_MATERIAL"), 1u);
  std::vector<double> ambient;
  for (const GlCall& c : calls)
    if (c.function == "glMaterialfv" && c.tokens[1] == "GL_AMBIENT") ambient.push_back(c.numbers[0].value);
  EXPECT_EQ(ambient, (std::vector<double>{0, s.material.color.r}));
  // The two mistakes with colours leave it out.
  s.mistakes.no_gate = true;
  EXPECT_EQ(count(gl_calls(s), "glColor3fv", "radiosity"), 0u);
}

TEST(GlCalls, EndAtOpenGlsLimits) {
  Scene s;
  s.objects.resize(1);
  s.lights.resize(12);
  s.lights[0].enabled = false;
  s.material.n = 1000;
  const std::vector<GlCall> calls = gl_calls(s);
  EXPECT_EQ(count(calls, "glEnable", "GL_LIGHT7"), 1u);
  EXPECT_EQ(count(calls, "glEnable", "GL_LIGHT8"), 0u);
  for (const GlCall& c : calls) {
    if (c.function.empty()) {
      EXPECT_NE(c.notes.at(0).en.find("8 of 11"), std::string::npos);
    }
    if (c.tokens == std::vector<std::string>{"GL_FRONT_AND_BACK", "GL_SHININESS"}) {
      EXPECT_EQ(c.numbers[0].value, 128);
      EXPECT_EQ(c.notes.size(), 1u);
    }
  }
}

// Each mistake has a guilty line on a scene that shows it, and none without.
TEST(GlCalls, EachMistakeIsMarked) {
  Scene scene = rich_scene();
  scene.objects[0].transform.scale = {0.5, 0.5, 0.5};
  for (const GlCall& c : gl_calls(scene)) EXPECT_TRUE(c.mistake.empty() && !c.missing);
  for (const Slot& slot : slots(scene.mistakes)) {
    if (slot.about->name == "no_gate" || slot.about->name == "long_light_vector") continue;  // in own_light_model.h
    **std::get_if<bool*>(&slot.value) = true;
    std::size_t marked = 0;
    for (const GlCall& c : gl_calls(scene)) {
      EXPECT_TRUE(c.mistake.empty() || c.mistake == slot.about->name);
      marked += c.mistake == slot.about->name;
    }
    EXPECT_GT(marked, 0u) << slot.path;
    **std::get_if<bool*>(&slot.value) = false;
  }
}

}  // namespace
}  // namespace cg
