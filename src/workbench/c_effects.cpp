// What a part of a C program may change, read off its syntax: for parts that are not followed.
#include "workbench/c_run.h"

namespace cg {

namespace {

class Effects {
 public:
  Effects(const CProgram& program, const CHost& host) : program_(program), host_(host) {}

  void statement(const CStatement& s) {
    for (const CExpression& e : s.expressions) expression(e);
    for (const CDeclaration& d : s.declarations) {
      if (!d.is_static && !d.is_extern) own_.insert(d.name);
      for (const CExpression& e : d.initial) expression(e);
    }
    for (const CStatement& inner : s.body) statement(inner);
  }

  void function(const CRoutine& f) {
    if (!visited_.insert(f.name).second) return;
    std::set<std::string_view> own, assigned;
    std::swap(own, own_);
    std::swap(assigned, out_.assigned);
    for (const CDeclaration& d : f.parameters) own_.insert(d.name);
    statement(f.body);
    take_away_own();
    out_.assigned.merge(assigned);
    std::swap(own, own_);
  }

  CEffects take() {
    take_away_own();
    return std::move(out_);
  }

 private:
  void take_away_own() {
    for (const std::string_view name : own_) out_.assigned.erase(name);
  }

  // The variable that an expression is a part of: a[i][0], *a, (a), a.x.
  void assigned(const CExpression& e) {
    if (e.kind == CExpression::variable) out_.assigned.insert(e.name);
    if (!e.operands.empty() && e.kind != CExpression::call) assigned(e.operands[0]);
    if (e.kind == CExpression::binary && e.operands.size() == 2) assigned(e.operands[1]);  // *(a + i)
  }

  void expression(const CExpression& e) {
    const bool steps = e.op == "++" || e.op == "--";
    if (e.kind == CExpression::assign || ((e.kind == CExpression::unary || e.kind == CExpression::postfix) && steps))
      assigned(e.operands[0]);
    if (e.kind == CExpression::call) call(e);
    for (const CExpression& operand : e.operands) expression(operand);
  }

  void call(const CExpression& e) {
    const std::string_view name = e.operands[0].name;
    const bool reads = host_.only_reads(name);
    for (std::size_t i = 1; i < e.operands.size() && !reads; ++i) {
      const CExpression& a = e.operands[i];
      if (a.kind == CExpression::variable || (a.kind == CExpression::unary && a.op == "&") ||
          a.kind == CExpression::index)
        pointed(a);
    }
    for (const CRoutine& f : program_.routines)
      if (f.name == name) return function(f);
    out_.calls = out_.calls || name.starts_with("gl");
  }

  // An argument through which a function may change something: an address, or an array's name.
  void pointed(const CExpression& a) {
    if (a.kind == CExpression::variable && !is_array(a.name)) return;
    if (a.kind == CExpression::index && !(a.operands[0].kind == CExpression::variable && is_table(a.operands[0].name)))
      return;
    assigned(a);
  }

  const CDeclaration* global(std::string_view name) const {
    for (const CStatement& s : program_.top)
      for (const CDeclaration& d : s.declarations)
        if (d.name == name) return &d;
    return nullptr;
  }
  bool is_array(std::string_view name) const {
    const CDeclaration* d = global(name);
    return !d || d->pointer || !d->lengths.empty();
  }
  bool is_table(std::string_view name) const {
    const CDeclaration* d = global(name);
    return !d || d->lengths.size() + d->pointer > 1;
  }

  const CProgram& program_;
  const CHost& host_;
  CEffects out_;
  std::set<std::string_view> own_, visited_;
};

}  // namespace

CEffects effects_of(const CStatement& statement, const CProgram& program, const CHost& host) {
  Effects effects(program, host);
  effects.statement(statement);
  return effects.take();
}

CEffects effects_of(const CRoutine& function, const CProgram& program, const CHost& host) {
  Effects effects(program, host);
  effects.function(function);
  return effects.take();
}

}  // namespace cg
