// Import of programs that are damaged, endless, deep or large; and of the mistakes with lights that need several calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "params/file.h"
#include "params/input_error.h"
#include "params/slots.h"
#include "scene/cpu_clock.h"
#include "workbench/import.h"

namespace cg {
namespace {

std::string all(const ImportReport& report) {
  std::string out;
  for (const Complaint& c : report.complaints) out += std::to_string(c.line) + ": " + c.text.en + "\n";
  return out;
}

// Anything is read, or refused by an InputError, within ten seconds of processor time; what is read fits the
// description.
void expect_sound(const std::string& text) {
  const double begin = thread_cpu_ms();
  try {
    ImportReport report = import_c(text, "a.c");
    for (const Slot& slot : slots(report.scene)) assign(slot, slot_tree(slot));
    for (const Complaint& c : report.complaints) {
      EXPECT_FALSE(c.text.en.empty() || c.text.ja.empty());
      EXPECT_EQ(c.text.en.find('\n'), c.text.en.npos);
    }
  } catch (const InputError& e) {
    EXPECT_EQ(e.message(Language::japanese).find('\n'), std::string::npos);
  }
  EXPECT_LT(thread_cpu_ms() - begin, 10e3) << text.substr(0, 200);
}

TEST(ImportRobust, DamagedPrograms) {
  std::mt19937 random(11);
  std::vector<std::string> programs;
  for (const auto& file : std::filesystem::directory_iterator(SHADEBENCH_SOURCE_DIR "/tests/workbench/student_c"))
    programs.push_back(read_file(file.path()));
  std::sort(programs.begin(), programs.end());
  for (int i = 0; i < 3000; ++i) {
    std::string text = programs[random() % programs.size()];
    for (unsigned k = random() % 8; k > 0; --k) {
      const std::size_t at = random() % text.size(), n = std::min<std::size_t>(random() % 40, text.size() - at);
      switch (random() % 4) {
        case 0:
          text.erase(at, n);
          break;
        case 1:
          text.insert(at, text.substr(random() % text.size(), n));
          break;
        case 2:
          text[at] = char(random());
          break;
        default:
          text.insert(at, 1, "(){}[];,*/#\"'\\\n"[random() % 15]);
      }
      if (text.empty()) text = "x";
    }
    SCOPED_TRACE(text);
    ASSERT_NO_FATAL_FAILURE(expect_sound(text));
  }
}

TEST(ImportRobust, DeepLongAndEndlessInLittleTime) {
  const auto many = [](const std::string& part, std::size_t bytes = largest_c_file - 1000) {
    std::string out;
    while (out.size() + part.size() < bytes) out += part;
    return out;
  };
  const std::string gl = "glEnable(GL_LIGHT0);\n";
  for (const char* part : {"(",       "{",       "[",  "-",       "x=",   "if(1)", "else ",          "a(",   "a(;",
                           "{a(",     "\"",      "/*", "#if 1\n", "1+",   "a.",    "int a[",         "f(){", "};",
                           "struct{", "case 1:", "x?", "&",       "a[1]", "\\\n",  "f(){}g(){f(0);}"}) {
    expect_sound(gl + many(part));
    expect_sound(gl + "float a = " + many(part));
    expect_sound("void display() { " + gl + many(part));
  }
  expect_sound(gl + "void f() { while (1) ; } void display() { for (;;) f(); }");
  expect_sound(gl + "void f() { f(); f(); } void display() { f(); }");
  expect_sound(gl + "int a[700][700], b[99999999], c[-1]; " + many("int x[400000];", 2000));
  expect_sound(
      "#define A B B B B B B B B\n#define B C C C C C C C C\n#define C D D D D D D D D\n"
      "#define D E E E E E E E E\n#define E F F F F F F F F\n#define F G G G G G G G G\n" +
      gl + "A");
  expect_sound(gl + "#define F(x) F(x x) x x\nF(F(F(F(F(F(F(F(1))))))))");
}

const char* view = "gluLookAt(0,0,5, 0,0,0, 0,1,0);\n";

TEST(ImportLights, OneBeforeTheViewAndOneBehindIt) {
  const ImportReport r = import_c(
      "float p[] = {1, 2, 3, 1}; float q[] = {4, 5, 6, 1};\n"
      "glEnable(GL_LIGHT0); glEnable(GL_LIGHT1);\n"
      "glLightfv(GL_LIGHT0, GL_POSITION, p);\n" +
          std::string(view) + "glLightfv(GL_LIGHT1, GL_POSITION, q);\n",
      "a.c");
  EXPECT_EQ(all(r), "3: GL_LIGHT0 is placed before gluLookAt: it turns with the camera\n");
  EXPECT_FALSE(r.scene.mistakes.light_before_view);
  EXPECT_EQ(r.scene.lights[0].position, glm::dvec3(1, 2, 8));  // where it stands in the world while the eye is at z = 5
  EXPECT_EQ(r.scene.lights[1].position, glm::dvec3(4, 5, 6));
}

TEST(ImportLights, AnAttenuationWithWZeroIsAMistake) {
  const ImportReport r =
      import_c(std::string(view) +
                   "float p[] = {1, 2, 3, 0};\nglEnable(GL_LIGHT0);\n"
                   "glLightfv(GL_LIGHT0, GL_POSITION, p); glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5);\n",
               "a.c");
  EXPECT_EQ(all(r), "4: w = 0: GL_LIGHT0 is directional, and its attenuation or cone has no place to begin\n");
  EXPECT_TRUE(r.scene.mistakes.directional_w);
  EXPECT_EQ(r.scene.lights[0].kind, LightKind::point);
  EXPECT_EQ(r.scene.lights[0].w, 1);
  EXPECT_EQ(r.scene.lights[0].k_1, 0.5);
}

TEST(ImportLights, GivenUnderAModelTransform) {
  const ImportReport r = import_c(std::string(view) +
                                      "float p[] = {1, 0, 0, 1}, d[] = {1, 0, 0};\nglEnable(GL_LIGHT0);\n"
                                      "glTranslatef(0, 0, 2); glRotatef(90, 0, 0, 1);\n"
                                      "glLightfv(GL_LIGHT0, GL_POSITION, p); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 20);\n"
                                      "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, d);\n",
                                  "a.c");
  EXPECT_EQ(all(r), "");
  EXPECT_EQ(r.scene.lights[0].position, glm::dvec3(0, 1, 2));
  EXPECT_EQ(r.scene.lights[0].direction, glm::dvec3(0, 1, 0));
}

TEST(ImportLights, LookAtOnTheProjection) {
  const ImportReport r = import_c(
      "glMatrixMode(GL_PROJECTION); gluPerspective(30, 1, 1, 20);\ngluLookAt(1,2,3, 0,0,0, 0,1,0);\n"
      "glMatrixMode(GL_MODELVIEW); float p[] = {1, 2, 3, 1}; glLightfv(GL_LIGHT0, GL_POSITION, p); "
      "glEnable(GL_LIGHT0);\n",
      "a.c");
  EXPECT_EQ(r.complaints.size(), 1u);
  EXPECT_EQ(r.complaints[0].line, 2);
  EXPECT_EQ(r.scene.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(r.scene.lights[0].position, glm::dvec3(1, 2, 3));
}

// What hangs on something unknown is not known either.
TEST(ImportUnknown, BranchesAreLeftOutAndTheirVariablesForgotten) {
  const ImportReport r = import_c(
      "float n = 5, m = 6;\n"
      "void display() {\n"
      "  if (rand() % 2) n = 10; else n = 20;\n"
      "  if (rand() % 2)\n"
      "    glShadeModel(GL_FLAT);\n"
      "  glMaterialf(GL_FRONT, GL_SHININESS, n);\n"
      "  glTranslatef(m, 0, 0);\n"
      "}\n",
      "a.c");
  EXPECT_EQ(all(r),
            "4: the result of rand is known only to the running program: what depends on it is left out\n"
            "6: the result of rand is known only to the running program: this glMaterialf is left out\n");
  EXPECT_EQ(r.scene.shading.mode, ShadingMode::gouraud);
  EXPECT_EQ(r.scene.material.n, 0);
  EXPECT_EQ(r.scene.objects[0].transform.translate, glm::dvec3(6, 0, 0));
}

// A variable that lives on inside display() changes from picture to picture.
TEST(ImportUnknown, StaticVariablesOfDisplay) {
  const ImportReport r = import_c(
      "void spin(void) {\n"
      "  static int r = 0; static float size = 2;\n"
      "  glRotated((double)r, 0, 1, 0);\n"
      "  glScalef(size, size, size);\n"
      "  if (++r >= 360) r = 0;\n"
      "}\n"
      "void display(void) { glEnable(GL_NORMALIZE); spin(); glutSolidSphere(1, 16, 8); }\n",
      "a.c");
  EXPECT_EQ(all(r),
            "3: 'r' changes while the program runs: this glRotated is left out\n"
            "5: 'r' changes while the program runs: taken as in the first picture\n");
  EXPECT_EQ(r.scene.objects[0].transform.scale, glm::dvec3(2));
}

// Without main(), too, what keys and the clock change is not the first picture's.
TEST(ImportUnknown, EventsOfAPartOfAProgram) {
  const ImportReport r = import_c(
      "float x = 1, y = 2;\n"
      "void myIdle(void) { x += 1; }\n"
      "void keyboard(unsigned char key, int a, int b) { glShadeModel(GL_FLAT); }\n"
      "void display(void) { glTranslatef(x, 0, 0); glTranslatef(0, y, 0); }\n",
      "a.c");
  EXPECT_EQ(all(r), "4: 'x' changes while the program runs: this glTranslatef is left out\n");
  EXPECT_EQ(r.scene.objects[0].transform.translate, glm::dvec3(0, 2, 0));
  EXPECT_EQ(r.scene.shading.mode, ShadingMode::gouraud);
}

TEST(ImportUnknown, WhatAFunctionMayChangeIsForgotten) {
  const ImportReport r = import_c(
      "float a[] = {1, 1, 1, 1}, b[] = {0.5, 0.5, 0.5, 1};\n"
      "void display() {\n"
      "  scanf(\"%f\", &a[1]);\n"
      "  printf(\"%f\", b[1]);\n"
      "  glMaterialfv(GL_FRONT, GL_DIFFUSE, a);\n"
      "  glMaterialfv(GL_FRONT, GL_SPECULAR, b);\n"
      "}\n",
      "a.c");
  EXPECT_EQ(all(r), "5: 'scanf' may change 'a': this glMaterialfv is left out\n");
  EXPECT_EQ(r.scene.material.k_d, glm::dvec3(0.8));
  EXPECT_EQ(r.scene.material.k_s, glm::dvec3(0.5));
}

}  // namespace
}  // namespace cg
