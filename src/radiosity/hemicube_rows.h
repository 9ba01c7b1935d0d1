// Rows of form factors by hemicubes: what each position of a patch sees, pixel by pixel.
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include "radiosity/row_sums.h"

namespace cg {

// What a position sees, into `items`; `gl` may be null. Adds to sums.fronts.
void draw_items(const ItemScene& scene, const DrawItems& gl, const HemicubeFrame& frame, int resolution, RowSums& sums,
                HemicubeItems& items);

class HemicubeRows {
 public:
  // `gl` draws the item buffers; the software rasteriser where it is null. The polygons must outlive this.
  HemicubeRows(std::span<const ItemPolygon> polygons, const Radiosity& options, bool normalise,
               const MakeDrawItems& gl);

  // Of `part`, which belongs to patch `own`. From several threads at once. Throws Cancelled.
  FormFactorRow row(const Patch& part, std::uint32_t own, const Progress& progress) const;

 private:
  // What one thread works in.
  struct Room {
    RowSums sums;
    HemicubeItems items;
  };

  ItemScene scene_;
  int resolution_, samples_;
  Placement placement_;
  bool normalise_;
  DrawItems gl_;
  PixelWeights pixel_weights_;
  TiledWeights weights_;
  mutable tbb::enumerable_thread_specific<Room> rooms_;
};

}  // namespace cg
