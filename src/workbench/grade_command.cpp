#include "workbench/grade_command.h"

#include <cstdio>
#include <filesystem>

#include "params/numbers.h"
#include "workbench/command_parts.h"
#include "workbench/import.h"
#include "workbench/import_command.h"
#include "workbench/model_library.h"
#include "workbench/open.h"
#include "workbench/progress_line.h"
#include "workbench/scene_differences.h"
#include "workbench/score.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

struct Hand {
  Scene scene;
  std::vector<Complaint> complaints;
};

// What was handed in: a program, a preset, or any scene.
Hand read_hand(const std::string& name) {
  if (std::filesystem::path(name).extension() != ".c") return {open_scene(name), {}};
  ImportReport report = import_file(name);
  load_meshes(report.scene);
  return {std::move(report.scene), std::move(report.complaints)};
}

// To a tenth, as it is shown and compared with --pass.
double tenths(double score) { return std::round(score * 10) / 10; }

std::optional<double> pass_mark(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto mark = parse_number(text);
  if (!mark || !(*mark >= 0 && *mark <= 100))
    throw bad_option("--pass", text, {"give a score from 0 to 100", "0 から 100 の点数を指定すること"});
  return mark;
}

Tree json_of(const Arguments& a, const Score& score, const std::vector<ParameterDifference>& differences,
             const std::vector<Complaint>& complaints, std::optional<double> mark) {
  Tree::List list, told;
  for (const ParameterDifference& d : differences)
    list.push_back(Tree::Members{{"path", d.path}, {"student", d.a}, {"target", d.b}});
  for (const Complaint& c : complaints)
    told.push_back(Tree::Members{{"line", double(c.line)}, {"text", c.text.en}, {"text_ja", c.text.ja}});
  Tree off{Tree::Members{}};
  for (std::size_t i = 0; i < score.off.size(); ++i) off.at(names_of<HintKind>[i].id) = score.off[i];
  return Tree::Members{{"student", a.scene},
                       {"target", a.target},
                       {"score", tenths(score.value)},
                       {"rmse", score.rmse},
                       {"pass", mark ? Tree(tenths(score.value) >= *mark) : Tree()},
                       {"hint", score.hint ? Tree(names_of<HintKind>[std::size_t(*score.hint)].id) : Tree()},
                       {"off", std::move(off)},
                       {"differences", std::move(list)},
                       {"complaints", std::move(told)}};
}

std::string text_of(const Arguments& a, const Score& score, const std::vector<ParameterDifference>& differences,
                    Language language) {
  std::string out = a.scene + ": " + number_text(tenths(score.value)) + " / 100 (RMSE " +
                    number_text(std::round(score.rmse * 1e5) / 1e5) + ")\n";
  if (score.hint) out += "  " + hint_text(*score.hint).in(language) + "\n";
  for (const ParameterDifference& d : differences) out += "  " + text_of(d).in(language) + "\n";
  return out;
}

}  // namespace

int run_grade(const Arguments& a, std::span<const Technique> techniques, Language language) {
  if (a.scene.empty() || a.target.empty())
    throw InputError(a.scene.empty() ? "STUDENT" : "--target", {"no scene is named", "シーンの指定がない"},
                     {"name both: shadebench grade student.json --target target.json",
                      "両方を指定すること：shadebench grade student.json --target target.json"});
  const std::optional<double> mark = pass_mark(a.pass);
  const Hand target = read_hand(a.target), student = read_hand(a.scene);
  Score score;
  {
    Progress progress;
    const ProgressLine line(progress, a.scene);
    score =
        cg::score(student.scene, target.scene, find_technique(techniques, "software"), progress, view_of(a).threads);
  }
  const auto differences = scene_differences(student.scene, target.scene);
  std::fputs(text_of(student.complaints, a.scene, language).c_str(), stderr);
  print(a.json ? to_json(json_of(a, score, differences, student.complaints, mark)) + "\n"
               : text_of(a, score, differences, language));
  return mark && tenths(score.value) < *mark ? 1 : 0;
}

}  // namespace cg
