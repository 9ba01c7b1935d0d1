// A chart laid flat by one of the methods, and whether that went well.
#pragma once
#include "mapping/conformal.h"
#include "mapping/distortion.h"

namespace cg {

struct FlatChart {
  FlatPositions flat;  // of each vertex; the chart's area in the plane is its area on the surface
  DistortionSum distortion;
  bool simple_border = false;
  bool injective() const { return distortion.flipped == 0 && simple_border; }
};

// `disk` is one (is_disk), or of a single face. Always finite: where a method has no solution, the round border's.
FlatChart flatten(const ChartMesh& disk, UnwrapMethod method);

}  // namespace cg
