// Numbers as a panel shows them, and sliders' positions as numbers.
#pragma once
#include <string>

#include "params/field.h"

namespace cg {

// How many decimals a slider of this range moves by: a hundredth of it, rounded down to a power of ten.
int decimals(const About& about);

// `value` with at least `decimals` decimals and exact if that fits into `room` characters; else rounded to fit.
std::string number_text(double value, int decimals, std::size_t room = 8);

// With exactly so many decimals.
std::string rounded(double value, int decimals);

// Where `value` stands on the slider, 0..1; NaN stands at 0.
double slider_position(const About& about, double value);

// The number at `position` (limited to 0..1), rounded to what the slider moves by; `fine` is ten times finer.
double slider_value(const About& about, double position, bool fine);

// The number one step of the mouse wheel away, inside the accepted range.
double stepped(const About& about, double value, double steps, bool fine);

}  // namespace cg
