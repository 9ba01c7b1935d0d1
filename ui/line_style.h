// How lines over a picture look, by what they mean.
#pragma once
#include <imgui.h>

#include "ui/overlay_renderer.h"

namespace cg {

// Pictures are mostly dark in either theme: what stands on them is light in both.
inline constexpr ImU32 on_picture = IM_COL32(255, 255, 255, 255);

// A patch, and the one that it sees, wherever they are lit: Okabe and Ito's yellow and sky blue.
inline constexpr ImU32 patch_colour = IM_COL32(240, 228, 66, 255), other_patch_colour = IM_COL32(86, 180, 233, 255);

// `scale` as in Look.
LineStyle style_of(float scale, Mark mark);

// Of the vectors of a probed point, as letters and tips have it too.
ImU32 colour_of(Mark vector);

}  // namespace cg
