// False colours for a number, and what stands beside them.
#pragma once
#include <array>
#include <glm/vec4.hpp>

namespace cg {

// 0 is dark, 1 is light. Lightness rises evenly while the hue goes from blue over violet and orange to yellow, so that
// the order reads the same without red or green, and in grey print. Outside 0..1 as the nearest end; NaN is 0.
glm::u8vec4 ramp(double t);

// The numbers at 0, 1/4, 1/2, 3/4 and 1 of the ramp where 1 stands for `full`.
std::array<double, 5> ramp_legend(double full);

}  // namespace cg
