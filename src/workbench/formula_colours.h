// Which part of a formula is which quantity, so that k_d has the same colour in a lesson as on its slider.
#pragma once
#include <string_view>
#include <vector>

#include "params/field.h"

namespace cg {

struct FormulaPart {
  std::string_view markup;  // of formula.h
  Quantity quantity = Quantity::none;
};

// Cuts markup where the quantity changes. A quantity begins at the symbol of a parameter that has one (k_d, n, I_a) and
// holds for the factors behind it, up to the next +, −, = or bracket: "k_d (N·L) + k_s (R·V)^n" has three parts.
// `carried`: the quantity that the formula's part before left open, updated.
std::vector<FormulaPart> coloured_parts(std::string_view markup, Quantity& carried);

}  // namespace cg
