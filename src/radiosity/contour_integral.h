// The double contour integral of two polygons' form factor.
#pragma once
#include <span>

#include "math/vec.h"

namespace cg {

// A_1 F_12 = 1/(2 pi) times the integral of ln r over both outlines (Stokes' theorem, twice). Each polygon lies on the
// front side of the other's plane, and both are counter-clockwise seen from the front. Edges may touch or coincide.
// Parallel edges are integrated in closed form, others once in closed form and once by Gauss points, halved where the
// edges come near each other. Off by about 1e-15 of the outlines' product.
double contour_integral(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second);

}  // namespace cg
