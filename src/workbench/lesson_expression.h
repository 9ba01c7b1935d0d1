// What a lesson expects a number to be, as a formula: "degrees(acos(2^(-1/material.n)))".
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace cg {

// The value of a name: a number of the step ("peak"), a parameter ("material.n", "lights.0.position.x"), "start".
using VariableOf = std::function<std::optional<double>(std::string_view name)>;

// Numbers, names, pi, + - * / ^ (to the right, before the sign), parentheses, and the functions sqrt abs exp log sin
// cos tan asin acos atan atan2 min max degrees radians; angles are radians. Throws InputError with `where` for what is
// none of these, for a name that `variable` does not know, for more than 64 parentheses in each other, and for a
// result that is not finite.
double evaluate(std::string_view expression, const VariableOf& variable, const std::string& where);

}  // namespace cg
