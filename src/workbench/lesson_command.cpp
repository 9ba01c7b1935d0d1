// The command `lessons`.
#include <filesystem>

#include "params/input_error.h"
#include "params/numbers.h"
#include "workbench/command_parts.h"
#include "workbench/data_folder.h"
#include "workbench/lesson_check.h"
#include "workbench/lesson_report.h"
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

void write_reports(const std::vector<fs::path>& folders, const fs::path& into, std::span<const Technique> techniques) {
  for (const fs::path& folder : folders) {
    Progress progress;
    write_lesson_report(folder, into, techniques, progress);
  }
}

}  // namespace

int run_lessons(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const std::vector<fs::path> folders = named_folders(a.scene);
  if (!a.report.empty()) write_reports(folders, a.report, techniques);
  if (!a.check) return a.report.empty() ? list(folders, language) : 0;
  std::vector<LessonFinding> all;
  for (const fs::path& folder : folders) {
    Progress progress;
    const ProgressLine line(progress, folder.filename().string());
    const std::vector<LessonFinding> findings = check_lesson(folder, techniques, progress);
    all.insert(all.end(), findings.begin(), findings.end());
  }
  std::size_t off = 0, expected = 0;
  for (const LessonFinding& f : all) off += !f.holds, expected += f.expected.has_value();
  if (a.json) {
    print(to_json(json_of(all)) + "\n");
  } else {
    for (const LessonFinding& f : all) print(line_of(f, language));
    const std::string n = std::to_string(all.size()), compared = std::to_string(expected), wrong = std::to_string(off);
    const Text sum{n + " computed, " + compared + " compared with what is expected, " + wrong + " off",
                   n + " 件を計算、うち " + compared + " 件を期待値と比較、不一致 " + wrong + " 件"};
    print(sum.in(language) + "\n");
  }
  return off == 0 ? 0 : 1;
}

}  // namespace cg
