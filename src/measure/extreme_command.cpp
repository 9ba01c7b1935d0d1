#include "measure/extreme_command.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "params/numbers.h"
#include "workbench/command_parts.h"
#include "workbench/progress_line.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

constexpr int error_digits = 3, value_digits = 8;

std::string rounded(double v, int digits) {
  if (std::isnan(v)) return "NaN";
  if (!std::isfinite(v) || v == 0) return number_text(v + 0.0);  // + 0.0: no -0
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::scientific, digits - 1);
  return number_text(parse_number({text.data(), end.ptr}).value_or(v));
}

const Name& name_of(Verdict v) { return names_of<Verdict>[std::size_t(v)]; }

Tree both_languages(const Text& text) { return Tree::Members{{"en", text.en}, {"ja", text.ja}}; }

Tree rows_tree(const Naive& naive) {
  Tree::List rows;
  for (const Naive::Row& r : naive.rows()) {
    // JSON has no NaN: a result that is none is null.
    rows.push_back(Tree::Members{{"input", r.input}, {"naive", r.naive}, {"robust", r.robust}, {"right", r.right}});
  }
  return Tree::Members{{"naive", naive.naive_formula},
                       {"robust", naive.robust_formula},
                       {"why", both_languages(naive.why)},
                       {"rows", std::move(rows)}};
}

Tree case_tree(const ExtremeCase& c) {
  Tree::Members out{{"id", c.id},
                    {"group", c.group},
                    {"name", both_languages(c.name)},
                    {"parameter", c.parameter},
                    {"value", c.value},
                    {"right", both_languages(c.right)},
                    {"tolerance", c.tolerance}};
  if (c.scene) {
    Tree::List techniques;
    for (const std::string_view id : c.techniques) techniques.push_back(id);
    out.emplace_back("techniques", std::move(techniques));
  }
  if (c.input) out.emplace_back("text", c.input->text);
  if (c.driver_fault)
    out.emplace_back("driver_fault", Tree::Members{{"technique", c.driver_fault->technique},
                                                   {"what", both_languages(c.driver_fault->what)}});
  if (c.naive) out.emplace_back("naive", rows_tree(*c.naive));
  return out;
}

Tree result_tree(const ExtremeResult& r) {
  Tree::Members out{{"by", r.by}, {"verdict", name_of(r.verdict).id}};
  if (r.verdict != Verdict::not_drawn && r.verdict != Verdict::unavailable) out.emplace_back("error", r.error);
  out.emplace_back("said", both_languages(r.said));
  out.emplace_back("ms", std::round(r.ms * 1000) / 1000);
  return out;
}

std::size_t count_of(std::span<const ExtremeResult> results, Verdict v) {
  return std::size_t(std::count_if(results.begin(), results.end(), [v](const auto& r) { return r.verdict == v; }));
}

std::string naive_text(const Naive& naive, Language language) {
  const bool ja = language == Language::japanese;
  std::string out;
  for (const Naive::Row& r : naive.rows())
    out += "    " + r.input + (ja ? "： 素朴 " : ": naive ") + rounded(r.naive, value_digits) +
           (ja ? "、頑健 " : ", robust ") + rounded(r.robust, value_digits) + (ja ? "、正解 " : ", right ") +
           rounded(r.right, value_digits) + "\n";
  return out + "    " + naive.naive_formula + (ja ? " → " : " -> ") + naive.robust_formula + "\n    " +
         std::string(naive.why.in(language)) + "\n";
}

std::string result_text(const ExtremeResult& r, Language language) {
  const std::string_view verdict = name_of(r.verdict).label.in(language);
  std::string line = "    " + r.by + std::string(r.by.size() < 15 ? 15 - r.by.size() : 1, ' ') + std::string(verdict);
  const bool exact = r.verdict == Verdict::right && r.error == 0;
  if (r.verdict != Verdict::not_drawn && r.verdict != Verdict::unavailable && !exact && !std::isnan(r.error))
    line += " " + rounded(r.error, error_digits);
  if (!r.said.en.empty() && (r.verdict != Verdict::right || !exact || r.by == "reader"))
    line += (language == Language::japanese ? "：" : ": ") + r.said.in(language);
  return line + "\n";
}

