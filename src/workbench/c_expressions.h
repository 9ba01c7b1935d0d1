// The place in the tokens, and expressions from there on (ISO/IEC 9899:1990, 6.3).
#pragma once
#include <algorithm>
#include <set>

#include "workbench/c_syntax.h"

namespace cg {

// Thrown where the tokens are not C, or not the part of it that is known; caught where a statement began.
struct CSyntaxError {
  long line;
  Text text;
};

class CCursor {
 public:
  explicit CCursor(const std::vector<CToken>& tokens) : tokens_(tokens) {}

  const CToken& peek(std::size_t ahead = 0) const { return tokens_[std::min(i_ + ahead, tokens_.size() - 1)]; }
  bool at(std::string_view s, std::size_t ahead = 0) const { return peek(ahead).is(s); }
  bool at_end() const { return peek().kind == CToken::end; }
  // The line of the token before.
  long last_line() const { return tokens_[i_ > 0 ? i_ - 1 : 0].line; }
  const CToken& take() {
    const CToken& t = peek();
    if (i_ + 1 < tokens_.size()) ++i_;
    return t;
  }
  bool accept(std::string_view s) { return at(s) && (take(), true); }
  void expect(std::string_view s);
  [[noreturn]] void fail() const;
  std::size_t place() const { return i_; }
  void go_to(std::size_t place) { i_ = place; }

  // How deep the tokens may nest: the tree is walked by recursion.
  static constexpr int deepest = 200;
  struct Nesting {
    explicit Nesting(CCursor& cursor);
    ~Nesting() { --cursor.depth; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    CCursor& cursor;
  };
  int depth = 0;

  std::set<std::string_view> types;  // names that a typedef or a struct made

 private:
  const std::vector<CToken>& tokens_;
  std::size_t i_ = 0;
};

// A type's first word, "const" and "static" included.
bool begins_type(const CCursor& cursor, std::size_t ahead = 0);
// Of a type's words, whether its values are whole numbers, or no number at all (struct, FILE).
bool is_integer_type(std::string_view word);
bool is_real_type(std::string_view word);

CExpression parse_expression(CCursor& cursor);   // with commas
CExpression parse_assignment(CCursor& cursor);   // up to a comma
CExpression parse_initializer(CCursor& cursor);  // or { ... }

}  // namespace cg
