#include "measure/report_page.h"

#include "embedded_css.h"
#include "measure/report_lesson.h"

namespace cg {

namespace {

Html say(Words words, Language language) { return text(words.in(language)); }
Html link_to(const std::string& anchor, const Html& content) { return element("a", {{"href", "#" + anchor}}, content); }
std::string count_text(std::size_t n) { return std::to_string(n); }

Html verdict(const Report& report, Language language) {
  const std::string all = count_text(report.compared()), off = count_text(report.off());
  const bool holds = report.off() == 0;
  const Text line = holds ? Text{"All " + all + " hold", all + " 件すべて一致"}
                          : Text{off + " of " + all + " do not hold", all + " 件のうち " + off + " 件が不一致"};
  Html out =
      element("p", {{"class", holds ? "verdict pass" : "verdict fail"}}, (holds ? "✓ " : "✗ ") + line.in(language));
  out += element("p", {{"class", "lead"}},
                 say({"Numbers and tasks of the lessons, compared with what theory or another technique expects, on "
                      "this machine.",
                      "授業の数と課題を、理論や別の手法による期待値と、この計算機の上で比べた結果。"},
                     language));
  return out;
}

// What does not hold, each with a way to it.
Html failures(const Report& report, Language language) {
  Html items;
  for (std::size_t l = 0; l < report.lessons.size(); ++l) {
    const LessonResult& result = report.lessons[l];
    for (const LessonFinding& f : result.findings) {
      if (f.holds) continue;
      std::string anchor = lesson_anchor(l);
      for (std::size_t i = 0; result.lesson && i < result.lesson->steps.size(); ++i)
        if (result.lesson->steps[i].id == f.step) anchor = step_anchor(l, i);
      const std::string where = f.lesson + (f.step.empty() ? "" : ":" + f.step) + "  " + f.name;
      items += element("li", link_to(anchor, element("code", text(where))) + text(" " + f.note.in(language)));
    }
  }
  for (const ReportPart& part : report.parts)
    if (part.off > 0)
      items +=
          element("li", link_to(std::string(part.id), say(part.title, language)) + text(" " + count_text(part.off)));
  return items.empty() ? Html() : element("ul", {{"class", "failures"}}, items);
}

Html facts(const Report& report, Language language) {
  Html rows;
  for (const ReportFact& fact : report.facts)
    rows += element("dt", say(fact.name, language)) + element("dd", text(fact.value.in(language)));
  return element("dl", {{"class", "facts"}}, rows);
}

Html contents_row(const std::string& anchor, const Html& title, std::size_t compared, std::size_t off,
                  const Html& about, Language language) {
  const auto n = [](const Html& h) { return element("td", {{"class", "n"}}, h); };
  return element("tr", element("td", mark_of(off == 0, language)) + element("td", link_to(anchor, title)) +
                           element("td", about) + n(text(count_text(compared))) + n(text(count_text(off))));
}

Html contents(const Report& report, Language language) {
  Html rows;
  for (std::size_t l = 0; l < report.lessons.size(); ++l) {
    const LessonResult& r = report.lessons[l];
    const std::string steps = count_text(r.steps.size()), tasks = count_text(r.count(LessonFinding::task));
    const Text about{steps + " steps, " + tasks + " tasks", steps + " ステップ、" + tasks + " 課題"};
    rows += contents_row(lesson_anchor(l), text(r.lesson ? r.lesson->in(language).title : r.id), r.compared(), r.off(),
                         text(about.in(language)), language);
  }
  for (const ReportPart& part : report.parts)
    rows += contents_row(std::string(part.id), say(part.title, language), part.compared, part.off,
                         text(part.about.in(language)), language);
  const auto th = [&](Words words, const char* kind) {
    return element("th", {{"scope", "col"}, {"class", kind}}, words.in(language));
  };
  const Html head = element("tr", element("th", {{"scope", "col"}}, Html()) + th({"Part", "内容"}, "t") +
                                      element("th", {{"scope", "col"}}, Html()) + th({"Compared", "比較"}, "n") +
                                      th({"Off", "不一致"}, "n"));
  return element("table", {{"class", "contents"}}, element("thead", head) + element("tbody", rows));
}

Html head(Language language) {
  const std::string title = "Shadebench: " + std::string(Words{"report", "報告"}.in(language));
  return element("head",
                 void_element("meta", {{"charset", "utf-8"}}) +
                     void_element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
                     element("title", text(title)) + element("style", Html::of_markup(std::string(report_css))));
}

Html switch_of(Language shown) {
  const Language other = shown == Language::english ? Language::japanese : Language::english;
  const auto name = [](Language l) { return l == Language::english ? "English" : "日本語"; };
  const auto code = [](Language l) { return l == Language::english ? "en" : "ja"; };
  const Html here = element("span", {{"class", "here"}}, name(shown));
  const Html there =
      element("a", {{"href", page_file(other)}, {"hreflang", code(other)}, {"lang", code(other)}}, name(other));
  return element("nav", {{"class", "languages"}}, shown == Language::english ? here + there : there + here);
}

}  // namespace

std::size_t Report::compared() const {
  std::size_t n = 0;
  for (const LessonResult& r : lessons) n += r.compared();
  for (const ReportPart& part : parts) n += part.compared;
  return n;
}
std::size_t Report::off() const {
  std::size_t n = 0;
  for (const LessonResult& r : lessons) n += r.off();
  for (const ReportPart& part : parts) n += part.off;
  return n;
}

std::string_view page_file(Language language) { return language == Language::english ? "index.html" : "index.ja.html"; }

std::string report_page(const Report& report, Language language) {
  const Html top = switch_of(language) + element("h1", text("Shadebench")) + verdict(report, language) +
                   failures(report, language) + facts(report, language) + contents(report, language);
  Html main = element("header", top);
  for (std::size_t i = 0; i < report.lessons.size(); ++i) main += lesson_section(report.lessons[i], i, language);
  for (const ReportPart& part : report.parts)
    main += element("section", {{"class", "part"}, {"id", part.id}},
                    element("h2", say(part.title, language)) + part.body[int(language)]);
  const std::string_view code = language == Language::english ? "en" : "ja";
  return "<!DOCTYPE html>\n" +
         element("html", {{"xmlns", "http://www.w3.org/1999/xhtml"}, {"lang", code}},
                 head(language) + element("body", element("main", main)))
             .markup() +
         "\n";
}

}  // namespace cg
