// Where the hemicubes of a patch stand: a form factor is the mean over the patch of what its points see.
#pragma once
#include "radiosity/patches.h"

namespace cg {

struct SamplePosition {
  glm::dvec3 position;
  double weight;  // > 0; those of a patch sum to 1
};

// samples x samples positions. `grid`: the middles of as many equal parts, of equal weight where the patch is a
// parallelogram or a triangle. `gauss`: Gauss's points, exact for polynomials of degree 2 samples - 1 on those.
std::vector<SamplePosition> sample_positions(const Patch& patch, int samples, Placement placement);

// A rule for the integral over 0..1 of f(x) x^power, power 0 or 1: Gauss and Legendre's, or Gauss and Jacobi's. The
// weights sum to 1. count >= 1.
struct RulePoint {
  double x, weight;
};
std::vector<RulePoint> gauss_rule(int count, int power);

}  // namespace cg
