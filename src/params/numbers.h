// Numbers as text, in the C locale whatever the process's locale is.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace cg {

// The fewest digits that read back as the same bits: "0.1", "100000", "-0", "1e+20". Not finite: "nan", "inf", "-inf".
std::string number_text(double v);

// The same as C source that stays a double: "1.0", "-0.0", "1e+20". `v` is finite.
std::string c_literal(double v);

// The number that the whole of `text` spells ("0.5", "+1", "1e-3"), or nothing: words, blanks, hexadecimal, nan,
// inf, and what leaves double's range (1e400).
std::optional<double> parse_number(std::string_view text);

}  // namespace cg
