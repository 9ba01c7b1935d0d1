#include "workbench/c_expressions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "scene/text_scanner.h"

namespace cg {

namespace {

constexpr std::string_view integer_types[] = {"char",    "short",   "int",       "long",       "signed",  "unsigned",
                                              "GLint",   "GLuint",  "GLubyte",   "GLbyte",     "GLshort", "GLushort",
                                              "GLsizei", "GLenum",  "GLboolean", "GLbitfield", "size_t",  "bool",
                                              "BOOL",    "uint8_t", "int32_t",   "uint32_t",   "GLchar"};
constexpr std::string_view real_types[] = {"float", "double", "GLfloat", "GLdouble", "GLclampf", "GLclampd"};
constexpr std::string_view other_types[] = {"void", "const",  "static", "extern", "register", "volatile", "inline",
                                            "auto", "struct", "union",  "enum",   "typedef",  "GLvoid",   "FILE"};

bool contains(std::span<const std::string_view> list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

constexpr std::array<std::array<std::string_view, 4>, 10> levels{{{"||"},
                                                                  {"&&"},
                                                                  {"|"},
                                                                  {"^"},
                                                                  {"&"},
                                                                  {"==", "!="},
                                                                  {"<", ">", "<=", ">="},
                                                                  {"<<", ">>"},
                                                                  {"+", "-"},
                                                                  {"*", "/", "%"}}};

constexpr std::string_view assignments[] = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};

CExpression node(CExpression::Kind kind, const CToken& op, std::vector<CExpression> operands, long line) {
  CExpression e;
  e.kind = kind, e.line = line, e.op = op.spelling;
  for (const CExpression& operand : operands) e.height = std::max(e.height, operand.height + 1);
  if (e.height > CCursor::deepest)
    throw CSyntaxError{line, {"this expression is too long to be read", "式が長すぎて読めない"}};
  e.operands = std::move(operands);
  return e;
}

template <class... E>
CExpression node(CExpression::Kind kind, const CToken& op, E... operands) {
  std::vector<CExpression> list;
  (list.push_back(std::move(operands)), ...);
  const long line = list.front().line;
  return node(kind, op, std::move(list), line);
}

// 1, 1.0f, 0x1F, 010, 10u: the value of a pp-number.
CExpression number_of(const CToken& t) {
  CExpression e;
  e.kind = CExpression::number, e.line = t.line;
  std::string_view s = t.spelling;
  const auto refuse = [&] {
    throw CSyntaxError{t.line, phrase({"{0} is not a number", "{0}は数ではない"}, {in_quotes(t.spelling)})};
  };
  const bool hex = s.starts_with("0x") || s.starts_with("0X");
  e.integer = hex || s.find_first_of(".eE") == s.npos;
  const std::string_view suffixes = e.integer ? "uUlL" : "fFlL";
  if (e.integer && !hex && (s.ends_with('f') || s.ends_with('F'))) refuse();  // 1f is no C
  while (!s.empty() && suffixes.find(s.back()) != s.npos) s.remove_suffix(1);
  const char* const end = s.data() + s.size();
  std::from_chars_result read{};
  if (e.integer) {
    const bool octal = !hex && s.size() > 1 && s[0] == '0';
    unsigned long long v = 0;
    read = std::from_chars(s.data() + (hex ? 2 : 0), end, v, hex ? 16 : octal ? 8 : 10);
    e.value = double(v);
    if (v > 0xffffffffu) refuse();
  } else {
    read = std::from_chars(s.data(), end, e.value);
  }
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(e.value)) refuse();
  return e;
}

CExpression parse_unary(CCursor& c);

CExpression parse_primary(CCursor& c) {
  const CToken& t = c.peek();
  CExpression e;
  e.line = t.line;
  if (t.kind == CToken::number) return number_of(c.take());
  if (t.kind == CToken::text) {
    const bool character = t.spelling.front() == '\'' && t.spelling.size() == 3;
    e.kind = character ? CExpression::number : CExpression::text;
    e.value = character ? double(static_cast<unsigned char>(t.spelling[1])) : 0, e.integer = character;
    while (c.peek().kind == CToken::text) c.take();  // adjacent strings are one
    return e;
  }
  if (t.is("std") && c.at("::", 1)) c.take(), c.take();
  if (c.peek().kind == CToken::name && !c.at("sizeof")) {
    e.kind = CExpression::variable, e.name = c.take().spelling;
    return e;
  }
  if (!c.accept("(")) c.fail();
  e = parse_expression(c);
  c.expect(")");
  return e;
}

CExpression parse_postfix(CCursor& c) {
  CExpression e = parse_primary(c);
  while (true) {
    const CToken& t = c.peek();
    if (t.is("[")) {
      c.take();
      CExpression at = parse_expression(c);
      c.expect("]");
      e = node(CExpression::index, t, std::move(e), std::move(at));
    } else if (t.is("(")) {
      c.take();
      std::vector<CExpression> list;
      const long line = e.line;
      list.push_back(std::move(e));
      while (!c.at(")")) {
        list.push_back(parse_assignment(c));
        if (!c.accept(",")) break;
      }
      c.expect(")");
      e = node(CExpression::call, t, std::move(list), line);
    } else if (t.is(".") || t.is("->")) {
      c.take();
      if (c.peek().kind != CToken::name) c.fail();
      e = node(CExpression::member, t, std::move(e));
      e.name = c.take().spelling;
    } else if (t.is("++") || t.is("--")) {
      c.take();
      e = node(CExpression::postfix, t, std::move(e));
    } else {
      return e;
    }
  }
}

// ( type ) and what it is put before.
CExpression parse_cast(CCursor& c) {
  const CToken& t = c.take();
  bool integer = false, real = false, pointer = false;
  while (!c.at(")")) {
    const CToken& word = c.peek();
    if (word.is("[")) {  // of a compound literal
      c.take();
      if (!c.at("]")) parse_expression(c);
      c.expect("]");
      continue;
    }
    if (word.kind != CToken::name && !word.is("*")) c.fail();
    integer = integer || is_integer_type(word.spelling), real = real || is_real_type(word.spelling);
    pointer = pointer || word.is("*");
    c.take();
  }
  c.expect(")");
  CExpression e = node(CExpression::cast, t, c.at("{") ? parse_initializer(c) : parse_unary(c));
  e.integer = integer && !real && !pointer;
  return e;
}

CExpression parse_sizeof(CCursor& c) {
  CExpression e = node(CExpression::unary, c.take(), std::vector<CExpression>{}, c.peek().line);
  if (c.at("(") && begins_type(c, 1)) {
    while (!c.accept(")"))
      if (c.at_end() || c.at(";"))
        c.fail();
      else
        c.take();
  } else {
    e.operands.push_back(parse_unary(c));
    e.height = e.operands[0].height + 1;
  }
  return e;
}

CExpression parse_unary(CCursor& c) {
  const CCursor::Nesting nesting(c);
  if (c.at("sizeof")) return parse_sizeof(c);
  if (c.at("(") && begins_type(c, 1)) return parse_cast(c);
  for (const std::string_view op : {"+", "-", "!", "~", "*", "&", "++", "--"})
    if (c.at(op)) {
      const CToken& t = c.take();
      return node(CExpression::unary, t, parse_unary(c));
    }
  return parse_postfix(c);
}

CExpression parse_binary(CCursor& c, std::size_t level) {
  if (level == levels.size()) return parse_unary(c);
  CExpression e = parse_binary(c, level + 1);
  while (c.peek().kind == CToken::punctuation && contains(levels[level], c.peek().spelling)) {
    const CToken& t = c.take();
    e = node(CExpression::binary, t, std::move(e), parse_binary(c, level + 1));
  }
  return e;
}

CExpression parse_conditional(CCursor& c) {
  CExpression condition = parse_binary(c, 0);
  if (!c.at("?")) return condition;
  const CCursor::Nesting nesting(c);
  const CToken& t = c.take();
  CExpression yes = parse_expression(c);
  c.expect(":");
  return node(CExpression::conditional, t, std::move(condition), std::move(yes), parse_conditional(c));
}

}  // namespace

