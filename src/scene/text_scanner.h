// Lines, words and numbers of a text file that lies in memory, for the strict readers. Nothing is copied; line ends
// are LF, CR LF or CR; numbers are read in the C locale. Every complaint is an InputError with file and line.
#pragma once
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "params/input_error.h"

namespace cg {

// What a text scanner leaves out between words.
struct TextRules {
  char comment = '\0';       // a word that begins with it ends the line; '\0': there are no comments
  bool joins_lines = false;  // a line that ends in a backslash goes on in the next (OBJ, MTL)
};

class TextScanner {
 public:
  // `text` must outlive the scanner. A UTF-8 byte order mark is skipped; UTF-16 is an InputError.
  TextScanner(std::string_view text, std::string where, TextRules rules);

  // Goes to the next line that has a word in it. False at the end of the text.
  bool next_line();

  // The next word of this line; empty where there is none left.
  std::string_view word() {
    skip_space();
    const char* begin = p_;
    if (ended()) return {};
    while (p_ < end_ && !is_gap(p_)) ++p_;
    return {begin, std::size_t(p_ - begin)};
  }

  // The next word, which stays the next.
  std::string_view peek() {
    skip_space();
    const char* begin = p_;
    const std::string_view next = word();
    p_ = begin;
    return next;
  }

  // Goes back to `part`, which must be of a word of this line.
  void rewind(std::string_view part) { p_ = part.data(); }

  int words_left() {
    const char* begin = p_;
    int n = 0;
    while (!word().empty()) ++n;
    p_ = begin;
    return n;
  }

  // What is left of this line, without the spaces around it; comments are not looked for.
  std::string_view rest();

  // True where this line has no word left.
  bool at_end() {
    skip_space();
    return ended();
  }

  // The next word as a finite number, or InputError. `what` is expected here: {"an x coordinate", "x 座標"}.
  double number(const Words& what) {
    skip_space();
    const char* begin = p_ < end_ && *p_ == '+' ? p_ + 1 : p_;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end_, value);
    if (error != std::errc{} || !std::isfinite(value) || (stop < end_ && !is_gap(stop)) ||
        (begin > p_ && *begin == '-'))
      return odd_number(what);
    p_ = stop;
    return value;
  }

  // The next word as a whole number, or InputError.
  std::int64_t integer(const Words& what);

  // InputError where this line has a word left.
  void expect_end(const Text& accepted);

  // Throws InputError with this line. `found` and `accepted` are phrases.
  [[noreturn]] void fail(Text found, Text accepted = {}) const;

  const std::string& where() const { return where_; }
  long line() const { return line_; }                                        // 1-based, where this line begins
  std::size_t line_end() const { return std::size_t(end_ - text_.data()); }  // the offset of this line's end

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  // A backslash before a line end counts as a space.
  bool is_joint(const char* p) const {
    return *p == '\\' && rules_.joins_lines && p + 1 < end_ && (p[1] == '\n' || p[1] == '\r');
  }
  bool is_gap(const char* p) const { return is_space(*p) || is_joint(p); }
  bool ended() const { return p_ == end_ || (*p_ == rules_.comment && rules_.comment != '\0'); }
  void skip_space() {
    while (p_ < end_ && is_gap(p_)) ++p_;
  }
  const char* find_line_end(const char* from);
  void take_line();
  void join_lines();
  double odd_number(const Words& what);

  std::string_view text_;
  std::string where_;
  TextRules rules_;
  const char *p_, *end_, *next_;  // in this line; its end; the next line
  const char *lf_, *cr_;          // the next LF and CR, each found once, so that CR-only files take linear time
  long line_ = 0, next_line_ = 1;
};

// A word of a file as it can stand in a message or a name: bytes that are not UTF-8, and control characters, are
// written as \xNN.
std::string readable(std::string_view bytes);

// The same cut to 40 bytes, in quotation marks.
Text in_quotes(std::string_view word);

// The words with {0}, {1}, ... replaced by the values.
Text phrase(const Words& words, std::initializer_list<Text> values);
inline Text text_of(std::integral auto n) { return {std::to_string(n), std::to_string(n)}; }

}  // namespace cg
