#include "shading/gl_call_list.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace cg {

double finite(double x) { return std::isnan(x) ? 0 : std::min(std::max(x, -double(FLT_MAX)), double(FLT_MAX)); }

std::vector<GlNumber> vector_numbers(const std::string& path, const glm::dvec3& v) {
  std::vector<GlNumber> numbers;
  for (int i = 0; i < 3; ++i) numbers.push_back({.value = finite(v[i]), .path = path, .component = i});
  return numbers;
}

GlCall& GlCallList::add(std::string_view function, std::vector<std::string> tokens) {
  GlCall call;
  call.function = function;
  call.tokens = std::move(tokens);
  call.section = section;
  return calls.emplace_back(std::move(call));
}

GlCall& GlCallList::add_array(std::string_view function, std::vector<std::string> tokens, std::string variable,
                              const std::string& path, const glm::dvec3& v, const GlNumber& fourth, Quantity quantity) {
  GlCall& call = add(function, std::move(tokens));
  call.variable = std::move(variable);
  call.numbers = vector_numbers(path, v);
  call.numbers.push_back(fourth);
  call.quantity = quantity;
  return call;
}

}  // namespace cg
