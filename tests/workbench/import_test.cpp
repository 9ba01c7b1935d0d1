// Students' C read back: values, the order of calls, what is left out, and any bytes.
#include "workbench/import.h"

#include <gtest/gtest.h>

#include "params/input_error.h"

namespace cg {
namespace {

struct Imported {
  Scene scene;
  std::vector<Complaint> complaints;
  // The complaints of a line, joined.
  std::string at(long line) const {
    std::string out;
    for (const Complaint& c : complaints)
      if (c.line == line) out += (out.empty() ? "" : " | ") + c.text.en;
    return out;
  }
  std::string all() const {
    std::string out;
    for (const Complaint& c : complaints) out += std::to_string(c.line) + ": " + c.text.en + "\n";
    return out;
  }
};

Imported read(std::string_view text) {
  ImportReport r = import_c(text, "test.c");
  return {std::move(r.scene), std::move(r.complaints)};
}

// The statements in a part of a program, where gluLookAt comes first.
Imported statements(const std::string& text) { return read("gluLookAt(0,0,5, 0,0,0, 0,1,0);\n" + text); }

TEST(Import, LightsAsTheyAreWritten) {
  const Imported i = statements(
      "GLfloat p[] = { 10.0, 10.0f, 1e1, 1 }; const float d[4] = {0.1, .2, 3e-1f};\n"
      "glLightfv(GL_LIGHT0, GL_POSITION, p); glLightfv(GL_LIGHT0, GL_DIFFUSE, d); glEnable(GL_LIGHT0);\n");
  EXPECT_EQ(i.all(), "");
  ASSERT_EQ(i.scene.lights.size(), 1u);
  const Light& l = i.scene.lights[0];
  EXPECT_EQ(l.kind, LightKind::point);
  EXPECT_EQ(l.position, glm::dvec3(10));
  EXPECT_EQ(l.diffuse, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(l.specular, glm::dvec3(1));
  EXPECT_TRUE(l.enabled);
}

TEST(Import, OpenGlsDefaultsHoldForWhatIsNotSet) {
  const Imported i = statements(
      "GLfloat p[] = {1,2,3,1}; int k; for (k = 0; k < 2; k++) { glEnable(GL_LIGHT0 + k); glLightfv(GL_LIGHT0 + k, "
      "GL_POSITION, p); }\n");
  ASSERT_EQ(i.scene.lights.size(), 2u);
  EXPECT_EQ(i.scene.lights[0].diffuse, glm::dvec3(1));
  EXPECT_EQ(i.scene.lights[1].diffuse, glm::dvec3(0));
  EXPECT_EQ(i.scene.material.k_s, glm::dvec3(0));
  EXPECT_EQ(i.scene.material.n, 0);
  EXPECT_EQ(i.scene.shading.ambient, glm::dvec3(0.2));
  EXPECT_TRUE(read("glEnable(GL_DEPTH_TEST);").scene.lights.empty());
}

TEST(Import, WholeNumbersAreDividedAsCDoes) {
  const Imported i = statements(
      "#define HALF 1/2\nfloat a = 1/2.0, b = (1 + 2)*2 - 7/2, c = 0x10, d = sqrt(16) + cos(0.0);\n"
      "float m[] = {a, HALF, (float)1/2, 1};\nglMaterialfv(GL_FRONT, GL_DIFFUSE, m);\n"
      "glTranslatef(b, c, d);\nglRotatef(180.0*M_PI/M_PI, 0, -2, 0);\n");
  EXPECT_EQ(i.scene.material.k_d, glm::dvec3(0.5, 0, 0.5));
  EXPECT_EQ(i.scene.objects.at(0).transform.translate, glm::dvec3(3, 16, 5));
  EXPECT_EQ(i.scene.objects.at(0).transform.rotate, glm::dvec3(0, -180, 0));
  EXPECT_EQ(i.at(4), "1/2 of whole numbers is 0 in C");
}

TEST(Import, NothingOfOpenGlIsAnError) {
  EXPECT_THROW(read(""), InputError);
  EXPECT_THROW(read("int main(void) { return 0; }"), InputError);
  EXPECT_THROW(read(std::string(largest_c_file + 1, ' ')), InputError);
}

}  // namespace
}  // namespace cg
