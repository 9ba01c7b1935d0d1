// The hemicube of a patch as pictures: which patch each pixel sees, what it looks like, and what the pixel counts; and
// what a patch's pixels add up to.
#pragma once
#include <array>
#include <vector>

#include "image/display.h"
#include "radiosity/hemicube_view.h"

namespace cg {

// Colours that tell patches apart: any two of few are different, neighbours in number most of all. Opaque.
glm::u8vec4 item_colour(std::uint32_t patch);

// What each pixel is drawn in, by its item, its weight, and its direction (unit, world).
using PixelColour = std::function<glm::u8vec4(std::uint32_t item, float weight, const glm::dvec3& direction)>;
// item_colour(); backs darker, nothing black.
PixelColour item_colours();
// The light that each patch sends back, B over pi, as the display transform has it; `radiosity` by patch. Without it
// (empty) the reflectance of each patch's material, a little darker where it is seen at a slant, and what emits white.
PixelColour seen_colours(const Patches& patches, const std::vector<glm::dvec3>& radiosity, const Display& display);
// By image/ramp.h; `full` is the lightest.
PixelColour weight_colours(double full);
// The largest delta form factor of the resolution, of the pixel in the middle: 4/(pi R^2).
double largest_delta_form_factor(int resolution);

// The pixel of the cross that sees along a direction, given in the frame's x, y, z with z >= 0, any length but 0.
glm::ivec2 cross_place(const glm::dvec3& direction, int resolution);

// The cross as HemicubeView has it, of at most `most` pixels a side (then some of the hemicube's are left out). The
// four corners are transparent.
Picture cross_picture(const HemicubeView& view, const PixelColour& colour, int most = 1024);
// The same from straight above, on the base of the hemisphere: x to the right, y up in the frame, -1..1. What a patch
// covers of the disc is its form factor from the position. Outside of the disc transparent.
Picture disc_picture(const HemicubeView& view, const PixelColour& colour, int size);

// What one patch (or back, or nothing) has of the pixels.
struct PatchPixels {
  std::uint32_t item = no_item;  // as scene/item_drawer.h
  std::uint32_t pixels = 0;
  double sum = 0;              // of their weights
  glm::ivec2 low{0}, high{0};  // the box of them in the cross, both in it
};
// By ascending item; the corners of the cross do not count.
std::vector<PatchPixels> patch_pixels(const HemicubeView& view);

// What each way to weigh pixels makes of an item's, and of all that see something.
struct WeightedSum {
  double item = 0, all = 0;
};
using AllWeights = std::array<PixelWeights, names_of<PixelWeight>.size()>;
AllWeights all_weights(int resolution);
std::array<WeightedSum, names_of<PixelWeight>.size()> weighted_sums(const HemicubeView& view, std::uint32_t item,
                                                                    const AllWeights& weights);

// The boundary of a patch's pixels: lines between pixels of the cross, from (x0, y0) to (x1, y1), in pixels from its
// upper left corner, each as long as it goes straight on.
struct PixelEdge {
  int x0, y0, x1, y1;
  friend bool operator==(const PixelEdge&, const PixelEdge&) = default;
};
std::vector<PixelEdge> item_outline(const HemicubeView& view, const PatchPixels& of);

}  // namespace cg
