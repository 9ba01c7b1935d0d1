// B = E + rho F B, solved step by step, so that every step can be looked at.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "radiosity/form_factors.h"

namespace cg {

// Rows of F, kept or made when they are asked for; per RGB the same F.
class FormFactorMatrix {
 public:
  virtual ~FormFactorMatrix() = default;
  virtual std::size_t size() const = 0;
  // sum_j F_ij x_j, in double.
  virtual glm::dvec3 times(std::size_t i, std::span<const glm::dvec3> x) const = 0;
  // Calls visit(j, F_ij) for every entry of row i.
  virtual void row(std::size_t i, const std::function<void(std::size_t, double)>& visit) const = 0;
};

}  // namespace cg
