// Ten programs as students write them (tests/workbench/student_c): the right values, no others, the right complaints.
#include <gtest/gtest.h>

#include <map>

#include "params/file.h"
#include "params/slots.h"
#include "workbench/import.h"
#include "workbench/model_library.h"
#include "workbench/scene_differences.h"

namespace cg {
namespace {

using Values = std::map<std::string, std::string>;       // path: JSON
using Told = std::vector<std::pair<long, std::string>>;  // line: complaint

ImportReport import_listing(const std::string& name) {
  return import_file(SHADEBENCH_SOURCE_DIR "/tests/workbench/student_c/" + name);
}

// What differs from a scene of the defaults with as many objects and lights.
Values values_of(const Scene& scene) {
  Scene usual;
  usual.objects.resize(scene.objects.size());
  usual.lights.resize(scene.lights.size());
  Values out;
  for (const ParameterDifference& d : scene_differences(usual, scene))
    if (!d.path.ends_with(".name")) out[d.path] = to_json(d.b, 0);
  return out;
}

void expect_listing(const std::string& name, Values expected, const Told& complaints) {
  SCOPED_TRACE(name);
  const ImportReport report = import_listing(name);
  Values found = values_of(report.scene);
  for (const auto& [path, value] : found) EXPECT_TRUE(expected.contains(path)) << path << " is " << value;
  for (const auto& [path, value] : expected) EXPECT_EQ(found[path], value) << path;
  Told told;
  for (const Complaint& c : report.complaints) {
    told.emplace_back(c.line, c.text.en);
    EXPECT_FALSE(c.text.ja.empty());
    EXPECT_NE(c.text.ja, c.text.en);
  }
  EXPECT_EQ(told, complaints);
}

// A material of OpenGL's defaults where the workbench has others.
Values with_defaults(Values values) {
  values.emplace("material.k_s", "[0,0,0]");
  values.emplace("material.n", "0");
  return values;
}

// The transform of the workbench's teapot that makes it GLUT's of that size, as the test of the teapot below checks it.
const char* teapot_moved = "[0.1085,0.0375,0]";
const char* teapot_scale = "[1.669979,1.669979,1.669979]";

TEST(StudentC, Globals) {
  expect_listing("01_globals.c",
                 {{"objects.0.model", "\"teapot\""},
                  {"objects.0.transform.translate", teapot_moved},
                  {"objects.0.transform.scale", teapot_scale},
                  {"material.k_a", "[0.8,0.2,0.2]"},
                  {"material.k_d", "[0.8,0.2,0.2]"},
                  {"material.k_s", "[0.6,0.6,0.6]"},
                  {"material.n", "40"},
                  {"lights.0.position", "[0,3,5]"},
                  {"camera.position", "[3,4,5]"},
                  {"camera.fov", "30"},
                  {"camera.near", "1"},
                  {"display.background", "[1,1,1]"}},
                 {});
}

TEST(StudentC, ExpressionsOfConstants) {
  ImportReport report = import_listing("02_numbers.c");
  // sin and cos are rounded: 1.9999999999999998.
  EXPECT_NEAR(report.scene.lights[0].position.x, 2, 1e-15);
  EXPECT_NEAR(report.scene.lights[0].position.z, 2, 1e-15);
  EXPECT_NEAR(report.scene.camera.fov, 2 * std::atan(0.5) * 180 / 3.14159265358979, 1e-9);
  const Values found = values_of(report.scene);
  expect_listing("02_numbers.c",
                 {{"objects.0.model", "\"torus\""},
                  {"objects.0.tessellation", "64"},
                  {"objects.0.transform.translate", "[0.5,-1,0]"},
                  {"objects.0.transform.rotate", "[0,-30,45]"},
                  {"material.k_s", "[0,0,0]"},
                  {"lights.0.kind", "\"spot\""},
                  {"lights.0.position", found.at("lights.0.position")},
                  {"lights.0.direction", "[-0.5,-1,-0.5]"},
                  {"lights.0.cutoff", "45"},
                  {"lights.0.exponent", "8"},
                  {"lights.0.k_0", "1.5"},
                  {"lights.0.k_2", "0.25"},
                  {"camera.position", "[0,0,5]"},
                  {"camera.fov", found.at("camera.fov")},
                  {"camera.near", "2"},
                  {"shading.mode", "\"flat\""},
                  {"shading.ambient", "[0.1,0.1,0]"},
                  {"shading.local_viewer", "true"},
                  {"shading.two_sided", "true"}},
                 {{30, "1/4 of whole numbers is 0 in C"}});
  EXPECT_EQ(report.scene.material.n, 32);  // 0x40 / 2: the workbench's default as well
}

TEST(StudentC, SeveralLightsInALoop) {
  const char* behind = "[0,0.316227766017,0.948683298051]";  // OpenGL's (0, 0, 1), in the world
  Values expected = with_defaults({{"objects.0.model", "\"uv-sphere\""},
                                   {"objects.0.tessellation", "40"},
                                   {"objects.0.transform.scale", "[1.5,1.5,1.5]"},
                                   {"material.k_d", "[0.1,0.6,0.3]"},
                                   {"lights.1.enabled", "false"},
                                   {"lights.1.position", "[-5,2,4]"},
                                   {"lights.1.diffuse", "[0.3,0.3,0.4]"},
                                   {"lights.1.specular", "[0.3,0.3,0.4]"},
                                   {"lights.2.position", "[0,4,-8]"},
                                   {"lights.2.diffuse", "[0.2,0.2,0.1]"},
                                   {"lights.2.specular", "[0,0,0]"},
                                   {"camera.position", "[0,2,6]"},
                                   {"camera.fov", "45"},
                                   {"camera.near", "0.5"},
                                   {"camera.far", "50"}});
  for (const std::string light : {"lights.3.", "lights.4.", "lights.5."}) {
    expected[light + "enabled"] = "false", expected[light + "kind"] = "\"directional\"";
    expected[light + "position"] = behind, expected[light + "specular"] = "[0,0,0]";
    if (light != "lights.5.") expected[light + "diffuse"] = "[0,0,0]";
  }
  expect_listing("03_several_lights.c", expected, {{23, "GL_LIGHT5 is set but never enabled"}});
}

TEST(StudentC, CommentedOutLinesAndConditionals) {
  expect_listing("04_commented_out.c",
                 {{"objects.0.model", "\"torus\""},
                  {"objects.0.tessellation", "48"},
                  {"objects.0.transform.scale", "[2,2,2]"},
                  {"material.k_a", "[0.329412,0.223529,0.027451]"},
                  {"material.k_d", "[0.780392,0.568627,0.113725]"},
                  {"material.k_s", "[0.992157,0.941176,0.807843]"},
                  {"material.n", "27.8974"},
                  {"lights.0.position", "[2,4,6]"},
                  {"camera.position", "[0,0,8]"},
                  {"camera.fov", "60"},
                  {"camera.near", "1"},
                  {"camera.far", "20"}},
                 {});
}

TEST(StudentC, ShiftJisCommentsAndCrLf) {
  const std::string side = to_json(std::sqrt(3.0), 0);  // a cube of edge 2 reaches to sqrt 3
  expect_listing("05_shift_jis.c",
                 with_defaults({{"objects.0.model", "\"cube\""},
                                {"objects.0.transform.scale", "[" + side + "," + side + "," + side + "]"},
                                {"lights.0.position", "[1,2,3]"},
                                {"lights.0.diffuse", "[0.5,0.5,0.75]"},
                                {"camera.position", "[0,0,10]"},
                                {"camera.fov", "25"},
                                {"camera.near", "1"},
                                {"camera.far", "30"}}),
                 {});
}

TEST(StudentC, LightInInitAndScaleWithoutNormalize) {
  expect_listing("06_light_in_init.c",
                 with_defaults({{"objects.0.model", "\"uv-sphere\""},
                                {"objects.0.tessellation", "32"},
                                {"objects.0.transform.scale", "[2,0.5,1]"},
                                {"material.k_d", "[0.2,0.3,0.9]"},
                                {"lights.0.kind", "\"directional\""},
                                {"lights.0.position", "[5,5,5]"},
                                {"camera.position", "[3,4,10]"},
                                {"camera.fov", "30"},
                                {"camera.near", "1"},
                                {"mistakes.light_before_view", "true"},
                                {"mistakes.no_normalize", "true"}}),
                 {{11, "w = 0: GL_LIGHT0 is directional, its position is where the light comes from"},
                  {11, "GL_LIGHT0 is placed before gluLookAt: it turns with the camera"},
                  {19, "glScale without GL_NORMALIZE changes the length of the normals, and with it N·L"}});
}

TEST(StudentC, GlColorAndWhatOpenGlRefuses) {
  expect_listing("07_glcolor.c",
                 with_defaults({{"objects.0.model", "\"torus\""},
                                {"objects.0.tessellation", "40"},
                                {"material.color", "[1,0.2,0]"},
                                {"lights.0.position", "[4,4,4]"},
                                {"camera.position", "[0,0,5]"},
                                {"camera.near", "1"},
                                {"camera.far", "10"},
                                {"shading.normal_length", "\"off\""},
                                {"shading.color_material", "\"ambient-and-diffuse\""},
                                {"mistakes.no_color_material", "true"},
                                {"mistakes.no_depth_test", "true"}}),
                 {{0, "GL_DEPTH_TEST is never enabled: what is drawn last is seen"},
                  {12, "GL_DIFFUSE needs an array, as glLightfv takes: this glLightf is left out"},
                  {13, "glColor does nothing here: GL_COLOR_MATERIAL is never enabled"},
                  {14, "OpenGL refuses 200 for GL_SHININESS, which ends at 128: this glMaterialf is left out"},
                  {15, "back faces have no material of their own here: this glMaterialf is left out"},
                  {16, "GL_SPECULAR needs an array, as glMaterialfv takes: this glMaterialf is left out"},
                  {17, "lines are not drawn here: the shape comes solid"}});
}

TEST(StudentC, WhatChangesWhileItRunsIsLeftOut) {
  const Scene scene = import_listing("08_animation.c").scene;
  const Values found = values_of(scene);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);  // OpenGL's default: its position was left out
  expect_listing("08_animation.c",
                 with_defaults({{"objects.0.model", "\"teapot\""},
                                {"objects.0.transform.translate", found.at("objects.0.transform.translate")},
                                {"objects.0.transform.rotate", "[20,0,0]"},
                                {"objects.0.transform.scale", "[3.339957,3.339957,3.339957]"},
                                {"material.k_d", "[1,0,0]"},
                                {"lights.0.kind", "\"directional\""},
                                {"lights.0.position", found.at("lights.0.position")},
                                {"lights.1.position", "[-5,5,5]"},
                                {"lights.1.diffuse", "[0,0,0]"},
                                {"lights.1.specular", "[0,0,0]"},
                                {"camera.position", "[0,3,8]"},
                                {"camera.fov", "30"},
                                {"camera.near", "1"}}),
                 {{18, "'t' changes while the program runs: this glLightfv is left out"},
                  {20, "'red_on' changes while the program runs: taken as in the first picture"},
                  {24, "'frames' changes while the program runs: this glTranslatef is left out"},
                  {25, "'angle' changes while the program runs: this glRotated is left out"}});
}

TEST(StudentC, TwoObjectsAndNoLookAt) {
  expect_listing("09_two_objects.c",
                 with_defaults({{"objects.0.model", "\"torus\""},
                                {"objects.0.tessellation", "40"},
                                {"objects.0.transform.translate", "[-1,0,0]"},
                                {"objects.0.transform.rotate", "[90,0,30]"},  // Rx(90) Ry(30) = Rz(30) Rx(90)
                                {"objects.0.transform.scale", "[0.5,0.5,0.5]"},
                                {"objects.0.own_material", "true"},
                                {"objects.0.material.k_d", "[1,0.5,0.25]"},
                                {"objects.0.material.k_s", "[0,0,0]"},
                                {"objects.0.material.n", "0"},
                                {"objects.0.material.color", "[0.5,0.5,0.5]"},
                                {"objects.1.model", "\"cube\""},
                                {"objects.1.transform.translate", "[1,0,0]"},
                                {"objects.1.transform.scale", "[0.866025403784,0.866025403784,0.866025403784]"},
                                {"objects.1.own_material", "true"},
                                {"objects.1.material.k_d", "[0,0.5,1]"},
                                {"objects.1.material.k_s", "[0,0,0]"},
                                {"objects.1.material.n", "0"},
                                {"objects.1.material.color", "[0.5,0.5,0.5]"},
                                {"material.k_d", "[1,0.5,0.25]"},
                                {"material.color", "[0.5,0.5,0.5]"},
                                {"lights.0.position", "[0,3,0]"},
                                {"camera.position", "[0,0,5]"},
                                {"camera.projection", "\"orthographic\""},
                                {"camera.height", "4"},
                                {"camera.near", "1"},
                                {"camera.far", "10"},
                                {"shading.color_material", "\"specular\""}}),
                 {});
}

TEST(StudentC, WhatIsNotUnderstoodIsToldAndLeftOut) {
  expect_listing("10_not_understood.c",
                 {{"objects.0.model", "\"teapot\""},
                  {"material.k_s", "[0.5,0.25,0.125]"},
                  {"material.n", "0"},
                  {"lights.0.position", "[2,2,2]"},
                  {"lights.0.specular", "[2,2,2]"},
                  {"lights.1.kind", "\"directional\""},
                  {"lights.1.position", "[0,0,1]"},
                  {"lights.1.diffuse", "[0,0,0]"},
                  {"lights.1.specular", "[0,0,0]"},
                  {"camera.position", "[0,0,4]"},
                  {"camera.near", "1"},
                  {"camera.far", "10"},
                  {"shading.normal_length", "\"off\""}},
                 {{0, "nothing that is drawn was found: a teapot stands in its place"},
                  {3, "the file 'mylib.h' is not read"},
                  {14, "values of the type of 'p' are not read: this glLightfv is left out"},
                  {14, "the lights are GL_LIGHT0 to GL_LIGHT7: this glLightfv is left out"},
                  {20, "lines and points are not drawn here"},
                  {34, "the result of rand is known only to the running program: this glMaterialfv is left out"},
                  {35, "the member 'diffuse' of a structure is not read: this glMaterialfv is left out"},
                  {36, "the member 'shininess' of a structure is not read: this glMaterialf is left out"},
                  {37, "the array has 3 values, OpenGL reads 4"},
                  {38, "'GL_DIFUSE' is not known: this glLightfv is left out"},
                  {39, "a semicolon is missing at the end of the line"},
                  {40, "GL_FOG is not read"},
                  {41, "a full-width space stands in the program: compilers refuse it"},
                  {41, "OpenGL refuses 100 for GL_SPOT_CUTOFF: this glLightf is left out"},
                  {54, "camera.fov: 200 is not possible here; give a number from 1 to 170: left out"}});
}

// freeglut's glutSolidTeapot(1): Newell's, 3.15 high and with the handle's and the spout's ends at x = -3 and 3.434 or
// so, at half its size, its middle height 1.5 at the origin.
TEST(StudentC, TheTeapotStandsWhereGlutsDoes) {
  ImportReport report = import_listing("01_globals.c");
  load_meshes(report.scene);
  const Object& teapot = report.scene.objects[0];
  const glm::dmat4 m = matrix(teapot.transform);
  glm::dvec3 low(1e9), high(-1e9);
  for (const glm::dvec3& p : teapot.mesh->data().positions) {
    const glm::dvec3 q(m * glm::dvec4(p, 1));
    low = glm::min(low, q), high = glm::max(high, q);
  }
  EXPECT_NEAR(low.y, -0.75, 2e-6);
  EXPECT_NEAR(high.y, 0.825, 2e-6);
  EXPECT_NEAR(low.x, -1.5, 0.02);  // the handle's control point; its curve stays inside
  EXPECT_NEAR(high.x, 1.717, 0.005);
  EXPECT_NEAR(high.z, 1, 2e-3);  // the body's radius of 2 at its belly
  EXPECT_NEAR(low.z, -1, 2e-3);
}

}  // namespace
}  // namespace cg
