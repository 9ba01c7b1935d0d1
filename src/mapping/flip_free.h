// Maps of a disk that flip no triangle, whatever it costs in angles.
#pragma once
#include "mapping/conformal.h"

namespace cg {

// The border on a circle, each inner vertex the mean value of its neighbours.
FlatPositions mean_value_map(const ChartMesh& disk);

// From there downhill: the symmetric Dirichlet energy grows without bound before a triangle flips, so that none does.
// The border is free, and may come to cross itself.
FlatPositions free_boundary_map(const ChartMesh& disk, int most_steps = 100);

}  // namespace cg