void CCursor::expect(std::string_view s) {
  if (!accept(s)) fail();
}

void CCursor::fail() const {
  const CToken& t = peek();
  if (t.kind == CToken::end)
    throw CSyntaxError{t.line,
                       {"the program ends in the middle: a brace or a semicolon is missing",
                        "プログラムが途中で終わっている：括弧かセミコロンが足りない"}};
  throw CSyntaxError{t.line,
                     phrase({"{0} is not understood here", "{0}はここでは解釈できない"}, {in_quotes(t.spelling)})};
}

CCursor::Nesting::Nesting(CCursor& c) : cursor(c) {
  if (cursor.depth >= deepest)
    throw CSyntaxError{cursor.peek().line, {"this is nested too deeply to be read", "入れ子が深すぎて読めない"}};
  ++cursor.depth;
}

bool is_integer_type(std::string_view word) { return contains(integer_types, word); }
bool is_real_type(std::string_view word) { return contains(real_types, word); }

bool begins_type(const CCursor& c, std::size_t ahead) {
  const CToken& t = c.peek(ahead);
  return t.kind == CToken::name && (is_integer_type(t.spelling) || is_real_type(t.spelling) ||
                                    contains(other_types, t.spelling) || c.types.contains(t.spelling));
}

CExpression parse_assignment(CCursor& c) {
  const CCursor::Nesting nesting(c);
  CExpression left = parse_conditional(c);
  if (c.peek().kind != CToken::punctuation || !contains(assignments, c.peek().spelling)) return left;
  const CToken& t = c.take();
  return node(CExpression::assign, t, std::move(left), parse_assignment(c));
}

CExpression parse_expression(CCursor& c) {
  CExpression e = parse_assignment(c);
  while (c.at(",")) {
    const CToken& t = c.take();
    e = node(CExpression::binary, t, std::move(e), parse_assignment(c));
  }
  return e;
}

CExpression parse_initializer(CCursor& c) {
  if (!c.at("{")) return parse_assignment(c);
  const CCursor::Nesting nesting(c);
  const CToken& t = c.take();
  std::vector<CExpression> list;
  while (!c.at("}")) {
    list.push_back(parse_initializer(c));
    if (!c.accept(",")) break;
  }
  c.expect("}");
  return node(CExpression::list, t, std::move(list), t.line);
}

}  // namespace cg
