// The trades of all knobs, as a part of the report.
#include <cmath>

#include "measure/html_lesson.h"
#include "measure/plot.h"
#include "measure/report_lesson.h"
#include "measure/report_parts.h"
#include "params/input_error.h"
#include "workbench/model_library.h"
#include "workbench/open.h"
#include "workbench/progress_line.h"

namespace cg {

namespace {

constexpr std::string_view usual_scene = "teapot";  // as of the command trade
constexpr int small = 256, few = 3;                 // pixels a side, and repeats: a minute for all on two cores

Html say(Words words, Language language) { return text(words.in(language)); }

// A slope that differs is no fault, so it has no cross.
Html agreement(bool agrees) { return element("span", {{"class", agrees ? "pass" : "source"}}, agrees ? "✓" : "≠"); }

// "h^1.98" and "N^(-3/4)" with a raised exponent.
Html with_exponents(std::string_view s) {
  Html out;
  while (!s.empty()) {
    const std::size_t at = s.find('^');
    out += text(s.substr(0, at));
    if (at == s.npos) break;
    s.remove_prefix(at + 1);
    const bool bracket = s.starts_with('(');
    std::size_t size = bracket ? s.find(')') : std::min(s.find_first_not_of("0123456789.-n"), s.size());
    if (bracket && size == s.npos) size = s.size();
    std::string_view exponent = s.substr(bracket ? 1 : 0, bracket ? size - 1 : size);
    if (!bracket && exponent.ends_with('.')) exponent.remove_suffix(1), --size;  // a sentence's full stop
    out += element("sup", text(exponent));
    s.remove_prefix(std::min(s.size(), size + (bracket ? 1 : 0)));
  }
  return out;
}

// A reason is said once for neighbours that share it.
Html checks_html(const Trade& trade, Language language) {
  Html items;
  std::string_view said;
  for (const PredictionCheck& check : trade.checks) {
    const Prediction& p = trade.knob->predictions[check.prediction];
    const std::string series =
        trade.knob->series.size() < 2 ? "" : std::string(trade.knob->series[p.series].name.in(language)) + ": ";
    Html item = agreement(check.agrees) + text(" " + series) + with_exponents(check.verdict.in(language));
    if (const std::string_view why = p.why.in(language); why != said) {
      item += text(" ") +
              element("span", {{"class", "source"}}, with_exponents(why) + text(" (" + std::string(p.source) + ")"));
      said = why;
    }
    items += element("li", item);
  }
  return element("ul", {{"class", "checks"}}, items);
}

Html knob_html(const Knob& knob, const Trade* trade, const std::optional<Text>& problem, Language language) {
  Html out = element("h3", {{"id", "trade-" + std::string(knob.id)}},
                     say(knob.name, language) + text(" ") + element("code", {{"class", "place"}}, knob.id));
  out += element("p", {{"class", "text"}}, say(knob.help, language));
  if (problem) return out + element("p", {{"class", "fail"}}, problem->in(language));
  return out + element("div", {{"class", "plot"}}, Html::of_markup(svg_of(*trade, language))) +
         checks_html(*trade, language);
}

}  // namespace

ReportPart trades_part(std::span<const Technique> techniques, int threads, Language language) {
  ReportPart part;
  part.id = "trades", part.title = {"The trade of every knob", "調整項目ごとの速さと正確さ"};
  std::size_t slopes = 0, agree = 0;
  TradeOptions options;
  options.repeats = few, options.width = options.height = small, options.threads = threads;
  for (const Knob& knob : knobs()) {
    Progress progress;
    const ProgressLine line(progress, std::string(knob.name.in(language)));
    std::optional<Trade> trade;
    std::optional<Text> problem;
    try {
      const std::string scene(knob.scene.empty() ? usual_scene : knob.scene);
      trade = run_trade(knob, scene, open_scene(scene), techniques, options, progress);
      for (const PredictionCheck& check : trade->checks) ++slopes, agree += check.agrees;
    } catch (const InputError& e) {  // the scene or a driver cannot
      problem = Text{e.message(Language::english), e.message(Language::japanese)};
    }
    for (const Language l : {Language::english, Language::japanese})
      part.body[int(l)] += knob_html(knob, trade ? &*trade : nullptr, problem, l);
  }
  const std::string n = std::to_string(slopes), as_predicted = std::to_string(agree);
  part.about = {as_predicted + " of " + n + " slopes as predicted",
                "傾き " + n + " 件のうち " + as_predicted + " 件が予測どおり"};
  return part;
}

}  // namespace cg
