// A trade written down: JSON, CSV (RFC 4180: Yakov Shafranovich, Common Format and MIME Type for CSV Files, 2005),
// lines.
#include <cmath>

#include "measure/trade.h"
#include "measure/verdict.h"
#include "params/numbers.h"
#include "workbench/preset.h"

namespace cg {

namespace {

Tree both(const Text& text) { return Tree::Members{{"en", text.en}, {"ja", text.ja}}; }

constexpr std::string_view name_of(ErrorKind kind) { return kind == ErrorKind::max ? "max" : "rmse"; }

Tree json_of(const Knob& knob, const Prediction& p) {
  return Tree::Members{{"series", knob.series[p.series].id},
                       {"of", name_of(p.of)},
                       {"order", p.order},
                       {"band", p.band},
                       {"law", p.law},
                       {"why", both(p.why)},
                       {"source", p.source}};
}

Tree json_of(const Trade& trade, std::size_t i) {
  const Setting& s = trade.ladder.settings[i];
  const TradePoint& p = trade.points[i];
  return Tree::Members{{"id", s.id},
                       {"label", both(s.label)},
                       {"series", trade.knob->series[s.series].id},
                       {"x", s.x},
                       {"technique", s.technique},
                       {"rmse", p.errors.rmse},
                       {"max", p.errors.max},
                       {"confidence", p.errors.confidence},
                       {"samples", p.errors.samples},
                       {"ms", p.ms.median},
                       {"ms_low", p.ms.low},
                       {"ms_high", p.ms.high},
                       {"on_front", p.on_front},
                       {"preset", preset_of(s.scene)}};
}

Tree json_of(const Trade& trade, const PredictionCheck& check) {
  Tree out = json_of(*trade.knob, trade.knob->predictions[check.prediction]);
  if (check.fit) {
    const LineFit& fit = *check.fit;
    const auto optional = [](const std::optional<double>& v) { return v ? Tree(*v) : Tree(); };
    out.at("slope") = fit.slope;
    out.at("standard_error") = fit.standard_error;
    out.at("x_low") = fit.x_low;
    out.at("x_high") = fit.x_high;
    out.at("points") = fit.points;
    out.at("bend_low") = optional(fit.bend_low);
    out.at("bend_high") = optional(fit.bend_high);
  }
  out.at("agrees") = check.agrees;
  out.at("verdict") = both(check.verdict);
  return out;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

}  // namespace

Tree json_of(const Knob& knob) {
  Tree::List series, predictions;
  for (const Series& s : knob.series) series.push_back(Tree::Members{{"id", s.id}, {"name", both(s.name)}});
  for (const Prediction& p : knob.predictions) predictions.push_back(json_of(knob, p));
  return Tree::Members{{"id", knob.id},
                       {"name", both(knob.name)},
                       {"help", both(knob.help)},
                       {"parameter", knob.parameter},
                       {"abscissa", Tree::Members{{"letter", knob.abscissa.letter},
                                                  {"name", both(knob.abscissa.name)},
                                                  {"unit", knob.abscissa.unit}}},
                       {"reference", both(knob.reference)},
                       {"error", both(knob.error)},
                       {"error_unit", knob.error_unit},
                       {"plotted", name_of(knob.plotted)},
                       {"series", std::move(series)},
                       {"predictions", std::move(predictions)}};
}

Tree json_of(const Trade& trade) {
  Tree::List settings, references, checks, notes;
  for (std::size_t i = 0; i < trade.points.size(); ++i) settings.push_back(json_of(trade, i));
  for (std::size_t i = 0; i < trade.reference_ms.size(); ++i)
    references.push_back(Tree::Members{{"id", trade.ladder.references[i].id}, {"ms", trade.reference_ms[i].median}});
  for (const PredictionCheck& c : trade.checks) checks.push_back(json_of(trade, c));
  for (const Text& note : trade.notes) notes.push_back(both(note));
  return Tree::Members{{"knob", json_of(*trade.knob)},
                       {"scene", trade.scene},
                       {"width", trade.width},
                       {"height", trade.height},
                       {"repeats", trade.repeats},
                       {"machine", Tree::Members{{"cpu", trade.machine.cpu}, {"renderer", trade.machine.renderer}}},
                       {"settings", std::move(settings)},
                       {"references", std::move(references)},
                       {"predictions", std::move(checks)},
                       {"notes", std::move(notes)}};
}

std::string csv_of(const Trade& trade) {
  std::string out = "id,series,x,technique,rmse,max,confidence,samples,ms,ms_low,ms_high,on_front\r\n";
  for (std::size_t i = 0; i < trade.points.size(); ++i) {
    const Setting& s = trade.ladder.settings[i];
    const TradePoint& p = trade.points[i];
    out += csv_field(s.id) + "," + csv_field(std::string(trade.knob->series[s.series].id)) + "," + number_text(s.x) +
           "," + csv_field(s.technique);
    for (const double v : {p.errors.rmse, p.errors.max, p.errors.confidence, double(p.errors.samples), p.ms.median,
                           p.ms.low, p.ms.high, p.on_front ? 1.0 : 0.0})
      out += "," + number_text(v);
    out += "\r\n";
  }
  return out;
}

std::string text_of(const Trade& trade, Language language) {
  const Knob& knob = *trade.knob;
  const auto say = [&](Words words) { return std::string(words.in(language)); };
  std::string out = say(knob.name) + say({": ", "："}) + trade.scene + ", " + std::to_string(trade.width) + "×" +
                    std::to_string(trade.height) + "\n";
  out += "  " + trade.machine.cpu + (trade.machine.renderer.empty() ? "" : "; " + trade.machine.renderer) + "\n";
  out += say({"  reference: ", "  基準："}) + say(knob.reference) + ", " + reference_time(trade) + "\n";
  for (std::size_t i = 0; i < trade.points.size(); ++i) {
    const Setting& s = trade.ladder.settings[i];
    const TradePoint& p = trade.points[i];
    out += std::string(p.on_front ? "  * " : "    ") + s.id + ": " + short_number(p.ms.median) + " ms (" +
           short_number(p.ms.low) + "–" + short_number(p.ms.high) + "), " + std::string(knob.abscissa.letter) + " " +
           short_number(s.x) + ", RMSE " + short_number(p.errors.rmse) + say({", max ", "、最大 "}) +
           short_number(p.errors.max) + "\n";
  }
  for (const PredictionCheck& c : trade.checks) {
    const Prediction& p = knob.predictions[c.prediction];
    out += "  " + std::string(c.agrees ? "✓ " : "✗ ") + say(knob.series[p.series].name) + say({": ", "："}) +
           c.verdict.in(language) + "\n";
  }
  for (const Text& note : trade.notes) out += "  ! " + note.in(language) + "\n";
  return out;
}

}  // namespace cg
