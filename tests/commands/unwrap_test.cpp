// shadebench unwrap, as a person types it.
#include <gtest/gtest.h>

#include <cmath>

#include "params/file.h"
#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

class UnwrapCommandTest : public testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments, const Environment& environment = {}) {
    arguments.insert(arguments.begin(), "unwrap");
    return run_program(SHADEBENCH_PROGRAM, folder, arguments, environment);
  }
  static double number(const Tree& t, const char* key) {
    const Tree* found = t.find(key);
    return found && found->number() ? *found->number() : NAN;
  }
  TemporaryFolder folder;
};

TEST_F(UnwrapCommandTest, FiguresInJson) {
  const Outcome o = run({"cylinder", "--json"});
  ASSERT_EQ(o.status, 0) << o.err;
  const Tree t = parse_json(o.out, "unwrap");
  EXPECT_EQ(number(t, "triangles"), 1632);
  EXPECT_GE(number(t, "charts"), 3);  // its side and two discs, or more
  EXPECT_EQ(number(t, "flipped"), 0);
  EXPECT_EQ(number(t, "overlapping_pixels"), 0);
  EXPECT_NEAR(number(t, "mean_quasi_conformal"), 1, 0.05);
  EXPECT_GT(number(t, "share_used"), 0.5);
  EXPECT_LE(number(t, "share_used"), 1);
  EXPECT_GT(number(t, "seconds"), 0);
  EXPECT_EQ(*t.find("method")->string(), "lscm");
}

TEST_F(UnwrapCommandTest, TheModelWithItsUvReadsBack) {
  const std::string obj = (folder / "out.obj").string();
  ASSERT_EQ(run({"teapot", "-o", obj}).status, 0);
  EXPECT_NE(read_file(obj).find("\nvt 0."), std::string::npos);
  // Unwrapped again, it is the same surface.
  const Tree a = parse_json(run({"teapot", "--json"}).out, ""), b = parse_json(run({obj, "--json"}).out, "");
  for (const char* key : {"triangles", "charts", "area_distortion", "share_used"})
    EXPECT_EQ(number(a, key), number(b, key)) << key;
}

TEST_F(UnwrapCommandTest, TheLayoutAsPictures) {
  const std::string svg = (folder / "out.svg").string(), png = (folder / "out.png").string();
  ASSERT_EQ(run({"cube", "-o", svg, "--size", "300"}).status, 0);
  EXPECT_EQ(read_file(svg).find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\""), 0u);
  ASSERT_EQ(run({"cube", "-o", png, "--size", "64"}).status, 0);
  EXPECT_EQ(read_file(png).substr(1, 3), "PNG");
}

TEST_F(UnwrapCommandTest, MistakesAreToldInOneLine) {
  const std::string fins = (folder / "fins.obj").string();
  save_file(fins, "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  struct Case {
    std::vector<std::string> arguments;
    const char* says;
  };
  for (const Case& c : {Case{{fins}, "has 3 faces"}, Case{{"cube", "--method", "magic"}, "lscm"},
                        Case{{"cube", "--size", "5"}, "from 16 to 8192"}, Case{{"cube", "-o", "out.gif"}, ".svg"},
                        Case{{"cube", "--set", "margin"}, "NAME=VALUE"}, Case{{"cube", "--set", "margins=3"}, "margin"},
                        Case{{}, "no scene is named"}}) {
    const Outcome o = run(c.arguments);
    EXPECT_EQ(o.status, 2) << c.says;
    EXPECT_EQ(o.out, "") << c.says;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << o.err;
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  }
}

// --set and its short cuts are taken together, in either order.
TEST_F(UnwrapCommandTest, MethodsDiffer) {
  const Tree conformal = parse_json(run({"torus", "--set", "automatic_seams=false", "--json"}).out, "");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"torus", "--method", "mean-value", "--set", "automatic_seams=false", "--json"},
        {"torus", "--set", "automatic_seams=false", "--set", "margin=2", "--method", "mean-value", "--json"}}) {
    const Tree round = parse_json(run(arguments).out, "");
    EXPECT_EQ(*round.find("method")->string(), "mean-value");
    EXPECT_EQ(number(round, "charts"), 1);
    EXPECT_EQ(number(round, "flipped"), 0);
    EXPECT_GT(number(round, "mean_quasi_conformal"), number(conformal, "mean_quasi_conformal"));
  }
}

}  // namespace
}  // namespace cg
