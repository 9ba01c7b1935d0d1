#include "workbench/c_tokens.h"

#include "scene/text_scanner.h"
#include "workbench/c_preprocessor.h"

namespace cg {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

constexpr std::string_view operators[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>", "<=", ">=", "==", "!=",
                                          "&&",  "||",  "+=",  "-=", "*=", "/=", "%=", "&=", "|=", "^=", "##", "::"};
constexpr std::string_view single = "()[]{}<>;:,.?=+-*/%&|^~!#";

class Lexer {
 public:
  Lexer(std::string_view source, Complaints& complaints) : s_(source), complaints_(complaints) {
    if (s_.starts_with("\xef\xbb\xbf")) i_ = 3;
  }

  CLines run() {
    while (i_ < s_.size()) step();
    end_line();
    return std::move(out_);
  }

 private:
  char at(std::size_t k) const { return k < s_.size() ? s_[k] : '\0'; }

  void step() {
    const char c = s_[i_];
    if (c == '\n') {
      end_line();
      ++i_, ++line_;
    } else if (is_space(c)) {
      // A lone CR ends a line too.
      if (c == '\r' && at(i_ + 1) != '\n') end_line(), ++line_;
      ++i_;
    } else if (c == '\\' && joins(i_)) {
      skip_joint();
    } else if (c == '/' && at(i_ + 1) == '/') {
      line_comment();
    } else if (c == '/' && at(i_ + 1) == '*') {
      block_comment();
    } else if (c == '"' || c == '\'') {
      quoted(c);
    } else if (is_letter(c)) {
      take(CToken::name, [&](char k) { return is_letter(k) || is_digit(k); });
    } else if (is_digit(c) || (c == '.' && is_digit(at(i_ + 1)))) {
      number();
    } else {
      punctuation();
    }
  }

  // A backslash before a line's end.
  bool joins(std::size_t k) const { return at(k + 1) == '\n' || (at(k + 1) == '\r' && at(k + 2) == '\n'); }
  void skip_joint() { i_ += at(i_ + 1) == '\r' ? 3 : 2, ++line_; }

  void push(CToken::Kind kind, std::size_t begin, long line) {
    out_.tokens.push_back({kind, s_.substr(begin, i_ - begin), line});
  }
  template <class Accepts>
  void take(CToken::Kind kind, Accepts accepts) {
    const std::size_t begin = i_;
    while (i_ < s_.size() && accepts(s_[i_])) ++i_;
    push(kind, begin, line_);
  }

  // A pp-number: 1.0e+5f, 0x1F, 10u.
  void number() {
    const std::size_t begin = i_;
    while (i_ < s_.size()) {
      const char c = s_[i_], before = i_ > begin ? s_[i_ - 1] : '\0';
      const bool sign = (c == '+' || c == '-') && (before == 'e' || before == 'E') &&
                        !(s_[begin] == '0' && (at(begin + 1) == 'x' || at(begin + 1) == 'X'));
      if (!(is_letter(c) || is_digit(c) || c == '.' || sign)) break;
      ++i_;
    }
    push(CToken::number, begin, line_);
  }

  // Only a backslash that is a character of its own goes on: the second byte of many Shift_JIS characters is one.
  void line_comment() {
    const std::size_t begin = i_ + 2;
    const long line = line_;
    while (i_ < s_.size() && s_[i_] != '\n' && !(s_[i_] == '\r' && at(i_ + 1) != '\n')) {
      const bool joint = s_[i_] == '\\' && joins(i_) && std::uint8_t(s_[i_ - 1]) < 0x80;
      joint ? skip_joint() : void(++i_);
    }
    comment(s_.substr(begin, i_ - begin), line);
  }

  void block_comment() {
    const std::size_t begin = i_ + 2, end = s_.find("*/", begin);
    const long line = line_;
    if (end == s_.npos) complaints_.add(line, {"this comment has no end", "コメントが閉じていない"});
    const std::string_view text = s_.substr(begin, end == s_.npos ? end : end - begin);
    for (const char c : text) line_ += c == '\n';
    i_ = end == s_.npos ? s_.size() : end + 2;
    comment(text, line);
  }

  void comment(std::string_view text, long line) {
    while (!text.empty() && (is_space(text.front()) || text.front() == '\n')) text.remove_prefix(1);
    while (!text.empty() && (is_space(text.back()) || text.back() == '\n')) text.remove_suffix(1);
    out_.comments.push_back({line, text});
  }

  // A string or a character; it may not go over the line's end. Behind a lead byte of Shift_JIS a backslash is none.
  void quoted(char quote) {
    const std::size_t begin = i_++;
    while (i_ < s_.size() && s_[i_] != quote && s_[i_] != '\n') {
      const auto c = std::uint8_t(s_[i_]);
      const bool lead = (c >= 0x81 && c <= 0x9f) || (c >= 0xe0 && c <= 0xfc);
      i_ += (c == '\\' && at(i_ + 1) != '\n') || (lead && at(i_ + 1) == '\\') ? 2 : 1;
    }
    if (i_ > s_.size()) i_ = s_.size();
    if (at(i_) == quote && i_ < s_.size())
      ++i_;
    else
      complaints_.add(line_, {"this text has no closing mark", "引用符が閉じていない"});
    push(CToken::text, begin, line_);
  }

  void punctuation() {
    for (const std::string_view op : operators)
      if (s_.substr(i_).starts_with(op)) {
        i_ += op.size();
        return push(CToken::punctuation, i_ - op.size(), line_);
      }
    if (single.find(s_[i_]) != single.npos) {
      ++i_;
      return push(CToken::punctuation, i_ - 1, line_);
    }
    odd_bytes();
  }

  // Characters that C does not have; a full-width space, which a Japanese keyboard leaves behind, is told by name.
  void odd_bytes() {
    if (s_.substr(i_).starts_with("\xe3\x80\x80")) {
      complaints_.add(line_, {"a full-width space stands in the program: compilers refuse it",
                              "全角スペースがある：コンパイラはエラーにする"});
      i_ += 3;
      return;
    }
    const std::size_t begin = i_;
    while (i_ < s_.size() && (std::uint8_t(s_[i_]) >= 0x80 || (i_ == begin && s_[i_] != '\n'))) ++i_;
    complaints_.add(line_, phrase({"{0} is not C: skipped", "{0}は C の文字ではないので読み飛ばす"},
                                  {in_quotes(s_.substr(begin, i_ - begin))}));
  }

  void end_line() {
    if (out_.tokens.size() > out_.starts.back()) out_.starts.push_back(out_.tokens.size());
  }

  std::string_view s_;
  std::size_t i_ = 0;
  long line_ = 1;
  Complaints& complaints_;
  CLines out_;
};

}  // namespace

CTokens c_tokens(std::string_view source, Complaints& complaints) {
  CLines lines = Lexer(source, complaints).run();
  CTokens out;
  out.tokens = preprocess(lines, complaints);
  out.comments = std::move(lines.comments);
  return out;
}

}  // namespace cg
