#include "params/input_error.h"

#include <algorithm>

namespace cg {

namespace {

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

InputError::InputError(std::string where_, Text found_, Text accepted_, long line_, long long byte_)
    : std::runtime_error(where_ + ": " + found_.en),
      where(std::move(where_)),
      found(std::move(found_)),
      accepted(std::move(accepted_)),
      line(line_),
      byte(byte_) {}

std::string InputError::message(Language language) const {
  const bool ja = language == Language::japanese;
  std::string out = where;
  if (line > 0) out += ":" + std::to_string(line);
  if (byte >= 0) out += ja ? " (" + std::to_string(byte) + " バイト目)" : " (byte " + std::to_string(byte) + ")";
  out += ": " + found.in(language);
  if (!accepted.in(language).empty()) out += (ja ? "。" : "; ") + accepted.in(language);
  return one_line(out);
}

}  // namespace cg
