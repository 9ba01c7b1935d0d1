#include "measure/verdict.h"

#include <algorithm>
#include <cmath>

#include "params/numbers.h"

namespace cg {

namespace {

// A sentence put behind what stands there.
void append(Text& to, const Text& sentence) {
  to.en += (to.en.empty() ? "" : " ") + sentence.en;
  to.ja += sentence.ja;
}

std::string two_digits(double v) { return number_text(std::round(v * 100) / 100 + 0.0); }

Text nothing_to_fit(const Knob& knob) {
  const std::string letter(knob.abscissa.letter);
  return {"No slope: fewer than two settings have an error above 0.",
          "誤差が 0 でない設定が二つ未満なので、傾きは求められない。"};
}

Text slope_text(const Trade& trade, const PredictionCheck& check, const Prediction& prediction) {
  const Knob& knob = *trade.knob;
  const std::string letter(knob.abscissa.letter);
  const std::string measured = power_text(letter, check.fit->slope), error = two_digits(check.fit->standard_error),
                    predicted(prediction.law);
  const bool max = prediction.of == ErrorKind::max;
  if (check.agrees)
    return {std::string(max ? "The largest error goes" : "The error goes") + " as " + measured + " (standard error " +
                error + "), as predicted: " + predicted + ".",
            std::string(max ? "最大誤差" : "誤差") + "は " + measured + "（標準誤差 " + error + "）で変わり、予測 " +
                predicted + " と合う。"};
  return {std::string(max ? "The largest error goes" : "The error goes") + " as " + measured + " (standard error " +
              error + "), not as predicted: " + predicted + ".",
          std::string(max ? "最大誤差" : "誤差") + "は " + measured + "（標準誤差 " + error + "）で変わり、予測 " +
              predicted + " と合わない。"};
}

Text bend_text(const Knob& knob, double at, Words why) {
  const std::string place = std::string(knob.abscissa.letter) + " = " + short_number(at);
  return {"From " + place + " on the curve bends: " + std::string(why.en),
          place + " から先で曲線は直線を外れる。" + std::string(why.ja)};
}

}  // namespace

std::string power_text(std::string_view letter, double exponent) {
  return std::string(letter) + "^" + two_digits(exponent);
}

std::string short_number(double v, int digits) {
  if (v == 0 || !std::isfinite(v)) return number_text(v);
  const int exponent = int(std::floor(std::log10(std::abs(v))));
  // By its decimal text, so that 0.3 does not become 0.30000000000000004.
  const long long mantissa = std::llround(v / std::pow(10.0, exponent - digits + 1));
  const auto decimal = [&](int power) {
    return number_text(parse_number(std::to_string(mantissa) + "e" + std::to_string(power)).value_or(v));
  };
  if (exponent >= -3 && exponent <= 5) return decimal(exponent - digits + 1);
  return decimal(1 - digits) + "e" + std::to_string(exponent);
}

std::string reference_time(const Trade& trade) {
  if (trade.reference_ms.empty()) return {};
  const auto [low, high] = std::minmax_element(trade.reference_ms.begin(), trade.reference_ms.end(),
                                               [](const Spread& a, const Spread& b) { return a.median < b.median; });
  const std::string least = short_number(low->median), most = short_number(high->median);
  return (least == most ? least : least + "–" + most) + " ms";
}

PredictionCheck check_prediction(const Trade& trade, std::size_t index) {
  const Knob& knob = *trade.knob;
  const Prediction& prediction = knob.predictions[index];
  PredictionCheck check;
  check.prediction = index;
  std::vector<double> x, error;
  for (std::size_t i = 0; i < trade.points.size(); ++i)
    if (trade.ladder.settings[i].series == prediction.series) {
      x.push_back(trade.ladder.settings[i].x);
      error.push_back(error_of(trade.points[i].errors, prediction.of));
    }
  check.fit = fit_straight_part(x, error);
  if (!check.fit) {
    check.verdict = nothing_to_fit(knob);
    return check;
  }
  check.agrees = std::abs(check.fit->slope - prediction.order) <= prediction.band;
  append(check.verdict, slope_text(trade, check, prediction));
  if (check.fit->bend_low) append(check.verdict, bend_text(knob, *check.fit->bend_low, knob.bend_low));
  if (check.fit->bend_high) append(check.verdict, bend_text(knob, *check.fit->bend_high, knob.bend_high));
  if (!check.agrees) append(check.verdict, prediction.otherwise);
  return check;
}

}  // namespace cg
