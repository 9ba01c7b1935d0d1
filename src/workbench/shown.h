// A frame as a screen shows it, 8 bits a channel, made on the thread that drew it and not on the window's.
#pragma once
#include <glm/gtc/type_precision.hpp>

#include "image/display.h"
#include "scene/frame.h"

namespace cg {

inline constexpr glm::u8vec4 clamped_high{255, 0, 255, 255}, clamped_low{0, 160, 255, 255};

// The frame's colours through the display transform, opaque; the frame's size.
Image<glm::u8vec4> shown(const Frame& frame, const Display& display);

// Paints the covered pixels whose colour leaves 0..1: above in `clamped_high`, below in `clamped_low`. Returns
// how many there are. The picture and the frame have one size; the frame was drawn without clamping.
std::size_t mark_clamped(Image<glm::u8vec4>& picture, const Frame& frame);

}  // namespace cg
