// Every number and every task of every lesson, computed by the program.
#include <gtest/gtest.h>

#include "params/tree.h"
#include "tests/commands/run_program.h"

namespace cg {
namespace {

TEST(LessonsCommand, EveryNumberHolds) {
  const TemporaryFolder folder;
  const Outcome check = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "--check", "--json"});
  EXPECT_EQ(check.status, 0) << check.err;
  const Tree tree = parse_json(check.out, "lessons --check --json");
  const Tree::List& findings = *tree.find("findings")->list();
  EXPECT_GT(findings.size(), 25u);
  for (const Tree& f : findings) EXPECT_EQ(*f.find("holds"), Tree(true)) << to_json(f);
}

TEST(LessonsCommand, ListsAndNamesMistakes) {
  const TemporaryFolder folder;
  const Outcome list = run_program(SHADEBENCH_PROGRAM, folder, {"lessons"}, {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("01-light-model:2"), std::string::npos);
  const Outcome none = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "99-nothing"});
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.error_lines(), 1u);
  EXPECT_NE(none.err.find("01-light-model"), std::string::npos);
}

TEST(LessonsCommand, WritesTheTextsWithTheirNumbers) {
  const TemporaryFolder folder;
  const Outcome report = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "03-shading", "--report", "new/texts"});
  EXPECT_EQ(report.status, 0) << report.err;
  for (const char* file : {"new/texts/03-shading.en.md", "new/texts/03-shading.ja.md"}) {
    const std::string text = read_file(folder / file);
    EXPECT_EQ(text.find("{{"), std::string::npos);
    EXPECT_EQ(text.find("…"), std::string::npos);
    EXPECT_NE(text.find("0.9342"), std::string::npos);  // |p| of the middle face, (1 + √5)/(2√3)
  }
}

// A lesson of a lecturer's own, with a number that is wrong.
TEST(LessonsCommand, AWrongNumberIsStatusOne) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "mine");
  save_file(folder / "mine/lesson.json",
            R"({"schema": 1, "steps": [{"id": "a", "scene": {"model": "cube"}, "numbers":
               {"two": {"value": "1 + 1", "expect": "3", "tolerance": 0.5, "source": "arithmetic"}}}]})");
  for (const char* file : {"mine/lesson.en.md", "mine/lesson.ja.md"}) save_file(folder / file, "# A\n\n## B {#a}\n");
  const Outcome check = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "mine", "--check"});
  EXPECT_EQ(check.status, 1) << check.out << check.err;
  EXPECT_NE(check.out.find("OFF  mine:a  two  2  = 3"), std::string::npos) << check.out;
}

}  // namespace
}  // namespace cg
