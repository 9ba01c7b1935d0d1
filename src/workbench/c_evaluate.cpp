// Expressions of a C program that is followed (ISO/IEC 9899:1990, 6.3).
#include "scene/text_scanner.h"
#include "workbench/c_run.h"

namespace cg {

CValue CRun::undefined(const CExpression& e) {
  return memory.unknown(phrase({"{0} has no value here", "{0}の値が求められない"}, {in_quotes(e.op)}));
}

CValue CRun::evaluate(const CExpression& e) {
  if (!spend(e.line)) return memory.unknown({"the program was not followed so far", "ここまで追えなかった"});
  switch (e.kind) {
    case CExpression::number:
      return {CValue::known, e.integer, -1, e.value, {}, {}};
    case CExpression::text:
      return memory.unknown({"this is a text", "文字列である"});
    case CExpression::variable:
      return evaluate_name(e);
    case CExpression::unary:
      return evaluate_unary(e);
    case CExpression::postfix:
      return increase(e, e.op == "++" ? 1 : -1, false);
    case CExpression::binary:
      return evaluate_binary(e);
    case CExpression::conditional: {
      const CValue v = evaluate(e.operands[0]);
      if (v.state == CValue::unknown) return v;
      CValue out = evaluate(e.operands[v.number != 0 || v.is_address() ? 1 : 2]);
      if (v.state > out.state) out.state = v.state, out.reason = v.reason;
      return out;
    }
    case CExpression::assign:
      return assign(e);
    case CExpression::index:
      if (const auto place = place_of(e)) return memory.load(*place);
      return evaluate(e.operands[0]).state == CValue::unknown ? evaluate(e.operands[0]) : undefined(e);
    case CExpression::call:
      return evaluate_call(e);
    case CExpression::member:
      return memory.unknown(phrase({"the member {0} of a structure is not read", "構造体のメンバー{0}は読み込めない"},
                                   {in_quotes(e.name)}));
    case CExpression::cast:
      if (e.operands[0].kind == CExpression::list) return evaluate_literal(e);
      return e.integer ? c_converted(evaluate(e.operands[0]), true, undefined(e).reason) : as_real(e.operands[0]);
    case CExpression::list:
      break;
  }
  return undefined(e);
}

// (float)i is a real number; an address stays what it is.
CValue CRun::as_real(const CExpression& e) {
  const CValue v = evaluate(e);
  return v.is_number() ? c_converted(v, false, -1) : v;
}

CValue CRun::evaluate_name(const CExpression& e) {
  if (const int variable = memory.find(e.name); variable >= 0) return memory.load({variable, 0, 0});
  if (function(e.name)) {
    CValue v;
    v.function = e.name;
    return v;
  }
  if (const auto v = host_->constant(e.name)) return *v;
  return memory.unknown(phrase({"{0} is not known", "{0}が分からない"}, {in_quotes(e.name)}));
}

CValue CRun::evaluate_unary(const CExpression& e) {
  if (e.op == "++" || e.op == "--") return increase(e, e.op == "++" ? 1 : -1, true);
  if (e.op == "sizeof") return memory.unknown({"sizeof is not read", "sizeof は読み込めない"});
  if (e.op == "&") {
    CValue v;
    const auto place = place_of(e.operands[0]);
    if (!place) return undefined(e);
    v.address = *place;
    return v;
  }
  if (e.op == "*") {
    const auto place = place_of(e);
    return place ? memory.load(*place) : undefined(e);
  }
  return c_unary(e.op, evaluate(e.operands[0]), undefined(e).reason);
}

CValue CRun::evaluate_binary(const CExpression& e) {
  const CValue a = evaluate(e.operands[0]);
  const bool is_and = e.op == "&&";
  if (is_and || e.op == "||") {
    const bool yes = a.is_address() || a.number != 0;
    if (a.state == CValue::known && yes != is_and) return c_integer(yes);
    const CValue b = evaluate(e.operands[1]);
    if (a.state == CValue::unknown) return a;
    CValue out = b;
    out.integer = true, out.address = {}, out.function = {};
    out.number = is_and ? yes && (b.number != 0 || b.is_address()) : yes || b.number != 0 || b.is_address();
    if (a.state > out.state) out.state = a.state, out.reason = a.reason;
    return out;
  }
  const CValue b = evaluate(e.operands[1]);
  if (e.op == ",") return b;
  const bool plus = e.op == "+", minus = e.op == "-";
  if ((a.is_address() != b.is_address()) && (plus || (minus && a.is_address()))) {
    const CValue &base = a.is_address() ? a : b, &by = a.is_address() ? b : a;
    if (by.state == CValue::unknown) return by;
    return moved(base, (minus ? -1 : 1) * by.number);
  }
  const CValue result = c_binary(e.op, a, b, undefined(e).reason);
  const bool literal = e.operands[0].kind == CExpression::number && e.operands[1].kind == CExpression::number;
  if (e.op == "/" && literal && result.integer && result.number * b.number != a.number)
    complain(e.line, phrase({"{0}/{1} of whole numbers is {2} in C", "整数の割り算{0}/{1}は C では{2}"},
                            {text_of(int(a.number)), text_of(int(b.number)), text_of(int(result.number))}));
  return result;
}

CValue CRun::moved(const CValue& address, double steps) {
  CValue out = address;
  const double offset = double(address.address.offset) + steps * double(memory.stride(address.address));
  if (!(offset >= 0 && offset <= double(CMemory::most_cells)))
    return memory.unknown({"an address is outside its array", "配列の範囲の外を指す"});
  out.address.offset = std::size_t(offset);
  return out;
}

std::optional<CAddress> CRun::place_of(const CExpression& e) {
  if (!spend(e.line)) return std::nullopt;
  if (e.kind == CExpression::variable) {
    const int variable = memory.find(e.name);
    return variable >= 0 ? std::optional(CAddress{variable, 0, 0}) : std::nullopt;
  }
  if (e.kind == CExpression::unary && e.op == "*") {
    const CValue v = evaluate(e.operands[0]);
    return v.is_address() ? std::optional(v.address) : std::nullopt;
  }
  if (e.kind != CExpression::index) return std::nullopt;
  const CValue base = evaluate(e.operands[0]), at = evaluate(e.operands[1]);
  if (!base.is_address() || at.state == CValue::unknown || !at.is_number()) return std::nullopt;
  const CValue element = moved(base, at.number);
  return element.is_address() ? std::optional(element.address) : std::nullopt;
}

// A target that cannot be told makes the whole variable unknown.
void CRun::store(const CExpression& target, const std::optional<CAddress>& at, const CValue& value) {
  if (at && at->variable >= 0) {
    if (CValue* cell = memory.cell(*at)) {
      *cell = value;
      return;
    }
    complain(target.line, phrase({"{0} is written outside its range", "{0}の範囲の外に書き込む"},
                                 {in_quotes(memory.variable(at->variable).name)}));
    return;
  }
  const CExpression* name = &target;
  while (!name->operands.empty()) name = &name->operands[0];
  if (name->kind != CExpression::variable) return;
  if (const int variable = memory.find(name->name); variable >= 0)
    memory.forget(variable,
                  phrase({"it cannot be told which element of {0} changes", "{0}のどの要素が変わるか分からない"},
                         {in_quotes(name->name)}));
}

CValue CRun::assign(const CExpression& e) {
  CValue value = evaluate(e.operands[1]);
  const auto place = place_of(e.operands[0]);
  if (e.op != "=") {
    const CValue before = place ? memory.load(*place) : undefined(e);
    const std::string_view op = e.op.substr(0, e.op.size() - 1);
    const bool steps = before.is_address() && value.is_number() && (op == "+" || op == "-");
    value =
        steps ? moved(before, (op == "-" ? -1 : 1) * value.number) : c_binary(op, before, value, undefined(e).reason);
  }
  if (place) value = c_converted(value, memory.variable(place->variable).integer, undefined(e).reason);
  store(e.operands[0], place, value);
  return value;
}

CValue CRun::increase(const CExpression& e, double by, bool before) {
  const auto place = place_of(e.operands[0]);
  if (!place) {
    store(e.operands[0], place, {});
    return undefined(e);
  }
  const CValue old = memory.load(*place);
  const CValue now = old.is_address() ? moved(old, by) : c_binary("+", old, c_integer(by), undefined(e).reason);
  store(e.operands[0], place, now);
  return before ? now : old;
}

CValue CRun::evaluate_call(const CExpression& e) {
  std::vector<CValue> arguments;
  for (std::size_t i = 1; i < e.operands.size(); ++i) arguments.push_back(evaluate(e.operands[i]));
  const CExpression& callee = e.operands[0];
  if (callee.kind != CExpression::variable || stopped_) return undefined(e);
  if (const CRoutine* f = function(callee.name)) return call(*f, arguments, e.line);
  const int reason = undefined(callee).reason;
  CValue result;
  if (c_math(callee.name, arguments.data(), arguments.size(), reason, result)) return result;
  if (!host_->only_reads(callee.name))
    for (const CValue& a : arguments)
      if (a.is_address()) {
        const CVariable& variable = memory.variable(a.address.variable);
        charge(steps_of_a_complaint + variable.cells.size() / cells_forgotten_in_a_step);
        memory.forget(a.address.variable, phrase({"{0} may change {1}", "{0}が{1}を変えうる"},
                                                 {in_quotes(callee.name), in_quotes(variable.name)}));
      }
  return host_->call(*this, callee.name, arguments, e.line);
}

// (GLfloat[]){ 1, 0, 0, 1 }: an array without a name.
CValue CRun::evaluate_literal(const CExpression& e) {
  CDeclaration d;
  d.line = e.line, d.name = "(...)", d.integer = e.integer;
  const CExpression& list = e.operands[0];
  const int variable =
      memory.declare(d.name, d.integer, {list.operands.size()}, c_converted(c_integer(0), d.integer, -1));
  if (variable < 0) return undefined(e);
  fill({variable, 0, 0}, list);
  return memory.load({variable, 0, 0});
}

}  // namespace cg
