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

// What tests/commands/report_page.py has to say about the pages in `into`.
Outcome read_pages(const TemporaryFolder& folder, const std::string& into) {
  return run_program(SHADEBENCH_PYTHON, folder, {SHADEBENCH_SOURCE_DIR "/tests/commands/report_page.py", into});
}

TEST(LessonsCommand, ReportsAsAPage) {
  const TemporaryFolder folder;
  const Outcome report =
      run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "03-shading", "--report", "new/report", "--quick"});
  EXPECT_EQ(report.status, 0) << report.out << report.err;
  EXPECT_NE(report.out.find("new/report/index.html\n"), std::string::npos) << report.out;
  const Outcome pages = read_pages(folder, "new/report");
  EXPECT_EQ(pages.status, 0) << pages.out << pages.err;
  for (const char* file : {"new/report/index.html", "new/report/index.ja.html"}) {
    const std::string page = read_file(folder / file);
    EXPECT_NE(page.find("0.9342"), std::string::npos);  // |p| of the middle face, (1 + √5)/(2√3)
    EXPECT_EQ(page.find("class=\"fail\""), std::string::npos);
    EXPECT_NE(page.find("pictures/03-shading-6-difference.png"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "new/report/.out"));
}

// A lesson of a lecturer's own, with a number that is wrong and texts that would break a page.
void write_wrong_lesson(const TemporaryFolder& folder) {
  std::filesystem::create_directory(folder / "mine");
  save_file(folder / "mine/lesson.json",
            R"({"schema": 1, "steps": [{"id": "a", "scene": {"model": "cube"}, "numbers":
               {"two": {"value": "1 + 1", "expect": "3", "tolerance": 0.5, "source": "arithmetic"}}}]})");
  for (const char* file : {"mine/lesson.en.md", "mine/lesson.ja.md"})
    save_file(folder / file, "# A & `<b>`\n\n## 1 < 2 & \"B\" {#a}\n\n`<script>` の $a < b & c$: {{two}}\n");
}

TEST(LessonsCommand, AWrongNumberIsStatusOne) {
  const TemporaryFolder folder;
  write_wrong_lesson(folder);
  const Outcome check = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "mine", "--check"});
  EXPECT_EQ(check.status, 1) << check.out << check.err;
  EXPECT_NE(check.out.find("OFF  mine:a  two  2  = 3"), std::string::npos) << check.out;
}

TEST(LessonsCommand, AReportSaysThatANumberIsOff) {
  const TemporaryFolder folder;
  write_wrong_lesson(folder);
  const Outcome report = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "mine", "--report", "out", "--quick"},
                                     {{"LANG", "ja_JP.UTF-8"}});
  EXPECT_EQ(report.status, 1) << report.out << report.err;
  EXPECT_NE(report.out.find("out/index.ja.html"), std::string::npos) << report.out;
  const Outcome pages = read_pages(folder, "out");
  EXPECT_EQ(pages.status, 0) << pages.out << pages.err;
  const std::string page = read_file(folder / "out/index.html");
  EXPECT_NE(page.find("1 of 1 do not hold"), std::string::npos);
  EXPECT_NE(page.find("<code>&lt;script&gt;</code>"), std::string::npos);
  EXPECT_NE(read_file(folder / "out/index.ja.html").find("1 件のうち 1 件が不一致"), std::string::npos);
}

// Files that cannot be written leave no half page.
TEST(LessonsCommand, AReportThatCannotBeWrittenSaysWhere) {
  const TemporaryFolder folder;
  write_wrong_lesson(folder);
  save_file(folder / "file", "");
  const Outcome report = run_program(SHADEBENCH_PROGRAM, folder, {"lessons", "mine", "--report", "file/in", "--quick"});
  EXPECT_EQ(report.status, 2);
  EXPECT_EQ(report.error_lines(), 1u) << report.err;
  EXPECT_NE(report.err.find("file/in"), std::string::npos) << report.err;
}

}  // namespace
}  // namespace cg
