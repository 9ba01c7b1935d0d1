// The two plots of a trade, described.
#include "measure/plot.h"

#include <algorithm>
#include <cmath>

#include "measure/verdict.h"

namespace cg {

namespace {

std::string unit_text(std::string_view unit) { return unit == "1" ? "" : " [" + std::string(unit) + "]"; }

Text with_unit(Text text, std::string_view unit) {
  text.en += unit_text(unit), text.ja += unit_text(unit);
  return text;
}

Text error_title(const Knob& knob) { return with_unit(knob.error, knob.error_unit); }

// From one point of the front straight to the time of the next, then down to its error: what can be had for a time.
PlotLine front_of(const Plot& plot) {
  std::vector<const PlotPoint*> front;
  for (const PlotPoint& p : plot.points)
    if (p.strong) front.push_back(&p);
  std::sort(front.begin(), front.end(), [](const PlotPoint* a, const PlotPoint* b) { return a->x < b->x; });
  PlotLine line;
  for (const PlotPoint* p : front) {
    if (!line.y.empty()) line.x.push_back(p->x), line.y.push_back(line.y.back());
    line.x.push_back(p->x), line.y.push_back(p->y);
  }
  return line;
}

void add_series_entries(const Knob& knob, Plot& plot) {
  if (knob.series.size() > 1)
    for (std::size_t s = 0; s < knob.series.size(); ++s)
      plot.legend.push_back({ink_of_series(s), Plot::Entry::Sign::dot, knob.series[s].name});
}

// A line of that slope through (x, y) on a logarithmic plot.
PlotLine power_line(double slope, double x, double y, double x_low, double x_high, PlotInk ink, bool dashed) {
  PlotLine line{{x_low, x_high}, {}, ink, dashed};
  for (const double at : line.x) line.y.push_back(y * std::pow(at / x, slope));
  return line;
}

// The measured line where it holds, and beside it the predicted slope.
void add_check(const Trade& trade, const PredictionCheck& check, Plot& plot) {
  const Knob& knob = *trade.knob;
  const Prediction& p = knob.predictions[check.prediction];
  const PlotInk ink = ink_of_series(check.prediction);
  Text name = knob.series[p.series].name;
  if (p.of != knob.plotted || knob.series.size() < knob.predictions.size())
    name = p.of == ErrorKind::max ? Text{"largest error", "最大誤差"} : Text{"RMSE", "RMSE"};
  if (!check.fit) {
    plot.legend.push_back({ink, Plot::Entry::Sign::dot, std::move(name)});
    return;
  }
  const LineFit& fit = *check.fit;
  const double middle = std::sqrt(fit.x_low * fit.x_high), beside = 1.7;
  plot.lines.push_back(power_line(fit.slope, middle, fit.at(middle), fit.x_low, fit.x_high, ink, false));
  plot.lines.push_back(power_line(p.order, middle, fit.at(middle) / beside, fit.x_low, fit.x_high, ink, true));
  const std::string measured = power_text(knob.abscissa.letter, fit.slope), law(p.law);
  plot.legend.push_back(
      {ink,
       Plot::Entry::Sign::line,
       {name.en + ": " + measured + ", predicted " + law, name.ja + "：" + measured + "、予測 " + law}});
}

}  // namespace

Plot speed_plot(const Trade& trade) {
  const Knob& knob = *trade.knob;
  Plot plot;
  plot.title = {"Error over time", "時間と誤差"};
  plot.x.title = {"CPU time a picture [ms]", "1 枚の CPU 時間 [ms]"};
  plot.y.title = error_title(knob);
  for (std::size_t i = 0; i < trade.points.size(); ++i) {
    const TradePoint& p = trade.points[i];
    const double error = error_of(p.errors, knob.plotted);
    if (!(error > 0) || !(p.ms.median > 0)) continue;
    PlotPoint point{.x = p.ms.median, .y = error};
    point.x_low = p.ms.low, point.x_high = p.ms.high;
    if (p.errors.confidence > 0) {
      point.y_low = std::max(error - p.errors.confidence, error / 10);
      point.y_high = error + p.errors.confidence;
    }
    point.series = trade.ladder.settings[i].series;
    point.label = trade.ladder.settings[i].label;
    point.strong = p.on_front;
    point.index = i;
    plot.points.push_back(std::move(point));
  }
  plot.lines.push_back(front_of(plot));
  add_series_entries(knob, plot);
  plot.legend.push_back({PlotInk::front, Plot::Entry::Sign::line, {"Pareto front", "パレートフロント"}});
  const Words numbers = knob.labels.en.empty() ? knob.abscissa.name : knob.labels;
  const auto say = [&](Text text) { plot.legend.push_back({PlotInk::dim, Plot::Entry::Sign::none, std::move(text)}); };
  say({"numbers: " + std::string(numbers.en), "数字：" + std::string(numbers.ja)});
  if (const std::string time = reference_time(trade); time != "0 ms") say({"reference: " + time, "基準：" + time});
  return plot;
}

Plot convergence_plot(const Trade& trade) {
  const Knob& knob = *trade.knob;
  Plot plot;
  plot.title = {"Order of convergence", "収束の次数"};
  plot.x.title = with_unit({std::string(knob.abscissa.letter) + ", " + std::string(knob.abscissa.name.en),
                            std::string(knob.abscissa.letter) + "（" + std::string(knob.abscissa.name.ja) + "）"},
                           knob.abscissa.unit);
  plot.y.title = with_unit({"Error", "誤差"}, knob.error_unit);
  for (const PredictionCheck& check : trade.checks) {
    const Prediction& p = knob.predictions[check.prediction];
    for (std::size_t i = 0; i < trade.points.size(); ++i) {
      const Setting& s = trade.ladder.settings[i];
      const double error = error_of(trade.points[i].errors, p.of);
      if (s.series != p.series || !(error > 0)) continue;
      PlotPoint point{.x = s.x, .y = error};
      point.series = check.prediction;
      point.strong = check.fit && s.x >= check.fit->x_low * (1 - 1e-9) && s.x <= check.fit->x_high * (1 + 1e-9);
      point.index = i;
      plot.points.push_back(std::move(point));
    }
    add_check(trade, check, plot);
  }
  plot.legend.push_back({PlotInk::dim, Plot::Entry::Sign::dashes, {"predicted slope", "予測の傾き"}});
  return plot;
}

}  // namespace cg
