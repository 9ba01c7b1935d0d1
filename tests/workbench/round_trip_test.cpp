// Export, import, export gives the same text: of shapes, of every parameter at random, with every mistake.
#include <gtest/gtest.h>

#include <random>

#include "params/input_error.h"
#include "tests/radiosity_fields.h"
#include "tests/workbench/random_scene.h"
#include "workbench/export.h"
#include "workbench/import.h"
#include "workbench/model_library.h"

namespace cg {
namespace {

// The first line in which two texts differ.
std::string difference(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
  const std::size_t begin = a.rfind('\n', i) + 1;
  return a.substr(begin, a.find('\n', i) - begin) + "\n" + b.substr(begin, b.find('\n', i) - begin);
}

void expect_round_trip(const Scene& scene) {
  for (const Language language : {Language::english, Language::japanese})
    for (const ExportFormat format : {ExportFormat::c, ExportFormat::glut}) {
      const std::string text = export_text(scene, format, language);
      ImportReport report = import_c(text, "export.c");
      load_meshes(report.scene);
      const std::string again = export_text(report.scene, format, language);
      ASSERT_TRUE(again == text) << difference(text, again);
      for (std::size_t i = 0; i < scene.objects.size(); ++i) ASSERT_EQ(report.scene.objects[i], scene.objects[i]) << i;
      ASSERT_EQ(report.scene.lights, scene.lights);
      ASSERT_EQ(report.scene, scene);
    }
}

TEST(RoundTrip, EveryModel) {
  for (const char* model : {"teapot", "torus", "uv-sphere", "cube", "cornell-box.obj"})
    expect_round_trip(open_model(find_model(model)));
}

TEST(RoundTrip, WhatOpenGlSaysNeedsNoComment) {
  Scene s = open_model("torus");
  s.lights.resize(3);
  s.lights[1].kind = LightKind::spot, s.lights[1].k_1 = 0.25, s.lights[1].exponent = 3;
  s.lights[2].kind = LightKind::directional, s.lights[2].position = {0.1, 1e-7, -3};
  s.material.k_d = {0.1, 0.2, 0.3}, s.material.n = 77.7, s.material.emission = {0.01, 0, 0};
  s.objects[0].transform.translate = {1, 2, 3}, s.objects[0].transform.rotate = {10, 20, 30};
  s.objects[0].transform.scale = {1, 2, 0.5};
  s.camera.position = {3, 4, 5}, s.camera.fov = 35;
  s.shading.local_viewer = s.shading.two_sided = true;
  for (const ExportFormat format : {ExportFormat::c, ExportFormat::glut}) {
    const std::string text = export_text(s, format);
    const std::string comment = text.substr(text.rfind("/*"));
    EXPECT_EQ(comment, "/* shadebench import:\n * objects.0.model: \"\" -> \"torus\"\n */\n") << text;
    const ImportReport report = import_c(text, "a.c");
    for (const Complaint& c : report.complaints)
      EXPECT_EQ(c.text.en, "w = 0: GL_LIGHT2 is directional, its position is where the light comes from") << c.line;
  }
  expect_round_trip(s);
}

TEST(RoundTrip, EveryMistake) {
  Scene s = open_model("cube");
  s.objects[0].transform.scale = {2, 2, 2};
  s.lights[0].k_1 = 0.5;
  s.shading.color_material = ColorMaterial::diffuse;
  for (const Slot& slot : slots(s.mistakes)) {
    bool& mistake = *std::get<bool*>(slot.value);
    mistake = true;
    SCOPED_TRACE(slot.path);
    expect_round_trip(s);
    mistake = false;
  }
}

// A program has no elements: it says so, and comes back as the scene that it was exported from.
TEST(RoundTrip, ARadiositySolutionIsSolvedAgain) {
  Scene s = open_model("cube");
  const std::string constant = export_text(s, ExportFormat::glut);
  EXPECT_EQ(constant.find("radiosity"), std::string::npos);
  s.shading.ambient_source = AmbientSource::radiosity;
  s.radiosity.resolution = 64;
  expect_round_trip(s);
  const std::string text = export_text(s, ExportFormat::glut);
  EXPECT_NE(text.find("here it is the constant I_a k_a"), std::string::npos);
  take_radiosity(s);
  EXPECT_EQ(export_text(s, ExportFormat::glut), text);
  EXPECT_EQ(import_c(text, "a.c").scene.radiosity, s.radiosity);
}

TEST(RoundTrip, APhotographicDisplayIsNamed) {
  Scene s = open_model("cube");
  EXPECT_EQ(export_text(s, ExportFormat::glut).find("sRGB"), std::string::npos);
  s.display.transform = DisplayTransform::photographic;
  for (const ExportFormat format : {ExportFormat::c, ExportFormat::glut})
    EXPECT_NE(export_text(s, format).find("here a colour is shown as it is computed"), std::string::npos);
  expect_round_trip(s);
}

TEST(RoundTrip, AnEditedNumberStays) {
  Scene s = open_model("torus");
  s.material.n = 500;
  std::string text = export_text(s, ExportFormat::c);
  EXPECT_EQ(import_c(text, "a.c").scene.material.n, 500);
  text.replace(text.find("GL_SHININESS, 128.0"), 19, "GL_SHININESS, 64.0 ");
  EXPECT_EQ(import_c(text, "a.c").scene.material.n, 64);
  EXPECT_EQ(import_c(text, "a.c").scene.objects[0].model, "torus");
}

TEST(RoundTrip, RandomScenes) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100; ++i) {
    Scene s = random_scene(random);
    load_meshes(s);
    SCOPED_TRACE(i);
    expect_round_trip(s);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace cg
