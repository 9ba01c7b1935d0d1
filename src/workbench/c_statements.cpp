// Statements, functions and what they declare of a C program (ISO/IEC 9899:1990, 6.5 to 6.7). What is wrong costs the
// statement that it stands in, not the program.
#include "scene/text_scanner.h"
#include "workbench/c_declarations.h"

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

  void declarators(const CType& type, CDeclaration first, CStatement& out) {
    for (CDeclaration d = std::move(first);; d = d_.declarator(type)) {
      if (type.is_typedef) {
        d_.name_type(d, type);
      } else if (c_.at("(")) {
        d_.skip_parentheses();  // a function is announced
        d.name = {};
      } else if (c_.accept("=")) {
        d.initial.push_back(parse_initializer(c_));
      }
      if (!d.name.empty() && !type.is_typedef) out.declarations.push_back(std::move(d));
      if (!c_.accept(",")) break;
    }
    end_statement();
  }

  CStatement declaration() {
    CStatement out{CStatement::declaration, c_.peek().line, {}, {}, {}};
    const CType t = d_.type();
    if (c_.accept(";")) return out;
    declarators(t, d_.declarator(t), out);
    return out;
  }

  // Enumerations go before the statement in which they were written.
  void put(std::vector<CStatement>& list, CStatement statement) {
    for (CStatement& e : d_.enumerations()) list.push_back(std::move(e));
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
    if (!bare && !d_.at_declaration()) return put(program_.top, statement());
    const CType t = bare ? CType{true, true, false, false, false} : d_.type();
    if (c_.accept(";")) return put(program_.top, {});
    CDeclaration first = d_.declarator(t);
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
        const CType t = d_.type();
        if (c_.at(",") || c_.at(")")) {
          f.parameters.push_back({});
        } else {
          f.parameters.push_back(d_.declarator(t));
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
    if (d_.at_declaration()) return declaration();
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
    if (d_.at_declaration()) {
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
  CDeclarations d_{c_};
  Complaints& complaints_;
  CProgram program_;
  std::size_t items_ = 0;
};

}  // namespace

CProgram parse_c(const CTokens& tokens, Complaints& complaints) { return Parser(tokens, complaints).run(); }

}  // namespace cg
