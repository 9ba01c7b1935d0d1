// A hemicube to be looked at: its five faces unfolded into a cross, which patch each pixel sees and what it counts.
#pragma once
#include "image/image.h"
#include "radiosity/form_factors.h"
#include "radiosity/hemicube.h"

namespace cg {

// Pictures of 2R x 2R pixels, row 0 at the top: the top face in the middle, the sides around it, nothing in the four
// corners.
struct HemicubeView {
  HemicubeFrame frame;
  int resolution = 0;
  double share = 1;                  // of the patch's row: the weight of this position
  Image<std::uint32_t> items;        // as scene/item_drawer.h; no_item in the corners too
  Image<float> weights;              // what each pixel counts of this position's row; 0 in the corners
  std::uint32_t lying_on = no_item;  // the patch that lies on the position and takes all of its light
};

// A pixel of such a picture: its face and its place there, counted from the lowest s and t; nothing in the corners.
struct CrossPixel {
  HemicubeFace face;
  int x, y;
};
std::optional<CrossPixel> cross_pixel(int x, int y, int resolution);
// Of the pixel's sample as seen from the frame's position, unit, in world coordinates.
glm::dvec3 pixel_direction(const HemicubeView& view, const CrossPixel& pixel);

// Made once for the patches, which must outlive it.
class HemicubeViewer {
 public:
  explicit HemicubeViewer(const Patches& patches, MakeDrawItems gl = {});

  // How many positions a patch has by these options; 0 without area.
  static std::size_t positions(const Patch& patch, const Radiosity& options);
  // From position 0 .. positions() - 1 of a patch with area, as form_factor_method() draws it. Some milliseconds.
  HemicubeView view(std::uint32_t patch, std::size_t position, const Radiosity& options) const;

 private:
  struct Drawn;
  std::shared_ptr<const Drawn> drawn_;
};

}  // namespace cg
