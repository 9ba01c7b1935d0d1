// Where a logarithmic axis has its numbers.
#pragma once
#include <string>
#include <vector>

namespace cg {

struct PlotTick {
  double value;
  std::string text;  // "0.01", "10^-5"
};

// Between low and high (0 < low < high): whole decades where there are at least three, else 1, 2, 5, else finer. At
// least two, at most about nine.
std::vector<PlotTick> log_ticks(double low, double high);

// In equal steps of 1, 2 or 5 times a power of ten between low and high (low < high).
std::vector<PlotTick> even_ticks(double low, double high);

}  // namespace cg
