// How linear light becomes what a screen shows. Comparisons in 0..1 are made after it.
#pragma once
#include <cstdint>
#include <glm/vec4.hpp>

#include "image/image.h"
#include "params/field.h"

namespace cg {

// lecture: clamp to 0..1, no gamma, as the slides and the fixed function do. photographic: exposure, then sRGB.
enum class DisplayTransform { lecture, photographic };
template <>
inline constexpr std::array<Name, 2> names_of<DisplayTransform>{
    {{"lecture", {"Lecture (clamp)", "講義（クランプ）"}}, {"photographic", {"Photographic (sRGB)", "写真（sRGB）"}}}};

struct Display {
  DisplayTransform transform = DisplayTransform::lecture;
  double exposure = 0;             // stops; photographic only
  glm::dvec3 background{0, 0, 0};  // linear
  friend bool operator==(const Display&, const Display&) = default;
};

template <>
inline constexpr auto fields_of<Display> = std::tuple{
    field(&Display::transform,
          {.name = "transform",
           .label = {"Display", "表示変換"},
           .help = {"Lecture: the number is the brightness. Photographic: linear light, exposed, as sRGB.",
                    "講義では数値がそのまま明るさ。写真では線形の光を露出し sRGB にする。"}}),
    field(&Display::exposure, {.name = "exposure",
                               .unit = "EV",
                               .range = {-20, 20},
                               .slider = Range{-6, 6},
                               .label = {"Exposure", "露出"},
                               .help = {"In stops: +1 doubles the light.", "段数。+1 で光が 2 倍。"}}),
    field(&Display::background, {.name = "background",
                                 .meaning = Meaning::colour,
                                 .gl = "glClearColor",
                                 .label = {"Background", "背景色"},
                                 .help = {"What is seen where nothing is.", "何もない所の色。"}}),
};
static_assert(well_described<Display>());

// 8 bits a channel, as a screen or a PNG takes them: RGBA, opaque, already displayed.
using Picture = Image<glm::u8vec4>;

// IEC 61966-2-1: linear light 0..1 as sRGB 0..1 and back. Outside that range as its nearest end; NaN is 0.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

// What the display transform makes of linear light, each channel 0..1. NaN and less than 0 is 0, infinity is 1.
glm::vec3 displayed(const Display& display, const glm::vec3& linear);
ColourImage displayed(const Display& display, const ColourImage& linear);

// The nearest of the 256 steps to a displayed value; NaN is 0, outside 0..1 the nearest end.
std::uint8_t to_8bit(float shown);
// Linear light as a screen shows it.
Picture picture(const Display& display, const ColourImage& linear);

}  // namespace cg
