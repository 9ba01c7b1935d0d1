// A prediction held against a trade's points, and the sentence that says how it came out.
#pragma once
#include "measure/trade.h"

namespace cg {

// Of trade.knob->predictions[prediction]; the points are there.
PredictionCheck check_prediction(const Trade& trade, std::size_t prediction);

// "h^1.98": the letter with the exponent to two digits.
std::string power_text(std::string_view letter, double exponent);

// "120 ms", or "8–40 ms" of several references; what they cost, drawn once.
std::string reference_time(const Trade& trade);

// A number with so many significant digits, as people write it: "0.0123", "1.2e-5", "340".
std::string short_number(double v, int digits = 3);

}  // namespace cg
