// The variables of a C program that is followed: scalars and arrays of numbers or addresses, by name and by address.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "workbench/c_value.h"

namespace cg {

struct CVariable {
  std::string_view name;
  bool integer = false;
  std::vector<std::size_t> lengths;  // of an array, one each dimension
  std::vector<CValue> cells;         // at least one
};

class CMemory {
 public:
  static constexpr std::size_t most_cells = 500'000;

  // Why something is not known; equal texts have one index.
  int reason(const Text& text);
  const Text& reason_text(int reason) const;
  CValue unknown(const Text& why) { return {CValue::unknown, false, reason(why), 0, {}, {}}; }

  // What a function gives that is not followed. `function`: of the program's text, which outlives this.
  CValue unknown_result(std::string_view function);

  // A new variable in the innermost block; all cells have `value`. -1 where it would be too large.
  int declare(std::string_view name, bool integer, std::vector<std::size_t> lengths, const CValue& value);
  // The name stands for that variable in the innermost block (static).
  void bind(std::string_view name, int variable);
  // By name, from the innermost block outwards; -1: none.
  int find(std::string_view name) const;
  int find_global(std::string_view name) const;
  CVariable& variable(int index) { return variables_[std::size_t(index)]; }
  int size() const { return int(variables_.size()); }

  void enter_block() { scopes_.emplace_back(); }
  void leave_block() { scopes_.pop_back(); }
  // A function sees its own blocks and the global variables; returns what leave_function wants.
  std::size_t enter_function();
  void leave_function(std::size_t before);
  std::size_t depth() const { return scopes_.size(); }
  void leave_to(std::size_t depth) { scopes_.resize(depth); }

  // The cell at an address of no further dimension; null outside the array.
  CValue* cell(const CAddress& address);
  // How many cells one step of the address is.
  std::size_t stride(const CAddress& address) const;
  // The array at the address as the address of its first element, or the value of its cell.
  CValue load(const CAddress& address);
  // Up to `n` cells from an address on; fewer where the array ends.
  std::vector<CValue> read(const CAddress& address, std::size_t n);
  // All cells of the variable become unknown.
  void forget(int variable, const Text& why);
  // Its known cells become values of the first picture alone.
  void change_later(int variable, const Text& why);

 private:
  std::vector<CVariable> variables_;
  std::vector<std::map<std::string_view, int>> scopes_{1};  // [0]: global
  std::size_t function_ = 1;                                // the first scope of the running function
  std::size_t cells_ = 0;
  std::vector<Text> reasons_;
  std::map<std::string, int> reason_index_;
  std::map<std::string_view, int> result_reasons_;  // by function
};

}  // namespace cg
