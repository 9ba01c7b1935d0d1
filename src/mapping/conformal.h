// Conformal maps of a disk: angles are kept as well as they can be, the border is free.
#pragma once
#include <optional>
#include <vector>

#include "mapping/chart_mesh.h"

namespace cg {

using FlatPositions = std::vector<glm::dvec2>;  // of each vertex of a chart

// Least squares conformal map, two far vertices of the border held. Nothing where the system cannot be solved. May flip
// triangles, and its border may cross itself.
std::optional<FlatPositions> least_squares_conformal(const ChartMesh& disk);

// Spectral conformal map: no vertex is held, so none pulls; a few solves more.
std::optional<FlatPositions> spectral_conformal(const ChartMesh& disk);

}  // namespace cg
