// import and grade from end to end, as a shell loop over a class uses them.
#include <gtest/gtest.h>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

constexpr const char* program =
    "GLfloat red[] = {0.8, 0.1, 0.1, 1};\n"
    "void display(void) {\n"
    "  gluLookAt(0,1,3.4, 0,0,0, 0,1,0);\n"
    "  glMaterialfv(GL_FRONT, GL_DIFFUSE, red);\n"
    "  glMaterialf(GL_FRONT, GL_SHININESS, wildly);\n"
    "}\n";

class GradeTest : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {}) {
    return run_program(SHADEBENCH_PROGRAM, folder, arguments, environment);
  }
  const TemporaryFolder folder;
};

TEST_F(GradeTest, ImportWritesAPresetAndComplainsByLine) {
  save_file(folder / "課題 1.c", program);
  const Outcome o = run({"import", "課題 1.c", "-o", "a.json"}),
                ja = run({"import", "課題 1.c", "-o", "a.json"}, {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err, "課題 1.c:5: 'wildly' is not known: this glMaterialf is left out\n");
  EXPECT_EQ(ja.err, "課題 1.c:5: 「wildly」が分からない：この glMaterialf は読み込まない\n");
  const Tree preset = parse_json(read_file(folder / "a.json"), "a.json");
  EXPECT_EQ(to_json(*preset.find("material")->find("k_d"), 0), "[0.8,0.1,0.1]");
  EXPECT_EQ(run({"render", "a.json", "-o", "a.png", "--size", "32x32"}).status, 0);
}

TEST_F(GradeTest, MistakesAreOneLine) {
  save_file(folder / "a.c", program);
  save_file(folder / "empty.c", "int main(void) { return 0; }\n");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"import", "none.c", "-o", "a.json"},
                                             {"import", "a.c"},
                                             {"import", "a.c", "-o", "a.png"},
                                             {"import", "empty.c", "-o", "a.json"},
                                             {"import", "-o", "a.json"},
                                             {"grade", "a.c"},
                                             {"grade", "none.json", "--target", "teapot"},
                                             {"grade", "teapot", "--target", "none.json"},
                                             {"grade", "teapot", "--target", "teapot", "--pass", "200"}}) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.status, 2) << arguments[1];
    EXPECT_EQ(o.error_lines(), 1u) << o.err;
    EXPECT_EQ(o.out, "");
  }
}

TEST_F(GradeTest, TheScoreAndOneLineAParameter) {
  save_file(folder / "t.json", R"({"schema": 1, "model": "teapot", "material": {"n": 64}})");
  save_file(folder / "s.json", R"({"schema": 1, "model": "teapot", "material": {"k_d": [1, 0, 0]}})");
  const Outcome same = run({"grade", "t.json", "--target", "t.json", "--pass", "100"});
  EXPECT_EQ(same.status, 0);
  EXPECT_EQ(same.out, "t.json: 100 / 100 (RMSE 0)\n");
  const Outcome other = run({"grade", "s.json", "--target", "t.json", "--pass", "99"});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.out.find("  material.k_d [1,0,0] → [0.8,0.8,0.8]\n  material.n 32 → 64\n"), other.out.npos)
      << other.out;
  EXPECT_NE(other.out.find("diffuse term is furthest off"), other.out.npos);
  const Outcome json = run({"grade", "s.json", "--target", "t.json", "--json"}, {{"LC_ALL", "de_DE.UTF-8"}});
  EXPECT_EQ(json.status, 0);
  EXPECT_EQ(json.out, run({"grade", "s.json", "--target", "t.json", "--json"}).out);
  const Tree t = parse_json(json.out, "grade");
  EXPECT_EQ(*t.find("hint")->string(), "diffuse");
  EXPECT_EQ(t.find("differences")->list()->size(), 2u);
  EXPECT_TRUE(t.find("pass")->is_null());
}

TEST_F(GradeTest, AProgramIsGradedAsItsPreset) {
  save_file(folder / "a.c", program);
  ASSERT_EQ(run({"import", "a.c", "-o", "a.json"}).status, 0);
  const Outcome o = run({"grade", "a.c", "--target", "a.json", "--json"});
  EXPECT_EQ(o.status, 0);
  const Tree t = parse_json(o.out, "grade");
  EXPECT_EQ(*t.find("score")->number(), 100);
  EXPECT_TRUE(t.find("differences")->list()->empty());
  EXPECT_EQ(*t.find("complaints")->list()->at(0).find("line")->number(), 5);
}

}  // namespace
}  // namespace cg
