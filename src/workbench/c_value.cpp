#include "workbench/c_value.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace cg {

namespace {

constexpr double least_int = -2147483648.0, largest_int = 4294967295.0;  // also of an unsigned

CValue with_state(CValue v, const CValue& a, const CValue& b) {
  const CValue& worse = b.state > a.state ? b : a;
  v.state = worse.state, v.reason = worse.reason;
  return v;
}

CValue unknown(int reason) { return {CValue::unknown, false, reason, 0, {}, {}}; }

// A result that must be a number of its type.
CValue checked(CValue v, int undefined) {
  if (!std::isfinite(v.number) || (v.integer && !(v.number >= least_int && v.number <= largest_int)))
    return unknown(undefined);
  return v;
}

double compare(std::string_view op, double a, double b) {
  if (op == "<") return a < b;
  if (op == ">") return a > b;
  if (op == "<=") return a <= b;
  if (op == ">=") return a >= b;
  if (op == "==") return a == b;
  return a != b;
}

CValue bits(std::string_view op, std::int64_t a, std::int64_t b, int undefined) {
  if (op == "&") return c_integer(double(a & b));
  if (op == "|") return c_integer(double(a | b));
  if (op == "^") return c_integer(double(a ^ b));
  if (a < 0 || b < 0 || b > 31) return unknown(undefined);
  return checked(c_integer(double(op == "<<" ? a << b : a >> b)), undefined);
}

CValue arithmetic(std::string_view op, const CValue& a, const CValue& b, int undefined) {
  const bool integer = a.integer && b.integer;
  const auto result = [&](double v) { return checked({CValue::known, integer, -1, v, {}, {}}, undefined); };
  if (op == "+") return result(a.number + b.number);
  if (op == "-") return result(a.number - b.number);
  if (op == "*") return result(a.number * b.number);
  if (op == "/" || op == "%") {
    if (b.number == 0 || (op == "%" && !integer)) return unknown(undefined);
    if (op == "%") return result(std::fmod(a.number, b.number));
    return result(integer ? std::trunc(a.number / b.number) : a.number / b.number);
  }
  for (const std::string_view relation : {"<", ">", "<=", ">=", "==", "!="})
    if (op == relation) return c_integer(compare(op, a.number, b.number));
  if (!integer) return unknown(undefined);
  return bits(op, std::int64_t(a.number), std::int64_t(b.number), undefined);
}

struct Function {
  std::string_view name;
  double (*of)(double);
};
constexpr std::array<Function, 16> functions{{{"sin", [](double x) { return std::sin(x); }},
                                              {"cos", [](double x) { return std::cos(x); }},
                                              {"tan", [](double x) { return std::tan(x); }},
                                              {"asin", [](double x) { return std::asin(x); }},
                                              {"acos", [](double x) { return std::acos(x); }},
                                              {"atan", [](double x) { return std::atan(x); }},
                                              {"sqrt", [](double x) { return std::sqrt(x); }},
                                              {"exp", [](double x) { return std::exp(x); }},
                                              {"log", [](double x) { return std::log(x); }},
                                              {"log10", [](double x) { return std::log10(x); }},
                                              {"fabs", [](double x) { return std::abs(x); }},
                                              {"floor", [](double x) { return std::floor(x); }},
                                              {"ceil", [](double x) { return std::ceil(x); }},
                                              {"sinh", [](double x) { return std::sinh(x); }},
                                              {"cosh", [](double x) { return std::cosh(x); }},
                                              {"tanh", [](double x) { return std::tanh(x); }}}};

bool math(std::string_view name, const CValue* a, std::size_t n, int undefined, CValue& result) {
  const auto apply = [&](double v, const CValue& x, const CValue& y) {
    result = x.state == CValue::unknown   ? x
             : y.state == CValue::unknown ? y
                                          : with_state(checked(c_real(v), undefined), x, y);
    if (!std::isfinite(v) && x.state != CValue::unknown && y.state != CValue::unknown) result = unknown(undefined);
    return true;
  };
  for (std::size_t i = 0; i < n; ++i)
    if (!a[i].is_number()) return false;
  if (n == 1) {
    for (const Function& f : functions)
      if (f.name == name) return apply(f.of(a[0].number), a[0], a[0]);
    if (name == "abs") {
      apply(std::abs(a[0].number), a[0], a[0]);
      result.integer = a[0].integer;
      return true;
    }
  }
  if (n == 2) {
    if (name == "pow") return apply(std::pow(a[0].number, a[1].number), a[0], a[1]);
    if (name == "atan2") return apply(std::atan2(a[0].number, a[1].number), a[0], a[1]);
    if (name == "fmod") return apply(std::fmod(a[0].number, a[1].number), a[0], a[1]);
    if (name == "hypot") return apply(std::hypot(a[0].number, a[1].number), a[0], a[1]);
    if (name == "fmax" || name == "fmin")
      return apply(name == "fmax" ? std::fmax(a[0].number, a[1].number) : std::fmin(a[0].number, a[1].number), a[0],
                   a[1]);
  }
  return false;
}

}  // namespace

CValue c_binary(std::string_view op, const CValue& a, const CValue& b, int undefined) {
  if (!a.is_number() || !b.is_number()) return unknown(undefined);
  if (a.state == CValue::unknown) return a;
  if (b.state == CValue::unknown) return b;
  const CValue v = arithmetic(op, a, b, undefined);
  return v.state == CValue::unknown ? v : with_state(v, a, b);
}

CValue c_unary(std::string_view op, const CValue& a, int undefined) {
  if (!a.is_number()) return unknown(undefined);
  if (a.state == CValue::unknown) return a;
  CValue v = a;
  if (op == "-") v.number = -a.number;
  if (op == "!") v.number = a.number == 0, v.integer = true;
  if (op == "~") {
    if (!a.integer) return unknown(undefined);
    v.number = double(~std::int64_t(a.number));
  }
  return v;
}

CValue c_converted(const CValue& v, bool to_integer, int undefined) {
  if (!v.is_number() || v.state == CValue::unknown || v.integer == to_integer) return v;
  CValue out = v;
  out.integer = to_integer;
  if (to_integer) out.number = std::trunc(v.number);
  return out.integer ? checked(out, undefined) : out;
}

bool c_math(std::string_view name, const CValue* a, std::size_t n, int undefined, CValue& result) {
  return math(name, a, n, undefined, result) ||
         (name.ends_with('f') && math(name.substr(0, name.size() - 1), a, n, undefined, result));
}

}  // namespace cg
