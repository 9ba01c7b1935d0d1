// The extremes, as a part of the report: how many are right by whom, what is not, and each formula that fails in float
// beside the one that does not.
#include <algorithm>
#include <cmath>

#include "measure/extreme_run.h"
#include "measure/report_lesson.h"
#include "measure/report_parts.h"
#include "workbench/lesson_numbers.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

using Results = std::vector<ExtremeResult>;

Html say(Words words, Language language) { return text(words.in(language)); }
Html td(const Html& content) { return element("td", content); }
Html n(const Html& content) { return element("td", {{"class", "n"}}, content); }
Html th(Words words, Language language, const char* kind = "t") {
  return element("th", {{"scope", "col"}, {"class", kind}}, words.in(language));
}
Html table(const char* kind, const Html& head, const Html& rows) {
  return element("div", {{"class", "scroll"}},
                 element("table", {{"class", kind}}, element("thead", element("tr", head)) + element("tbody", rows)));
}

std::vector<std::string> subjects_of(const Results& results) {
  std::vector<std::string> out;
  for (const ExtremeResult& r : results)
    if (std::find(out.begin(), out.end(), r.by) == out.end()) out.push_back(r.by);
  return out;
}

// By whom, and how it came out.
Html summary(const Results& results, Language language) {
  Html head = th({"By", "対象"}, language), rows;
  for (const Name& verdict : names_of<Verdict>) head += th(verdict.label, language, "n");
  for (const std::string& by : subjects_of(results)) {
    Html row = td(element("code", text(by)));
    for (std::size_t v = 0; v < names_of<Verdict>.size(); ++v) {
      const auto count = std::count_if(results.begin(), results.end(),
                                       [&](const auto& r) { return r.by == by && r.verdict == Verdict(v); });
      row += n(text(count == 0 ? "" : std::to_string(count)));
    }
    rows += element("tr", row);
  }
  return table("contents", head, rows);
}

// What is not right, and what a driver is at fault for.
Html faults(const Results& results, Language language) {
  Html rows;
  for (const ExtremeResult& r : results) {
    if (!is_failure(r.verdict) && r.verdict != Verdict::driver) continue;
    const ExtremeCase& c = *r.subject;
    const bool driver = r.verdict == Verdict::driver && c.driver_fault;
    const std::string said = driver ? c.driver_fault->what.in(language) : r.said.in(language);
    rows += element("tr", {{"class", is_failure(r.verdict) ? "off" : "holds"}},
                    td(text(c.name.in(language))) + td(element("code", text(c.parameter + " = " + c.value))) +
                        td(element("code", text(r.by))) +
                        td(say(names_of<Verdict>[std::size_t(r.verdict)].label, language)) +
                        element("td", {{"class", "source"}}, said));
  }
  if (rows.empty()) return {};
  return table("faults",
               th({"Case", "事例"}, language) + th({"Value", "値"}, language) + th({"By", "対象"}, language) +
                   th({"Result", "結果"}, language) + th({"What is seen", "内容"}, language),
               rows);
}

std::string digits(double v) {
  if (std::isnan(v)) return "NaN";
  return std::isinf(v) ? v < 0 ? "-∞" : "∞" : in_digits(v, 3);
}

Html naive_rows(const Naive& naive, Language language) {
  Html rows;
  for (const Naive::Row& row : naive.rows())
    rows += element("tr", td(element("code", text(row.input))) + n(text(digits(row.naive))) +
                              n(text(digits(row.robust))) + n(text(digits(row.right))));
  return table("naive",
               th({"Input", "入力"}, language) + th({"Naive", "素朴"}, language, "n") +
                   th({"Robust", "頑健"}, language, "n") + th({"Right", "正解"}, language, "n"),
               rows);
}

Html formulas(const Results& results, Language language) {
  Html out;
  for (const ExtremeResult& r : results) {
    if (!r.subject->naive) continue;
    const Naive& naive = *r.subject->naive;
    Html one = element("h4", text(r.subject->name.in(language)));
    one += element(
        "p", element("code", text(naive.naive_formula)) + text(" → ") + element("code", text(naive.robust_formula)));
    one += element("p", {{"class", "source"}}, naive.why.in(language)) + naive_rows(naive, language);
    out += element("div", {{"class", "formula-case"}}, one);
  }
  if (out.empty()) return {};
  return element("h3", say({"A formula in float, naive and robust", "float での素朴な式と頑健な式"}, language)) +
         element("div", {{"class", "formula-cases"}}, out);
}

}  // namespace

ReportPart extremes_part(std::span<const Technique> techniques, Language language) {
  ReportPart part;
  part.id = "extremes", part.title = {"Extremes", "極端な値"};
  const auto cases = find_extremes("", extreme_cases());
  Results results;
  {
    Progress progress;
    const ProgressLine line(progress, std::string(part.title.in(language)));
    results = run_extremes(cases, techniques, progress);
  }
  for (const ExtremeResult& r : results) {
    part.off += is_failure(r.verdict);
    part.compared += r.verdict != Verdict::not_drawn && r.verdict != Verdict::unavailable;
  }
  const std::string count = std::to_string(cases.size());
  part.about = {count + " cases", count + " 事例"};
  for (const Language l : {Language::english, Language::japanese})
    part.body[int(l)] = summary(results, l) + faults(results, l) + formulas(results, l);
  return part;
}

}  // namespace cg
