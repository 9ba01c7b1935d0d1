// Arithmetic by recursive descent: sum, product, sign, power, operand.
#include "workbench/lesson_expression.h"

#include <array>
#include <cmath>

#include "math/transform.h"
#include "params/input_error.h"
#include "params/numbers.h"

namespace cg {

namespace {

constexpr int deepest = 64;

struct Function {
  std::string_view name;
  int arguments;
  double (*value)(double a, double b);
};

constexpr std::array<Function, 15> functions{{
    {"sqrt", 1, [](double a, double) { return std::sqrt(a); }},
    {"abs", 1, [](double a, double) { return std::abs(a); }},
    {"exp", 1, [](double a, double) { return std::exp(a); }},
    {"log", 1, [](double a, double) { return std::log(a); }},
    {"sin", 1, [](double a, double) { return std::sin(a); }},
    {"cos", 1, [](double a, double) { return std::cos(a); }},
    {"tan", 1, [](double a, double) { return std::tan(a); }},
    {"asin", 1, [](double a, double) { return std::asin(a); }},
    {"acos", 1, [](double a, double) { return std::acos(a); }},
    {"atan", 1, [](double a, double) { return std::atan(a); }},
    {"degrees", 1, [](double a, double) { return degrees(a); }},
    {"radians", 1, [](double a, double) { return radians(a); }},
    {"atan2", 2, [](double a, double b) { return std::atan2(a, b); }},
    {"min", 2, [](double a, double b) { return std::min(a, b); }},
    {"max", 2, [](double a, double b) { return std::max(a, b); }},
}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Arithmetic {
 public:
  Arithmetic(std::string_view text, const VariableOf& variable, const std::string& where)
      : text_(text), variable_(variable), where_(where) {}

  double result() {
    const double value = sum();
    if (at_ < text_.size()) refuse();
    if (!std::isfinite(value))
      throw InputError(where_, {"\"" + std::string(text_) + "\" is not finite",
                                "「" + std::string(text_) + "」が有限の値にならない"});
    return value;
  }

 private:
  [[noreturn]] void refuse() const {
    const std::string rest(text_.substr(at_, 20)), whole(text_);
    throw InputError(where_,
                     rest.empty() ? Text{"\"" + whole + "\" ends too early", "「" + whole + "」が途中で終わっている"}
                                  : Text{"\"" + whole + "\": not understood from \"" + rest + "\" on",
                                         "「" + whole + "」の「" + rest + "」からが分からない"},
                     {"write a formula as 2*material.k_d.x", "2*material.k_d.x のような式を書く"});
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_blanks();
    return true;
  }
  void need(char c) {
    if (!take(c)) refuse();
  }

  double sum() {
    if (++depth_ > deepest) refuse();
    double value = product();
    while (true)
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        break;
    --depth_;
    return value;
  }
  double product() {
    double value = signed_power();
    while (true)
      if (take('*'))
        value *= signed_power();
      else if (take('/'))
        value /= signed_power();
      else
        return value;
  }
  double signed_power() {
    bool negative = false;
    while (true)
      if (take('-'))
        negative = !negative;
      else if (!take('+'))
        break;
    const double value = power();
    return negative ? -value : value;
  }
  double power() {
    if (++depth_ > deepest) refuse();
    const double base = operand();
    const double value = take('^') ? std::pow(base, signed_power()) : base;
    --depth_;
    return value;
  }
  double operand() {
    if (take('(')) {
      const double value = sum();
      need(')');
      return value;
    }
    skip_blanks();
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return named();
    refuse();
  }
  double number() {
    const std::size_t begin = at_;
    const auto digits = [&] {
      while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    };
    digits();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
      digits();
    }
    const auto value = parse_number(text_.substr(begin, at_ - begin));
    if (!value) {
      at_ = begin;
      refuse();
    }
    return *value;
  }
  double named() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    for (const Function& f : functions)
      if (f.name == name) return call(f);
    if (name == "pi") return pi;
    if (const auto value = variable_(name)) return *value;
    throw InputError(where_, {"there is no number " + std::string(name), "数 " + std::string(name) + " はない"},
                     {"name a number of the step, or a parameter such as material.n",
                      "ステップの数か、material.n のようなパラメータを書く"});
  }
  double call(const Function& f) {
    need('(');
    const double a = sum();
    double b = 0;
    if (f.arguments == 2) {
      need(',');
      b = sum();
    }
    need(')');
    return f.value(a, b);
  }

  const std::string_view text_;
  const VariableOf& variable_;
  const std::string& where_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

double evaluate(std::string_view expression, const VariableOf& variable, const std::string& where) {
  return Arithmetic(expression, variable, where).result();
}

}  // namespace cg
