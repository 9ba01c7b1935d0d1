#include "measure/plot_ticks.h"

#include <cmath>

#include "measure/verdict.h"
#include "params/numbers.h"

namespace cg {

namespace {

std::string tick_text(double mantissa, int exponent) {
  if (exponent >= -3 && exponent <= 4) return short_number(mantissa * std::pow(10.0, exponent));
  const std::string power = "10^" + std::to_string(exponent);
  return mantissa == 1 ? power : number_text(mantissa) + "·" + power;
}

std::vector<PlotTick> ticks_with(const std::vector<double>& mantissas, int every, double low, double high) {
  std::vector<PlotTick> out;
  for (int e = int(std::floor(std::log10(low))); e <= int(std::ceil(std::log10(high))); ++e) {
    if ((e % every + every) % every != 0) continue;
    for (const double m : mantissas) {
      const double v = m * std::pow(10.0, e);
      if (v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9)) out.push_back({v, tick_text(m, e)});
    }
  }
  return out;
}

}  // namespace

std::vector<PlotTick> even_ticks(double low, double high) {
  const double rough = (high - low) / 4, unit = std::pow(10.0, std::floor(std::log10(rough)));
  double step = unit;
  for (const double m : {2.0, 5.0, 10.0})
    if (step < rough) step = m * unit;
  std::vector<PlotTick> out;
  for (double k = std::ceil(low / step); k * step <= high; ++k) out.push_back({k * step, short_number(k * step, 6)});
  return out;
}

std::vector<PlotTick> log_ticks(double low, double high) {
  const double decades = std::log10(high / low);
  if (decades > 8) return ticks_with({1}, int(std::ceil(decades / 8)), low, high);
  for (const std::vector<double>& mantissas : {std::vector<double>{1}, {1, 3}, {1, 2, 5}, {1, 1.5, 2, 3, 4, 5, 7}})
    if (auto ticks = ticks_with(mantissas, 1, low, high); ticks.size() >= 3) return ticks;
  return even_ticks(low, high);  // less than a third of a decade
}

}  // namespace cg
