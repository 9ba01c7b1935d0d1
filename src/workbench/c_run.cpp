#include "workbench/c_run.h"

#include "scene/text_scanner.h"

namespace cg {

namespace {

constexpr long most_steps = 2'000'000;
constexpr int deepest_call = 40;
constexpr std::size_t most_dimensions = 8;
constexpr Words left_out{"what depends on it is left out", "これによる処理は読み込まない"};
constexpr Words first_picture{"taken as in the first picture", "最初の画像での値とみなす"};

}  // namespace

CRun::CRun(const CProgram& program, CHost& host, Complaints& complaints)
    : program_(&program), host_(&host), complaints_(&complaints) {
  for (const CRoutine& f : program.routines) functions_[f.name] = &f;
}

CRun CRun::trial(CHost& host, Complaints& complaints) const {
  CRun copy = *this;
  copy.host_ = &host;
  copy.complaints_ = &complaints;
  return copy;
}

void CRun::complain(long line, const CValue& value, const Words& consequence) {
  complain(line, phrase({"{0}: {1}", "{0}：{1}"}, {memory.reason_text(value.reason), Text(consequence)}));
}

const CRoutine* CRun::function(std::string_view name) const {
  const auto at = functions_.find(name);
  return at == functions_.end() ? nullptr : at->second;
}

bool CRun::spend(long line) {
  if (stopped_) return false;
  if (++steps_ <= most_steps) return true;
  complain(line, {"the program takes too long to be followed beyond here", "処理が長すぎて、ここから先は追えない"});
  stopped_ = true;
  return false;
}

void CRun::top() { run_list(program_->top); }

CValue CRun::call(const CRoutine& f, const std::vector<CValue>& arguments, long line) {
  if (host_->plays(*this, f, arguments, line))
    return memory.unknown({"a function that draws has no value", "描く関数に値はない"});
  if (depth_ >= deepest_call) {
    complain(line, phrase({"{0} calls itself too deeply to be followed", "{0}の呼び出しが深すぎて追えない"},
                          {in_quotes(f.name)}));
    return memory.unknown({"a function calls itself too deeply", "関数の呼び出しが深すぎる"});
  }
  ++depth_;
  const std::size_t before = memory.enter_function();
  for (std::size_t i = 0; i < f.parameters.size(); ++i) {
    const CDeclaration& d = f.parameters[i];
    CValue value = i < arguments.size() ? arguments[i] : memory.unknown({"an argument is missing", "引数が足りない"});
    if (!d.pointer && d.lengths.empty()) value = c_converted(value, d.integer, -1);
    memory.declare(d.name, d.integer, {}, value);
  }
  returned_ = memory.unknown(phrase({"{0} returns no value", "{0}は値を返さない"}, {in_quotes(f.name)}));
  run_list(f.body.body);
  memory.leave_function(before);
  --depth_;
  return returned_;
}

CRun::Flow CRun::run_list(const std::vector<CStatement>& list, std::size_t from) {
  for (std::size_t i = from; i < list.size(); ++i) {
    const Flow flow = run(list[i]);
    if (flow != Flow::next || stopped_) return flow;
  }
  return Flow::next;
}

CRun::Flow CRun::run(const CStatement& s) {
  if (!spend(s.line)) return Flow::return_;
  switch (s.kind) {
    case CStatement::expression:
      evaluate(s.expressions[0]);
      return Flow::next;
    case CStatement::declaration:
      for (const CDeclaration& d : s.declarations) declare(d);
      return Flow::next;
    case CStatement::block: {
      memory.enter_block();
      const Flow flow = run_list(s.body);
      memory.leave_block();
      return flow;
    }
    case CStatement::branch:
      return run_branch(s);
    case CStatement::loop:
    case CStatement::do_loop: {
      memory.enter_block();
      const Flow flow = run_loop(s);
      memory.leave_block();
      return flow;
    }
    case CStatement::choice:
      return run_choice(s);
    case CStatement::break_:
      return Flow::break_;
    case CStatement::continue_:
      return Flow::continue_;
    case CStatement::return_:
      if (!s.expressions.empty()) returned_ = evaluate(s.expressions[0]);
      return Flow::return_;
    case CStatement::label:
    case CStatement::empty:
      break;
  }
  return Flow::next;
}

// A variable that would have been assigned is complained about where it is used.
void CRun::complain_about(long line, const CValue& condition, const CEffects& effects) {
  if (condition.state == CValue::unknown && effects.calls) complain(line, condition, left_out);
  if (condition.state == CValue::at_start && (effects.calls || !effects.assigned.empty()))
    complain(line, condition, first_picture);
}

std::optional<bool> CRun::holds(const CExpression& condition, std::initializer_list<const CStatement*> skipped) {
  const CValue v = evaluate(condition);
  if (v.is_address() || !v.function.empty()) return true;
  CEffects effects;
  if (v.state != CValue::known)
    for (const CStatement* s : skipped) {
      auto [at, added] = effects_.try_emplace(s);
      if (added) at->second = effects_of(*s, *program_, *host_);
      effects.assigned.insert(at->second.assigned.begin(), at->second.assigned.end());
      effects.calls = effects.calls || at->second.calls;
    }
  complain_about(condition.line, v, effects);
  if (v.state != CValue::unknown) return v.number != 0;
  for (const std::string_view name : effects.assigned)
    if (const int variable = memory.find(name); variable >= 0) memory.forget(variable, memory.reason_text(v.reason));
  return std::nullopt;
}

CRun::Flow CRun::run_branch(const CStatement& s) {
  const bool has_else = s.body.size() > 1;
  const std::optional<bool> yes =
      has_else ? holds(s.expressions[0], {&s.body[0], &s.body[1]}) : holds(s.expressions[0], {&s.body[0]});
  if (!yes) return Flow::next;
  if (*yes) return run(s.body[0]);
  return has_else ? run(s.body[1]) : Flow::next;
}

CRun::Flow CRun::run_loop(const CStatement& s) {
  const bool until = s.kind == CStatement::do_loop;
  const CExpression& condition = s.expressions[until ? 0 : 1];
  if (!until) {
    if (s.body.size() > 1) run(s.body[1]);
    if (s.expressions[0].kind != CExpression::list) evaluate(s.expressions[0]);
  }
  for (bool first = true; !stopped_; first = false) {
    if (!(until && first) && condition.kind != CExpression::list) {
      const auto yes = holds(condition, {&s.body[0]});
      if (!yes || !*yes) break;
    }
    const Flow flow = run(s.body[0]);
    if (flow == Flow::break_) break;
    if (flow == Flow::return_) return flow;
    if (!until && s.expressions[2].kind != CExpression::list) evaluate(s.expressions[2]);
    if (!spend(s.line)) break;
  }
  return Flow::next;
}

CRun::Flow CRun::run_choice(const CStatement& s) {
  const CStatement& body = s.body[0];
  const CValue v = evaluate(s.expressions[0]);
  if (v.state != CValue::known) {
    const CEffects effects = effects_of(body, *program_, *host_);
    complain_about(s.line, v, effects);
    if (v.state == CValue::unknown) {
      for (const std::string_view name : effects.assigned)
        if (const int i = memory.find(name); i >= 0) memory.forget(i, memory.reason_text(v.reason));
      return Flow::next;
    }
  }
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < body.body.size(); ++i) {
    if (body.body[i].kind != CStatement::label) continue;
    const bool is_default = body.body[i].expressions.empty();
    if (is_default && !from) from = i;
    if (is_default) continue;
    const CValue label = evaluate(body.body[i].expressions[0]);
    if (label.state == CValue::known && label.number == v.number) {
      from = i;
      break;
    }
  }
  if (!from) return Flow::next;
  memory.enter_block();
  const Flow flow = run_list(body.body, *from);
  memory.leave_block();
  return flow == Flow::break_ ? Flow::next : flow;
}

