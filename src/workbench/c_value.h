// A value while a C program is followed: a number, an address, or known not to be known, and why.
#pragma once
#include <cstddef>
#include <string_view>

#include "params/words.h"

namespace cg {

// `level` dimensions of the variable's array are behind it: what is there has those that are left.
struct CAddress {
  int variable = -1;
  std::size_t offset = 0;  // in cells
  int level = 0;
};

struct CValue {
  // at_start: the number is right for the first picture, and changes later.
  enum State { known, at_start, unknown };
  State state = known;
  bool integer = false;
  int reason = -1;  // why it is not known; an index into CMemory's reasons
  double number = 0;
  CAddress address;           // where it is one
  std::string_view function;  // of the program, where it is one

  bool is_address() const { return address.variable >= 0; }
  bool is_number() const { return !is_address() && function.empty(); }
};

inline CValue c_integer(double v) { return {CValue::known, true, -1, v, {}, {}}; }
inline CValue c_real(double v) { return {CValue::known, false, -1, v, {}, {}}; }

// a op b for the operators of two numbers, with C's rules for whole numbers: 1/2 is 0 (ISO/IEC 9899:1990, 6.3). What
// has no defined result (a division by zero, an overflow) is unknown, its reason `undefined`.
CValue c_binary(std::string_view op, const CValue& a, const CValue& b, int undefined);
CValue c_unary(std::string_view op, const CValue& a, int undefined);
// Cut towards zero for a whole number's type.
CValue c_converted(const CValue& v, bool to_integer, int undefined);

// A function of <math.h> by its name, also with an f behind it, of `n` arguments; false where there is none.
bool c_math(std::string_view name, const CValue* arguments, std::size_t n, int undefined, CValue& result);

}  // namespace cg
