#include "scene/text_scanner.h"

#include <algorithm>
#include <cstring>

namespace cg {

namespace {

// The length of the UTF-8 character that begins at text[i], or 0 where there is none (RFC 3629, section 4).
std::size_t character_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? std::uint8_t(text[k]) : std::uint8_t(0); };
  const std::uint8_t first = byte(i), second = byte(i + 1);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first < 0xf5                  ? 4
                                                             : 0;
  if (first < 0xc2 || length == 0) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool outside = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return overlong || outside ? 0 : length;
}

}  // namespace

std::string readable(std::string_view bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = character_length(bytes, i);
    const auto c = std::uint8_t(bytes[i]);
    if (length == 0 || c < 0x20 || c == 0x7f) {
      constexpr char digits[] = "0123456789abcdef";
      out += {'\\', 'x', digits[c >> 4], digits[c & 15]};
      ++i;
    } else {
      out += bytes.substr(i, length);
      i += length;
    }
  }
  return out;
}

Text in_quotes(std::string_view word) {
  constexpr std::size_t most = 40;
  std::size_t end = std::min(word.size(), most);
  while (end < word.size() && end > 0 && (std::uint8_t(word[end]) & 0xc0) == 0x80) --end;
  const std::string shown = readable(word.substr(0, end)) + (end < word.size() ? "…" : "");
  return {"'" + shown + "'", "「" + shown + "」"};
}

Text phrase(const Words& words, std::initializer_list<Text> values) {
  const auto fill = [&](std::string_view pattern, std::string Text::*side) {
    std::string out;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      const bool slot = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
      const std::size_t number = slot ? std::size_t(pattern[i + 1] - '0') : values.size();
      if (number < values.size()) {
        out += values.begin()[number].*side;
        i += 2;
      } else {
        out += pattern[i];
      }
    }
    return out;
  };
  return {fill(words.en, &Text::en), fill(words.ja, &Text::ja)};
}

TextScanner::TextScanner(std::string_view text, std::string where, TextRules rules)
    : text_(text), where_(std::move(where)), rules_(rules) {
  p_ = end_ = next_ = text_.data();
  lf_ = cr_ = nullptr;
  const auto begins = [&](std::string_view mark) { return text_.substr(0, mark.size()) == mark; };
  if (begins("\xff\xfe") || begins("\xfe\xff"))
    throw InputError(where_, {"the text is UTF-16", "文字コードが UTF-16"}, {"UTF-8 is read", "UTF-8 なら読める"}, 1);
  if (begins("\xef\xbb\xbf")) next_ += 3;
}

const char* TextScanner::find_line_end(const char* from) {
  const char* end = text_.data() + text_.size();
  const auto find = [&](char c) {
    const void* at = from < end ? std::memchr(from, c, std::size_t(end - from)) : nullptr;
    return at ? static_cast<const char*>(at) : end;
  };
  if (!lf_ || lf_ < from) lf_ = find('\n');
  if (!cr_ || cr_ < from) cr_ = find('\r');
  return std::min(lf_, cr_);
}

void TextScanner::take_line() {
  const char* end = text_.data() + text_.size();
  end_ = find_line_end(next_);
  next_ = end_;
  if (next_ < end) next_ += *next_ == '\r' && next_ + 1 < end && next_[1] == '\n' ? 2 : 1;
  ++next_line_;
}

// A backslash at the end of the line joins the next one to it. It does not in a comment, nor behind a byte of a
// multi-byte character: the second byte of many Shift-JIS characters is a backslash.
void TextScanner::join_lines() {
  const char *end = text_.data() + text_.size(), *first = p_;
  while (first < end_ && is_space(*first)) ++first;
  if (first < end_ && *first == rules_.comment) return;
  while (end_ > p_ && end_[-1] == '\\' && !(end_ - p_ >= 2 && std::uint8_t(end_[-2]) >= 0x80)) {
    if (next_ == end) {
      end_ = end;  // nothing is there to be joined
      return;
    }
    take_line();
  }
}

bool TextScanner::next_line() {
  const char* end = text_.data() + text_.size();
  do {
    if (next_ == end) return false;
    line_ = next_line_;
    p_ = next_;
    take_line();
    if (rules_.joins_lines) join_lines();
  } while (at_end());
  return true;
}

std::string_view TextScanner::rest() {
  skip_space();
  const char* begin = p_;
  p_ = end_;
  while (p_ > begin && is_space(p_[-1])) --p_;
  const std::string_view all(begin, std::size_t(p_ - begin));
  p_ = end_;
  return all;
}

double TextScanner::odd_number(const Words& what) {
  const std::string_view found = word();
  const Text accepted =
      phrase({"{0} is expected, such as -1.5 or 2e-3", "{0}には -1.5 や 2e-3 のような数を書く"}, {what});
  if (found.empty()) fail(phrase({"the line ends where {0} is expected", "{0}がないまま行が終わっている"}, {what}));
  const std::string_view unsigned_part = found.substr(found[0] == '+' ? 1 : 0);
  double value = 0;
  const auto [stop, error] = std::from_chars(unsigned_part.data(), unsigned_part.data() + unsigned_part.size(), value);
  const bool whole = stop == found.data() + found.size() && (found[0] != '+' || unsigned_part.substr(0, 1) != "-");
  if (whole && error == std::errc::result_out_of_range) {
    // from_chars does not tell too small, which is 0, from too large.
    long double wide = 0;
    const auto again = std::from_chars(unsigned_part.data(), stop, wide);
    if (again.ec == std::errc{} && std::abs(wide) < 1) return 0;
    fail(phrase({"{0} is outside the range of numbers", "{0}は扱える数の範囲を超えている"}, {in_quotes(found)}),
         {"numbers up to 1e308 are read", "1e308 までの数なら読める"});
  }
  if (whole && error == std::errc{})
    fail(phrase({"{0} is not a finite number", "{0}は有限の数ではない"}, {in_quotes(found)}), accepted);
  if (stop < found.data() + found.size() && *stop == ',' && error == std::errc{})
    fail(phrase({"{0} has a comma", "{0}にコンマがある"}, {in_quotes(found)}),
         {"numbers have a decimal point, such as 1.5", "小数点には 1.5 のようにピリオドを使う"});
  fail(phrase({"{0} is not a number", "{0}は数ではない"}, {in_quotes(found)}), accepted);
}

std::int64_t TextScanner::integer(const Words& what) {
  const std::string_view found = word();
  if (found.empty()) fail(phrase({"the line ends where {0} is expected", "{0}がないまま行が終わっている"}, {what}));
  std::int64_t value = 0;
  const char* end = found.data() + found.size();
  const auto [stop, error] = std::from_chars(found.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    fail(phrase({"{0} is not a whole number", "{0}は整数ではない"}, {in_quotes(found)}),
         phrase({"{0} is expected", "{0}が必要"}, {what}));
  if (error != std::errc{}) fail(phrase({"{0} is too large a number", "{0}は数として大きすぎる"}, {in_quotes(found)}));
  return value;
}

void TextScanner::expect_end(const Text& accepted) {
  if (at_end()) return;
  fail(phrase({"{0} is more than this line should have", "この行には{0}が余分にある"}, {in_quotes(word())}), accepted);
}

void TextScanner::fail(Text found, Text accepted) const {
  throw InputError(where_, std::move(found), std::move(accepted), std::max(line_, 1L));
}

}  // namespace cg