// ---- declarations ----

std::optional<std::vector<std::size_t>> CRun::lengths_of(const CDeclaration& d) {
  std::vector<std::size_t> lengths;
  if (d.lengths.size() > most_dimensions) return std::nullopt;
  for (const CExpression& e : d.lengths) {
    if (e.kind == CExpression::list) {  // []: as long as what is in it
      const bool listed = lengths.empty() && !d.initial.empty() && d.initial[0].kind == CExpression::list;
      if (!listed) return std::nullopt;
      lengths.push_back(d.initial[0].operands.size());
      continue;
    }
    const CValue v = evaluate(e);
    if (v.state == CValue::unknown || !v.is_number() || !(v.number >= 0 && v.number <= 1e6)) return std::nullopt;
    lengths.push_back(std::size_t(v.number));
  }
  // { 1, 2, 3, 4 } for [][4]: the numbers without inner braces.
  if (!d.lengths.empty() && d.lengths[0].kind == CExpression::list && lengths.size() > 1 &&
      !d.initial[0].operands.empty() && d.initial[0].operands[0].kind != CExpression::list) {
    std::size_t inner = 1;
    for (std::size_t i = 1; i < lengths.size(); ++i) inner *= std::max<std::size_t>(lengths[i], 1);
    lengths[0] = (lengths[0] + inner - 1) / inner;
  }
  return lengths;
}

