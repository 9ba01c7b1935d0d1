// Declarations, statements and functions of a C program (ISO/IEC 9899:1990, 6.5 to 6.7). What is wrong costs the
// statement that it stands in, not the program.
#include <map>

#include "scene/text_scanner.h"
#include "workbench/c_expressions.h"

namespace cg {

namespace {

constexpr std::size_t most_items = 1'000'000;

class Parser {
 public:
  Parser(const CTokens& tokens, Complaints& complaints) : c_(tokens.tokens), complaints_(complaints) {
    program_.last_line = tokens.tokens.back().line;
  }

  CProgram run() {
    while (!c_.at_end()) guarded(program_.top, [&] { top_level(); });
    return std::move(program_);
  }

 private:
  // Runs `parse`; after a mistake what was begun is left out, up to where the next statement may begin.
  template <class Parse>
  void guarded(std::vector<CStatement>& list, Parse parse) {
    const std::size_t start = c_.place(), length = list.size();
    const int depth = c_.depth;
    try {
      parse();
    } catch (const CSyntaxError& e) {
      complaints_.add(e.line, e.text);
      list.resize(length);
      c_.depth = depth;
      recover(start);
    }
  }

  // Behind the semicolon or the block in which the mistake is: braces are counted from where the statement began.
  void recover(std::size_t start) {
    const std::size_t mistake = c_.place();
    c_.go_to(start);
    int level = 0;
    for (bool first = true; !c_.at_end(); first = false) {
      if (c_.at("}") && level == 0) {
        if (first) c_.take();  // a brace too many: something must be taken
        return;
      }
      const bool past = c_.place() >= mistake;
      const CToken& t = c_.take();
      level += t.is("{") - t.is("}");
      if (past && level == 0 && (t.is(";") || t.is("}"))) return;
    }
  }

  // Where the next line goes on with something else, the semicolon was forgotten: it is told, and the statement counts.
  void end_statement() {
    if (c_.accept(";")) return;
    if (c_.peek().line == c_.last_line() && !c_.at("}")) c_.fail();
    complaints_.add(c_.last_line(), {"a semicolon is missing at the end of the line", "行末にセミコロンがない"});
  }

  // ---- declarations ----

  struct Type {
    bool integer = false, known = true, is_static = false, is_extern = false, is_typedef = false;
  };

  // Two names, or a name and a *: the first must be a type that we do not know.
  bool at_declaration() const {
    if (begins_type(c_)) return true;
    if (c_.peek().kind != CToken::name || c_.at("return") || c_.at("else") || c_.at("goto") || c_.at("case"))
      return false;
    std::size_t k = 1;
    while (c_.at("*", k)) ++k;
    if (c_.peek(k).kind != CToken::name) return false;
    return k == 1 || c_.at(";", k + 1) || c_.at("=", k + 1) || c_.at(",", k + 1) || c_.at("[", k + 1);
  }

