#include "measure/report_lesson.h"

#include "measure/html_lesson.h"
#include "params/numbers.h"

namespace cg {

namespace {

Html say(Words words, Language language) { return text(words.in(language)); }

// A number of a table: six digits; a fault of a technique is in the first two or three.
Html figure(const std::optional<double>& v) { return v ? text(in_digits(*v, 6)) : Html(); }

Html cell(const Html& content) { return element("td", content); }
Html number_cell(const Html& content) { return element("td", {{"class", "n"}}, content); }
Html heading_cell(Words words, Language language, bool number = false) {
  return element("th", {{"scope", "col"}, {"class", number ? "n" : "t"}}, words.in(language));
}

// A value of 0..1 in steps of 8 bits.
std::string in_255ths(double v) { return in_digits(v * 255, 3, 3) + "/255"; }

Html picture_figure(const DrawnStep& drawn, Language language) {
  const std::string name = drawn.name.in(language);
  Html out = drawn.problem ? element("div", {{"class", "missing"}}, drawn.problem->in(language))
                           : void_element("img", {{"src", drawn.file}, {"alt", name}, {"loading", "lazy"}});
  Html caption = element("b", text(name));
  if (!drawn.problem)
    caption += void_element("br") + spread_html(drawn.clock) + text(" · CPU ") + spread_html(drawn.cpu);
  return element("figure", out + element("figcaption", caption));
}

Html difference_figure(const StepResult& step, Language language) {
  if (!step.difference)
    return element("figure",
                   element("div", {{"class", "missing"}},
                           say({"No difference without both pictures", "両方の画像がないと差は出ない"}, language)));
  const Difference& d = *step.difference;
  const std::string over = std::to_string(d.over_1_255) + " / " + std::to_string(d.covered);
  const std::string alone = std::to_string(d.coverage_mismatch);
  const Text name{"Difference ×" + number_text(step.seen_gain), "差 ×" + number_text(step.seen_gain)};
  const Text line{"largest " + in_255ths(d.max_error) + " · RMSE " + in_255ths(d.rmse),
                  "最大 " + in_255ths(d.max_error) + " · RMSE " + in_255ths(d.rmse)};
  const Text pixels{over + " pixels over 1/255 · " + alone + " drawn by one alone",
                    "1/255 超 " + over + " 画素 · 片方だけ " + alone + " 画素"};
  return element(
      "figure",
      void_element("img", {{"src", step.difference_file}, {"alt", name.in(language)}, {"loading", "lazy"}}) +
          element("figcaption", element("b", text(name.in(language))) + void_element("br") + text(line.in(language)) +
                                    void_element("br") + text(pixels.in(language))));
}

// What needs no language is a formula.
Html source_html(const LessonFinding& f, Language language) {
  return f.holds && f.note.en == f.note.ja ? formula_html(f.note.en) : text(f.note.in(language));
}

Html row_of(const LessonFinding& f, Language language) {
  Html name = element("code", text(f.name));
  if (f.kind == LessonFinding::task)
    name = element("span", {{"class", "kind"}}, say({"task", "課題"}, language)) + text(" ") + name;
  const bool judged = f.expected || !f.holds || f.kind == LessonFinding::task;
  return element("tr", {{"class", f.holds ? "holds" : "off"}},
                 cell(judged ? mark_of(f.holds, language) : Html()) + cell(name) + number_cell(figure(f.value)) +
                     number_cell(figure(f.expected)) +
                     number_cell(f.tolerance ? text("±" + in_digits(*f.tolerance, 2)) : Html()) +
                     element("td", {{"class", "source"}}, source_html(f, language)));
}

Html findings_table(const LessonResult& result, const std::string& step, Language language) {
  Html rows;
  for (const LessonFinding& f : result.findings)
    if (f.step == step) rows += row_of(f, language);
  if (rows.empty()) return {};
  const Html head = element("tr", element("th", {{"scope", "col"}}, Html()) + heading_cell({"Number", "数"}, language) +
                                      heading_cell({"Measured", "測定値"}, language, true) +
                                      heading_cell({"Expected", "期待値"}, language, true) +
                                      heading_cell({"Tolerance", "許容差"}, language, true) +
                                      heading_cell({"Source of what is expected", "期待値の根拠"}, language));
  return element("div", {{"class", "scroll"}},
                 element("table", {{"class", "findings"}}, element("thead", head) + element("tbody", rows)));
}

bool step_holds(const LessonResult& result, const std::string& step) {
  for (const LessonFinding& f : result.findings)
    if (f.step == step && !f.holds) return false;
  return true;
}

Html step_section(const LessonResult& result, std::size_t lesson, std::size_t index, Language language) {
  const LessonStep& step = result.lesson->steps[index];
  const StepResult& drawn = result.steps[index];
  const auto number = [&](std::string_view name) { return text_of_number(name, drawn.numbers, drawn.scene); };
  const std::string place = result.id + ":" + std::to_string(index + 1);
  const Html title = mark_of(step_holds(result, step.id), language) + text(" " + step.in(language).title + " ") +
                     element("code", {{"class", "place"}}, place);
  const Html pictures =
      picture_figure(drawn.left, language) + picture_figure(drawn.right, language) + difference_figure(drawn, language);
  return element(
      "section", {{"class", "step"}, {"id", step_anchor(lesson, index)}},
      element("h3", title) + element("div", {{"class", "pictures"}}, pictures) +
          element("div", {{"class", "text"}}, blocks_html(filled(step.in(language).blocks, number), language)) +
          findings_table(result, step.id, language));
}

}  // namespace

Html mark_of(bool holds, Language language) {
  const Words word = holds ? Words{"holds", "一致"} : Words{"off", "不一致"};
  return element("span", {{"class", holds ? "pass" : "fail"}, {"title", word.in(language)}}, holds ? "✓" : "✗");
}

std::string lesson_anchor(std::size_t lesson) { return "lesson-" + std::to_string(lesson + 1); }
std::string step_anchor(std::size_t lesson, std::size_t step) {
  return lesson_anchor(lesson) + "-" + std::to_string(step + 1);
}

Html spread_html(const Spread& s) {
  const auto ms = [](double v) { return in_digits(v, 3, 2); };
  return text(ms(s.median) + " ms ") + element("span", {{"class", "spread"}}, text(ms(s.low) + "–" + ms(s.high)));
}

Html lesson_section(const LessonResult& result, std::size_t index, Language language) {
  const std::string title = result.lesson ? result.lesson->in(language).title : result.id;
  Html out = element("h2", text(title + " ") + element("code", {{"class", "place"}}, result.id));
  if (!result.lesson)
    return element("section", {{"id", lesson_anchor(index)}}, out + findings_table(result, "", language));
  out += element("div", {{"class", "text"}}, blocks_html(result.lesson->in(language).blocks, language));
  for (std::size_t i = 0; i < result.steps.size(); ++i) out += step_section(result, index, i, language);
  return element("section", {{"class", "lesson"}, {"id", lesson_anchor(index)}}, out);
}

}  // namespace cg
