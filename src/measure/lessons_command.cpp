#include "measure/lessons_command.h"

#include <filesystem>

#include "measure/lesson_report.h"
#include "params/input_error.h"
#include "params/numbers.h"
#include "workbench/command_parts.h"
#include "workbench/data_folder.h"
#include "workbench/lesson_check.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> named_folders(const std::string& name) {
  const fs::path own = data_folder() / "lessons";
  const std::vector<fs::path> all = lesson_folders(own);
  if (name.empty()) {
    if (all.empty())
      throw InputError(own.string(), {"there are no lessons", "レッスンがない"},
                       {"a lesson is a folder with lesson.json", "レッスンは lesson.json のあるフォルダ"});
    return all;
  }
  std::error_code error;
  if (fs::exists(fs::path(name) / "lesson.json", error)) return {fs::path(name)};
  std::string names;
  for (const fs::path& folder : all) {
    if (folder.filename() == name) return {folder};
    names += (names.empty() ? "" : ", ") + folder.filename().string();
  }
  throw InputError(name, {"there is no such lesson", "そのようなレッスンはない"},
                   {"known are: " + names, "あるのは " + names});
}

Tree number_or_null(const std::optional<double>& v) { return v ? Tree(*v) : Tree(); }

Tree json_of(const std::vector<LessonFinding>& findings) {
  Tree::List out;
  for (const LessonFinding& f : findings)
    out.push_back(Tree::Members{{"lesson", f.lesson},
                                {"step", f.step},
                                {"name", f.name},
                                {"value", number_or_null(f.value)},
                                {"expected", number_or_null(f.expected)},
                                {"tolerance", number_or_null(f.tolerance)},
                                {"note", f.note.en},
                                {"holds", f.holds}});
  return Tree::Members{{"findings", std::move(out)}};
}

std::string line_of(const LessonFinding& f, Language language) {
  std::string out = !f.holds ? "OFF  " : f.expected ? "ok   " : "     ";  // some numbers are only shown
  out += f.lesson + (f.step.empty() ? "" : ":" + f.step) + "  " + f.name;
  if (f.value) out += "  " + number_text(*f.value);
  if (f.expected) out += "  = " + number_text(*f.expected);
  if (f.tolerance) out += " ± " + number_text(*f.tolerance);
  if (const std::string& note = f.note.in(language); !note.empty()) out += "  (" + note + ")";
  return out + "\n";
}

int list(const std::vector<fs::path>& folders, Language language) {
  for (const fs::path& folder : folders) {
    const Lesson lesson = read_lesson(folder);
    print(lesson.id + "  " + lesson.in(language).title + "\n");
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      print("  " + lesson.id + ":" + std::to_string(i + 1) + "  " + lesson.steps[i].in(language).title + "\n");
  }
  return 0;
}

std::vector<LessonFinding> checked(const fs::path& folder, std::span<const Technique> techniques) {
  Progress progress;
  const ProgressLine line(progress, folder.filename().string());
  return check_lesson(folder, techniques, progress);
}

// A line for each finding, and their sum.
void tell(const std::vector<LessonFinding>& all, bool each, Language language) {
  std::size_t off = 0, expected = 0;
  for (const LessonFinding& f : all) {
    off += !f.holds, expected += f.expected.has_value();
    if (each || !f.holds) print(line_of(f, language));
  }
  const std::string n = std::to_string(all.size()), compared = std::to_string(expected), wrong = std::to_string(off);
  const Text sum{n + " computed, " + compared + " compared with what is expected, " + wrong + " off",
                 n + " 件を計算、うち " + compared + " 件を期待値と比較、不一致 " + wrong + " 件"};
  print(sum.in(language) + "\n");
}

}  // namespace

int run_lessons(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const std::vector<fs::path> folders = named_folders(a.scene);
  if (!a.check && a.report.empty()) return list(folders, language);
  std::vector<std::vector<LessonFinding>> findings;
  std::vector<LessonFinding> all;
  for (const fs::path& folder : folders) {
    findings.push_back(checked(folder, techniques));
    all.insert(all.end(), findings.back().begin(), findings.back().end());
  }
  bool holds = true;
  for (const LessonFinding& f : all) holds = holds && f.holds;
  if (a.json)
    print(to_json(json_of(all)) + "\n");
  else
    tell(all, a.check, language);
  if (!a.report.empty()) {
    const WrittenReport written =
        write_lesson_report(folders, std::move(findings), a.report, techniques, a.quick, language);
    holds = written.holds;
    if (!a.json) print(written.page.string() + "\n");
  }
  return holds ? 0 : 1;
}

CommandOffer lessons_command() {
  return {
      .name = "lessons",
      .help = {"List the lessons, check them, or write a report of them", "レッスンの一覧、検査、報告の作成"},
      .run = run_lessons,
      .words = {{"LESSON", &Arguments::scene}},
      .options = {{"--check",
                   nullptr,
                   {"Compute every number and task; exit with 1 where one is off",
                    "数と課題をすべて計算し、合わなければ終了状態を 1 にする"},
                   nullptr,
                   &Arguments::check},
                  {"--report",
                   "DIR",
                   {"Check, and write a page for a browser: pictures, numbers, times, trades, extremes",
                    "検査し、画像・数・時間・引き換え・極端な値をブラウザ用のページに書く"},
                   &Arguments::report},
                  {"--quick",
                   nullptr,
                   {"A report without trades and extremes: seconds instead of minutes",
                    "引き換えと極端な値を省いた報告。数分が数秒になる"},
                   nullptr,
                   &Arguments::quick},
                  {"--json", nullptr, {"One JSON object on stdout", "JSON で出力する"}, nullptr, &Arguments::json}}};
}

}  // namespace cg