  Type type() {
    Type out;
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
  void compound(bool is_enum) {
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

  void enumerators(long line) {
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
  CDeclaration declarator(const Type& type) {
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
  CDeclaration function_pointer(CDeclaration d) {
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

  void declarators(const Type& type, CDeclaration first, CStatement& out) {
    for (CDeclaration d = std::move(first);; d = declarator(type)) {
      if (type.is_typedef) {
        c_.types.insert(d.name);
        Type named = type;
        named.known = named.known && d.lengths.empty() && !d.pointer;
        typedefs_[d.name] = named;
      } else if (c_.at("(")) {
        skip_parentheses();  // a function is announced
        d.name = {};
      } else if (c_.accept("=")) {
        d.initial.push_back(parse_initializer(c_));
      }
      if (!d.name.empty() && !type.is_typedef) out.declarations.push_back(std::move(d));
      if (!c_.accept(",")) break;
    }
    end_statement();
  }

  void skip_parentheses() {
    int level = 0;
    do {
      if (c_.at_end()) c_.fail();
      const CToken& t = c_.take();
      level += t.is("(") - t.is(")");
    } while (level > 0);
  }

  CStatement declaration() {
    CStatement out{CStatement::declaration, c_.peek().line, {}, {}, {}};
    const Type t = type();
    if (c_.accept(";")) return out;
    declarators(t, declarator(t), out);
    return out;
  }

  // Enumerations go before the statement in which they were written.
  void put(std::vector<CStatement>& list, CStatement statement) {
    for (CStatement& e : enums_) list.push_back(std::move(e));
    enums_.clear();
    if (++items_ > most_items) throw CSyntaxError{statement.line, {"the program is too long", "プログラムが長すぎる"}};
    list.push_back(std::move(statement));
  }

  // ---- the outermost level ----

  bool at_keyword() const { return c_.at("if") || c_.at("for") || c_.at("while") || c_.at("switch"); }

  void top_level() {
    if (c_.accept(";")) return;
    if (c_.at("using")) return skip_line();
    const bool bare =
        c_.peek().kind == CToken::name && c_.at("(", 1) && !at_keyword() && body_follows();  // main() { ... }
    if (!bare && !at_declaration()) return put(program_.top, statement());
    const Type t = bare ? Type{true, true, false, false, false} : type();
    if (c_.accept(";")) return put(program_.top, {});
    CDeclaration first = declarator(t);
    if (c_.at("(") && body_follows(0)) return function(first);
    CStatement out{CStatement::declaration, first.line, {}, {}, {}};
    declarators(t, std::move(first), out);
    put(program_.top, std::move(out));
  }

  // Whether a { stands behind the parentheses, which are those of parameters and so are short.
  bool body_follows(std::size_t k = 1) const {
    constexpr std::size_t longest = 500;
    int level = 0;
    do {
      if (c_.peek(k).kind == CToken::end || k > longest) return false;
      level += c_.at("(", k) - c_.at(")", k);
      ++k;
    } while (level > 0);
    return c_.at("{", k);
  }

  // using namespace std;
  void skip_line() {
    while (!c_.at_end() && !c_.accept(";")) c_.take();
  }

  void function(const CDeclaration& head) {
    CRoutine f;
    f.line = head.line, f.name = head.name;
    c_.expect("(");
    while (!c_.at(")")) {
      if (c_.at("void") && c_.at(")", 1)) {
        c_.take();
      } else {
        const Type t = type();
        if (c_.at(",") || c_.at(")")) {
          f.parameters.push_back({});
        } else {
          f.parameters.push_back(declarator(t));
          f.parameters.back().is_parameter = true;
        }
      }
      if (!c_.accept(",")) break;
    }
    c_.expect(")");
    f.body = block();
    program_.routines.push_back(std::move(f));
  }

  // ---- statements ----

  CStatement block() {
    const CCursor::Nesting nesting(c_);
    CStatement out{CStatement::block, c_.peek().line, {}, {}, {}};
    c_.expect("{");
    while (!c_.at("}")) {
      if (c_.at_end()) c_.fail();
      guarded(out.body, [&] { put(out.body, statement()); });
    }
    c_.take();
    return out;
  }

  CStatement statement() {
    const CCursor::Nesting nesting(c_);
    CStatement out;
    out.line = c_.peek().line;
    if (c_.at("{")) return block();
    if (c_.accept(";")) return out;
    if (c_.at("if")) return branch();
    if (c_.at("for")) return for_loop();
    if (c_.at("while")) return while_loop();
    if (c_.at("do")) return do_loop();
    if (c_.at("switch")) {
      out.kind = CStatement::choice;
      c_.take();
      out.expressions.push_back(in_parentheses());
      out.body.push_back(statement());
      return out;
    }
    if (c_.at("case") || (c_.at("default") && c_.at(":", 1))) return label();
    if (simple(out)) return out;
    if (at_declaration()) return declaration();
    out.kind = CStatement::expression;
    out.expressions.push_back(parse_expression(c_));
    end_statement();
    return out;
  }

  CExpression in_parentheses() {
    c_.expect("(");
    CExpression e = parse_expression(c_);
    c_.expect(")");
    return e;
  }

  bool simple(CStatement& out) {
    const std::string_view word = c_.peek().spelling;
    if (word == "break" || word == "continue") {
      out.kind = word == "break" ? CStatement::break_ : CStatement::continue_;
    } else if (word == "return") {
      out.kind = CStatement::return_;
    } else {
      return false;
    }
    c_.take();
    if (out.kind == CStatement::return_ && !c_.at(";")) out.expressions.push_back(parse_expression(c_));
    end_statement();
    return true;
  }

  CStatement label() {
    CStatement out;
    out.kind = CStatement::label, out.line = c_.peek().line;
    if (c_.take().is("case")) out.expressions.push_back(parse_expression(c_));
    c_.expect(":");
    return out;
  }

  CStatement branch() {
    CStatement out;
    out.kind = CStatement::branch, out.line = c_.take().line;
    out.expressions.push_back(in_parentheses());
    out.body.push_back(statement());
    if (c_.accept("else")) out.body.push_back(statement());
    return out;
  }

  CStatement for_loop() {
    CStatement out, first;
    out.kind = CStatement::loop, out.line = c_.take().line;
    CExpression none;
    none.kind = CExpression::list, none.line = out.line;
    out.expressions.assign(3, none);
    c_.expect("(");
    if (at_declaration()) {
      first = declaration();
    } else {
      if (!c_.at(";")) out.expressions[0] = parse_expression(c_);
      end_statement();
    }
    if (!c_.at(";")) out.expressions[1] = parse_expression(c_);
    end_statement();
    if (!c_.at(")")) out.expressions[2] = parse_expression(c_);
    c_.expect(")");
    out.body.push_back(statement());
    out.body.push_back(std::move(first));
    return out;
  }

  CStatement while_loop() {
    CStatement out;
    out.kind = CStatement::loop, out.line = c_.take().line;
    CExpression none;
    none.kind = CExpression::list, none.line = out.line;
    out.expressions.assign(3, none);
    out.expressions[1] = in_parentheses();
    out.body.push_back(statement());
    return out;
  }

  CStatement do_loop() {
    CStatement out;
    out.kind = CStatement::do_loop, out.line = c_.take().line;
    out.body.push_back(statement());
    c_.expect("while");
    out.expressions.push_back(in_parentheses());
    end_statement();
    return out;
  }

  CCursor c_;
  Complaints& complaints_;
  CProgram program_;
  std::map<std::string_view, Type> typedefs_;
  std::vector<CStatement> enums_;
  std::size_t items_ = 0;
};

}  // namespace

CProgram parse_c(const CTokens& tokens, Complaints& complaints) { return Parser(tokens, complaints).run(); }

}  // namespace cg
