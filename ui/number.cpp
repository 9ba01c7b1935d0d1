#include "ui/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cg {
namespace {

double span(const About& a) { return a.slider_range().max - a.slider_range().min; }

double rounded_to(double value, int decimals) {
  const double power = std::pow(10.0, decimals);
  const double r = std::round(value * power) / power;
  return std::isfinite(r) ? r + 0.0 : value;  // + 0.0: no "-0.00"
}

// To `digits` significant digits.
double rounded_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  return rounded_to(value, std::clamp(digits - 1 - int(std::floor(std::log10(std::abs(value)))), -300, 300));
}

std::string to_text(double value, std::chars_format format, int precision) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format, precision);
  return end.ec == std::errc() ? std::string(buffer, end.ptr) : "?";
}

double limited(const About& a, double value) { return std::clamp(value, a.range.min, a.range.max); }

}  // namespace

int decimals(const About& about) {
  if (about.scale == Scale::logarithmic) return 0;
  const double step = span(about) / 100;
  return step > 0 && std::isfinite(step) ? std::clamp(int(std::ceil(-std::log10(step))), 0, 6) : 2;
}

std::string number_text(double value, int decimals, std::size_t room) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-Inf" : "Inf";
  if (std::abs(value) < 1e9) {
    const std::string fixed = to_text(value, std::chars_format::fixed, decimals);
    double back = 0;
    std::from_chars(fixed.data(), fixed.data() + fixed.size(), back);
    if (back == value && fixed.size() <= room) return fixed;
  }
  char buffer[64];
  const std::string exact(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  if (exact.size() <= room) return exact;
  for (int precision = 9; precision > 1; --precision)
    if (std::string s = to_text(value, std::chars_format::general, precision); s.size() <= room) return s;
  return to_text(value, std::chars_format::scientific, 0);
}

std::string rounded(double value, int decimals) { return to_text(value, std::chars_format::fixed, decimals); }

double slider_position(const About& about, double value) {
  const Range r = about.slider_range();
  if (!(r.max > r.min) || std::isnan(value)) return 0;
  const double v = std::clamp(value, r.min, r.max);
  return about.scale == Scale::logarithmic && r.min > 0 ? std::log(v / r.min) / std::log(r.max / r.min)
                                                        : (v - r.min) / (r.max - r.min);
}

double slider_value(const About& about, double position, bool fine) {
  const Range r = about.slider_range();
  const double t = position > 0 ? std::min(position, 1.0) : 0.0;
  if (t == 0) return r.min;
  if (t == 1) return r.max;
  if (about.scale == Scale::logarithmic && r.min > 0) {
    const double v = rounded_digits(r.min * std::pow(r.max / r.min, t), fine ? 4 : 2);
    return std::clamp(v, r.min, r.max);
  }
  return std::clamp(rounded_to(r.min + t * (r.max - r.min), decimals(about) + fine), r.min, r.max);
}

double stepped(const About& about, double value, double steps, bool fine) {
  if (!std::isfinite(value) || !std::isfinite(steps)) return value;
  if (about.scale == Scale::logarithmic) {
    const double factor = std::pow(fine ? 1.01 : 1.05, steps);
    const double start = value > 0 ? value : about.slider_range().min;
    return limited(about, rounded_digits(start * factor, fine ? 4 : 3));
  }
  const int places = decimals(about) + fine;
  return limited(about, rounded_to(value + steps * std::pow(10.0, -places), std::max(places, 6)));
}

}  // namespace cg
