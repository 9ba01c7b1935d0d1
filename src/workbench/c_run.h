// Follows a C program as a machine would, as far as its values are known: a statement whose condition is not known is
// left out with a complaint, and what it would have assigned is not known afterwards. Functions that the program does
// not define are the host's.
#pragma once
#include <set>

#include "workbench/c_memory.h"
#include "workbench/c_syntax.h"

namespace cg {

class CRun;

// What running a statement, and the functions of the program that it calls, may change and do.
struct CEffects {
  std::set<std::string_view> assigned;  // names, without those that a function declares itself
  bool calls = false;                   // a function of OpenGL, GLU or GLUT
};

// What the program is run on.
class CHost {
 public:
  virtual ~CHost() = default;
  // A name that the program does not define: GL_LIGHT0.
  virtual std::optional<CValue> constant(std::string_view name) = 0;
  virtual CValue call(CRun& run, std::string_view function, const std::vector<CValue>& arguments, long line) = 0;
  // A routine of the program that is called: whether the host has done what it does, so that it is not followed.
  virtual bool plays(CRun& run, const CRoutine& routine, const std::vector<CValue>& arguments, long line) = 0;
  // Whether that function only reads what its arguments point to.
  virtual bool only_reads(std::string_view function) const = 0;
};

class CRun {
 public:
  CRun(const CProgram& program, CHost& host, Complaints& complaints);

  // The global variables and the statements outside functions, in order.
  void top();
  const CRoutine* function(std::string_view name) const;
  // Parameters without an argument are unknown.
  CValue call(const CRoutine& function, const std::vector<CValue>& arguments, long line);
  // The program has ended: nothing is followed any more.
  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }
  void go_on() { stopped_ = false; }

  // What a call did took about as long as that many ordinary steps: a loop may make it in each of its turns.
  void charge(std::size_t steps) { steps_ += long(steps); }
  void complain(long line, Text text) {
    charge(steps_of_a_complaint);
    complaints_->add(line, std::move(text));
  }
  // A complaint that begins with why the value is not known.
  void complain(long line, const CValue& value, const Words& consequence);

  // For a trial: the same state, with another host.
  CRun trial(CHost& host, Complaints& complaints) const;

  // The static variables that were declared so far, in functions too.
  const std::map<const CDeclaration*, int>& statics() const { return statics_; }
  // That one has its value for the first picture alone, for the reason, once it is declared.
  void change_later(const CDeclaration& declaration, const Text& why) { changing_[&declaration] = memory.reason(why); }

  CMemory memory;

 private:
  enum class Flow { next, break_, continue_, return_ };

  Flow run(const CStatement& statement);
  Flow run_list(const std::vector<CStatement>& list, std::size_t from = 0);
  Flow run_branch(const CStatement& statement);
  Flow run_loop(const CStatement& statement);
  Flow run_choice(const CStatement& statement);
  void declare(const CDeclaration& declaration);
  void declare_with_value(const CDeclaration& declaration);
  std::optional<std::vector<std::size_t>> lengths_of(const CDeclaration& declaration);
  void fill(CAddress at, const CExpression& list);

  CValue evaluate(const CExpression& e);
  CValue evaluate_name(const CExpression& e);
  CValue evaluate_unary(const CExpression& e);
  CValue evaluate_binary(const CExpression& e);
  CValue evaluate_call(const CExpression& e);
  CValue evaluate_literal(const CExpression& e);
  CValue increase(const CExpression& e, double by, bool before);
  CValue assign(const CExpression& e);
  std::optional<CAddress> place_of(const CExpression& e);
  void store(const CExpression& target, const std::optional<CAddress>& at, const CValue& value);
  CValue as_real(const CExpression& e);
  CValue moved(const CValue& address, double steps);
  CValue undefined(const CExpression& e);

  // Is the condition true? Nothing: not known, complained about where `skipped` would have done anything.
  std::optional<bool> holds(const CExpression& condition, std::initializer_list<const CStatement*> skipped);
  void complain_about(long line, const CValue& condition, const CEffects& effects);
  bool spend(long line);

  static constexpr std::size_t steps_of_a_complaint = 20, cells_forgotten_in_a_step = 16;

  const CProgram* program_;
  CHost* host_;
  Complaints* complaints_;
  std::map<std::string_view, const CRoutine*> functions_;
  std::map<const CDeclaration*, int> statics_, changing_;
  CValue returned_;
  std::map<const CStatement*, CEffects> effects_;
  long steps_ = 0;
  int depth_ = 0;
  bool stopped_ = false;
};

CEffects effects_of(const CStatement& statement, const CProgram& program, const CHost& host);
CEffects effects_of(const CRoutine& function, const CProgram& program, const CHost& host);

}  // namespace cg
