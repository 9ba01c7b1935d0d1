#include "params/numbers.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace cg {

std::string number_text(double v) {
  if (std::isnan(v)) return "nan";  // whatever its sign
  std::array<char, 32> text{};
  // to_chars alone takes the fewest characters: 1e+05. People read 100000.
  const bool fixed = v == 0 || (std::abs(v) >= 1e-5 && std::abs(v) < 1e15);
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), v,
                                          fixed ? std::chars_format::fixed : std::chars_format::scientific);
  assert(error == std::errc());
  return {text.data(), end};
}

std::string c_literal(double v) {
  assert(std::isfinite(v));
  std::string text = number_text(v);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  double v = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(v)) return std::nullopt;
  return v;
}

}  // namespace cg
