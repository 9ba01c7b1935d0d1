// A naive and a robust formula as a case.
#pragma once
#include "measure/extreme.h"

namespace cg {

inline ExtremeCase naive_case(std::string id, Words name, std::string parameter, std::string value, Words right,
                              double tolerance, Naive naive) {
  ExtremeCase c;
  c.id = "naive-" + std::move(id), c.group = "arithmetic", c.name = name;
  c.parameter = std::move(parameter), c.value = std::move(value), c.right = right;
  c.tolerance = tolerance;
  c.naive = std::move(naive);
  return c;
}

}  // namespace cg