std::string summary(std::span<const ExtremeResult> results, std::size_t cases, Language language) {
  const bool ja = language == Language::japanese;
  std::string out = std::to_string(cases) + (ja ? " 事例、" : " cases, ") + std::to_string(results.size()) +
                    (ja ? " 結果" : " results");
  for (const Verdict v :
       {Verdict::right, Verdict::off, Verdict::broken, Verdict::driver, Verdict::not_drawn, Verdict::unavailable}) {
    const std::string n = std::to_string(count_of(results, v));
    const std::string name(name_of(v).label.in(language));
    out += ja ? "、" + name + " " + n : ", " + n + " " + name;
  }
  return out + "\n";
}

std::string list_text(const std::vector<const ExtremeCase*>& cases, Language language) {
  std::string out;
  for (const ExtremeCase* c : cases)
    out += c->id + (language == Language::japanese ? "：" : ": ") + c->name.in(language) + "\n";
  return out;
}

std::vector<Technique> chosen(const std::string& id, std::span<const Technique> all) {
  if (id.empty()) return {all.begin(), all.end()};
  return {find_technique(all, id)};
}

}  // namespace

std::string text_of(const ExtremeCase& c, std::span<const ExtremeResult> results, Language language) {
  std::string out = c.id + (language == Language::japanese ? "：" : ": ") + c.name.in(language) + ", " + c.parameter +
                    " = " + c.value + "\n    " + c.right.in(language) + "\n";
  for (const ExtremeResult& r : results) out += result_text(r, language);
  if (c.naive) out += naive_text(*c.naive, language);
  return out;
}

Tree json_of(std::span<const ExtremeResult> results) {
  Tree::List cases;
  for (std::size_t i = 0; i < results.size();) {
    const ExtremeCase* const subject = results[i].subject;
    Tree one = case_tree(*subject);
    Tree::List given;
    for (; i < results.size() && results[i].subject == subject; ++i) given.push_back(result_tree(results[i]));
    one.at("results") = std::move(given);
    cases.push_back(std::move(one));
  }
  Tree out = Tree::Members{{"cases", std::move(cases)}};
  for (std::size_t v = 0; v < names_of<Verdict>.size(); ++v)
    out.at(names_of<Verdict>[v].id) = count_of(results, Verdict(v));
  return out;
}

int run_extremes_command(const Arguments& a, std::span<const Technique> techniques, Language language) {
  const auto cases = find_extremes(a.extreme, extreme_cases());
  if (a.list && !a.json) {
    print(list_text(cases, language));
    return 0;
  }
  const std::vector<Technique> used = chosen(a.technique, techniques);
  std::vector<ExtremeResult> results;
  {
    Progress progress;
    const ProgressLine line(progress, language == Language::japanese ? "極端な値" : "extremes");
    results = run_extremes(cases, used, progress, [&](std::span<const ExtremeResult> one) {
      if (!a.json && !one.empty()) print(text_of(*one[0].subject, one, language));
    });
  }
  print(a.json ? to_json(json_of(results)) + "\n" : summary(results, cases.size(), language));
  return std::any_of(results.begin(), results.end(), [](const auto& r) { return is_failure(r.verdict); }) ? 1 : 0;
}

CommandOffer extremes_command() {
  CommandOffer offer{
      .name = "extremes",
      .help = {"Check every parameter and input at its extremes", "パラメータと入力を極端な値で検査する"},
      .run = run_extremes_command,
      .words = {{"CASE", &Arguments::extreme}},
      .options = {},
      .draws = false};
  offer.options.push_back({"--technique", "T", {"One technique; else all", "手法を一つに限る"}, &Arguments::technique});
  offer.options.push_back(
      {"--list", nullptr, {"Only list the cases", "事例の一覧だけを表示する"}, nullptr, &Arguments::list});
  offer.options.push_back(
      {"--json", nullptr, {"One JSON object on stdout", "JSON で出力する"}, nullptr, &Arguments::json});
  return offer;
}

}  // namespace cg
