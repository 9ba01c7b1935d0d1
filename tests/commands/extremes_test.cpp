// The command `extremes` from end to end, as far as no display is needed.
#include <gtest/gtest.h>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

class ExtremesCommandTest : public testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments, const Environment& environment = {}) {
    arguments.insert(arguments.begin(), "extremes");
    return run_program(SHADEBENCH_PROGRAM, folder, arguments, environment);
  }
  const TemporaryFolder folder;
};

TEST_F(ExtremesCommandTest, AGroupAsJson) {
  const Outcome o = run({"materials", "--technique", "software", "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  const Tree json = parse_json(o.out, "out");
  const Tree::List& cases = *json.find("cases")->list();
  EXPECT_GE(cases.size(), 15u);
  for (const Tree& c : cases) {
    for (const char* key : {"id", "group", "name", "parameter", "value", "right", "tolerance", "results"})
      EXPECT_TRUE(c.find(key)) << key;
    for (const Tree& r : *c.find("results")->list()) EXPECT_EQ(*r.find("verdict")->string(), "right");
  }
}

TEST_F(ExtremesCommandTest, ANaiveFormulaBesideARobustOne) {
  const Outcome o = run({"naive-normalize", "--json"});
  EXPECT_EQ(o.status, 0) << o.err;
  const Tree naive = *parse_json(o.out, "out").find("cases")->list()->at(0).find("naive");
  EXPECT_TRUE(naive.find("rows")->list()->at(0).find("naive")->is_null());  // 0/0
  EXPECT_EQ(*naive.find("rows")->list()->at(0).find("robust")->number(), 0);
  for (const char* language : {"en", "ja"}) EXPECT_FALSE(naive.find("why")->find(language)->string()->empty());
  EXPECT_NE(run({"naive-normalize"}, {{"LANG", "ja_JP.UTF-8"}}).out.find("頑健"), std::string::npos);
}

TEST_F(ExtremesCommandTest, ListsAndRefuses) {
  const Outcome list = run({"--list"});
  EXPECT_EQ(list.status, 0);
  EXPECT_GE(std::count(list.out.begin(), list.out.end(), '\n'), 60);
  const Outcome unknown = run({"no-such"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.error_lines(), 1u);
  EXPECT_NE(unknown.err.find("arithmetic"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace cg
