// Two pictures of one scene, compared after the display transform: in figures, and as pictures.
#pragma once
#include <limits>

#include "image/display.h"

namespace cg {

struct Difference {
  std::size_t coverage_mismatch = 0;  // pixels that one covers and the other does not
  std::size_t covered = 0;            // pixels that both cover: what the following figures are about
  double max_error = 0;               // the largest |a - b| of a channel, 0..1
  double rmse = 0;                    // root of the mean of (a - b)^2 over pixels and channels
  double psnr = std::numeric_limits<double>::infinity();  // 20 log10(1 / rmse), dB; infinite where nothing differs
  std::size_t over_1_255 = 0;      // pixels with a channel that differs by more than 1/255 (and float's rounding, 1e-6)
  int worst_x = -1, worst_y = -1;  // where max_error is, the first from the top; -1 where nothing differs
  ColourImage error;               // a - b of every pixel, covered or not, -1..1
};

// a and b: linear, of one size. A mask has that size and 1 where something was drawn, or is empty: drawn everywhere.
Difference difference(const ColourImage& a, const ColourImage& b, const Image<std::uint8_t>& covered_a,
                      const Image<std::uint8_t>& covered_b, const Display& display);

// Pictures of the error, times `gain` (> 0).
Picture absolute_picture(const Difference& difference, double gain);  // |a - b|: black is equal
Picture signed_picture(const Difference& difference, double gain);    // middle grey is equal, brighter where a is
Picture false_colour(const Difference& difference, double gain);      // the channel that differs most, by ramp()

// The pixels that the display transform clamps, painted into `shown`: vermilion where a channel is above 1, sky blue
// where one is below 0 (by more than rounding, 1e-5). Returns how many of each; one that is both counts as above.
struct Clamped {
  std::size_t above = 0, below = 0;
};
Clamped mark_clamped(Picture& shown, const ColourImage& linear, const Display& display);

}  // namespace cg
