#include "workbench/c_declarations.h"

namespace cg {

bool CDeclarations::at_declaration() const {
  if (begins_type(c_)) return true;
  if (c_.peek().kind != CToken::name || c_.at("return") || c_.at("else") || c_.at("goto") || c_.at("case"))
    return false;
  std::size_t k = 1;
  while (c_.at("*", k)) ++k;
  if (c_.peek(k).kind != CToken::name) return false;
  return k == 1 || c_.at(";", k + 1) || c_.at("=", k + 1) || c_.at(",", k + 1) || c_.at("[", k + 1);
}

CType CDeclarations::type() {
  CType out;
  bool integer = false, real = false, other = false, named = false;
  while (c_.peek().kind == CToken::name) {
    const std::string_view word = c_.peek().spelling;
    if (word == "struct" || word == "union" || word == "enum") {
      compound(word == "enum");
      (word == "enum" ? integer : other) = true, named = true;
      continue;
    }
    if (!begins_type(c_) && named) break;
    c_.take();
    out.is_static = out.is_static || word == "static", out.is_extern = out.is_extern || word == "extern";
    out.is_typedef = out.is_typedef || word == "typedef";
    if (word == "const" || word == "static" || word == "extern" || word == "register" || word == "volatile" ||
        word == "inline" || word == "auto" || word == "typedef")
      continue;
    named = true;
    if (const auto known = typedefs_.find(word); known != typedefs_.end()) {
      (known->second.integer ? integer : known->second.known ? real : other) = true;
      continue;
    }
    integer = integer || is_integer_type(word), real = real || is_real_type(word);
    other = other || !(is_integer_type(word) || is_real_type(word));
  }
  out.integer = integer && !real;
  out.known = !other;
  return out;
}

// struct name { ... }: its members are not kept. enum { A, B = 3 }: constants.
void CDeclarations::compound(bool is_enum) {
  c_.take();
  if (c_.peek().kind == CToken::name) c_.take();
  if (!c_.at("{")) return;
  const long line = c_.take().line;
  if (is_enum) return enumerators(line);
  for (int level = 1; level > 0;) {
    if (c_.at_end()) c_.fail();
    const CToken& t = c_.take();
    level += t.is("{") - t.is("}");
  }
}

void CDeclarations::enumerators(long line) {
  CStatement statement{CStatement::declaration, line, {}, {}, {}};
  std::string_view before;
  while (!c_.at("}")) {
    if (c_.peek().kind != CToken::name) c_.fail();
    CDeclaration d;
    d.line = line, d.name = c_.take().spelling, d.integer = true;
    CExpression value;
    value.line = line, value.integer = true;
    if (c_.accept("=")) {
      value = parse_assignment(c_);
    } else if (!before.empty()) {
      CExpression last, one = value;
      last.kind = CExpression::variable, last.name = before, last.line = line;
      one.value = 1;
      value.kind = CExpression::binary, value.op = "+", value.height = 2;
      value.operands = {std::move(last), std::move(one)};
    }
    before = d.name;
    d.initial.push_back(std::move(value));
    statement.declarations.push_back(std::move(d));
    if (!c_.accept(",")) break;
  }
  c_.expect("}");
  enums_.push_back(std::move(statement));
}

// * name [ n ] ..., of the type.
CDeclaration CDeclarations::declarator(const CType& type) {
  CDeclaration d;
  d.integer = type.integer, d.known = type.known, d.is_static = type.is_static, d.is_extern = type.is_extern;
  while (c_.at("*") || c_.at("const")) d.pointer = c_.take().is("*") || d.pointer;
  d.line = c_.peek().line;
  if (c_.at("(")) return function_pointer(d);
  if (c_.peek().kind != CToken::name) c_.fail();
  d.name = c_.take().spelling;
  while (c_.accept("[")) {
    CExpression none;
    none.kind = CExpression::list;
    d.lengths.push_back(c_.at("]") ? none : parse_assignment(c_));
    c_.expect("]");
  }
  return d;
}

// void (*f)(int): a name without a value.
CDeclaration CDeclarations::function_pointer(CDeclaration d) {
  d.known = false;
  for (int part = 0; part < 2 && c_.at("("); ++part) {
    int level = 0;
    do {
      if (c_.at_end()) c_.fail();
      const CToken& t = c_.take();
      level += t.is("(") - t.is(")");
      if (part == 0 && t.kind == CToken::name) d.name = t.spelling;
    } while (level > 0);
  }
  return d;
}

void CDeclarations::name_type(const CDeclaration& d, CType type) {
  c_.types.insert(d.name);
  type.known = type.known && d.lengths.empty() && !d.pointer;
  typedefs_[d.name] = type;
}

void CDeclarations::skip_parentheses() {
  int level = 0;
  do {
    if (c_.at_end()) c_.fail();
    const CToken& t = c_.take();
    level += t.is("(") - t.is(")");
  } while (level > 0);
}

}  // namespace cg
