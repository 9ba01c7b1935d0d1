// Rows of form factors by Monte Carlo: rays from all over a patch, distributed as its light is.
// This work is based on: Thomas Malley, A Shading Method for Computer Generated Images, 1988 (points of the disc lifted
// to the hemisphere are distributed by the cosine).
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include "radiosity/patch_tree.h"
#include "radiosity/row_sums.h"

namespace cg {

class RayRows {
 public:
  // The polygons must outlive this.
  RayRows(std::span<const ItemPolygon> polygons, const Radiosity& options, bool normalise);

  // Ray r of patch `own` is the same in every run; positions and directions are stratified, each for itself. From
  // several threads at once. Throws Cancelled.
  FormFactorRow row(const Patch& part, std::uint32_t own, const Progress& progress) const;

 private:
  ItemScene scene_;
  PatchTree tree_;
  std::uint32_t rays_;
  bool normalise_;
  mutable tbb::enumerable_thread_specific<RowSums> rooms_;
};

}  // namespace cg