void CRun::declare(const CDeclaration& d) {
  const bool is_new = d.is_static && !statics_.contains(&d);
  declare_with_value(d);
  const auto change = changing_.find(&d);
  if (is_new && change != changing_.end() && statics_.contains(&d))
    memory.change_later(statics_[&d], Text(memory.reason_text(change->second)));
}

void CRun::declare_with_value(const CDeclaration& d) {
  if (d.is_extern && memory.find_global(d.name) >= 0) return;
  const bool lasting = d.is_static || memory.depth() == 1;
  if (d.is_static)
    if (const auto at = statics_.find(&d); at != statics_.end()) return memory.bind(d.name, at->second);
  const auto lengths = lengths_of(d);
  const Text name = in_quotes(d.name);
  const CValue start =
      !d.known || !lengths
          ? memory.unknown(phrase({"values of the type of {0} are not read", "{0}の型の値は読み込めない"}, {name}))
      : lasting ? c_converted(c_integer(0), d.integer, -1)
                : memory.unknown(phrase({"{0} has no value yet", "{0}にはまだ値がない"}, {name}));
  const int variable = memory.declare(d.name, d.integer, lengths.value_or(std::vector<std::size_t>{}), start);
  if (variable < 0) {
    memory.declare(d.name, d.integer, {}, memory.unknown(phrase({"{0} is too large", "{0}は大きすぎる"}, {name})));
    return;
  }
  if (d.is_static) statics_[&d] = variable;
  if (d.initial.empty() || !d.known || !lengths) return;
  const CExpression& initial = d.initial[0];
  if (initial.kind == CExpression::list) {
    for (CValue& cell : memory.variable(variable).cells) cell = c_converted(c_integer(0), d.integer, -1);
    fill({variable, 0, 0}, initial);
  } else if (lengths->empty()) {
    const CValue value = evaluate(initial);
    CValue& cell = memory.variable(variable).cells[0];
    cell =
        d.pointer ? value : c_converted(value, d.integer, memory.reason({"the number is too large", "数が大きすぎる"}));
  } else {
    memory.forget(variable,
                  phrase({"the initial value of {0} is not understood", "{0}の初期値が解釈できない"}, {name}));
  }
}

// Inner braces are of one element; numbers without them fill cell by cell.
void CRun::fill(CAddress at, const CExpression& list) {
  const CVariable& v = memory.variable(at.variable);
  const bool integer = v.integer;
  const std::size_t cells = v.cells.size();
  CAddress element{at.variable, at.offset, at.level + 1};
  const std::size_t step = std::size_t(at.level) < v.lengths.size() ? memory.stride(element) : 1;
  for (const CExpression& e : list.operands) {
    if (element.offset >= cells) {
      complain(e.line, {"more values are given than the array holds", "配列の長さより多くの値がある"});
      return;
    }
    if (e.kind == CExpression::list) {
      if (element.level > int(most_dimensions)) return;
      fill(element, e);
      element.offset += step;
      continue;
    }
    const CValue value = evaluate(e);
    memory.variable(at.variable).cells[element.offset++] =
        c_converted(value, integer, memory.reason({"the number is too large", "数が大きすぎる"}));
  }
}

}  // namespace cg
