// Pictures made smaller from many samples a pixel, or larger by repeating pixels. The filters are those of Don
// Mitchell and Arun Netravali, Reconstruction Filters in Computer Graphics, 1988, section 2.
#pragma once
#include "image/image.h"
#include "measure/knob.h"

namespace cg {

// `factor` >= 1. box and tent: the picture's sides are multiples of it; nearest: they become so many times longer.
ColourImage resampled(const ColourImage& image, Resampling how, int factor);

// 1 where one of the samples is covered (box; the tent's own pixel too), or the repeated pixel is.
Image<std::uint8_t> resampled_coverage(const Image<std::uint8_t>& covered, Resampling how, int factor);

}  // namespace cg
