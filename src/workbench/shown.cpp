#include "workbench/shown.h"

#include <cassert>
#include <glm/common.hpp>

#include "math/vec.h"

namespace cg {

namespace {

bool inside(float v) { return v >= 0 && v <= 1; }

}  // namespace

Image<glm::u8vec4> shown(const Frame& frame, const Display&) {
  const ColourImage& colour = frame.colour;
  Image<glm::u8vec4> out(colour.width(), colour.height());
  for (std::size_t i = 0; i < colour.size(); ++i)
    out.pixels()[i] = glm::u8vec4(saturate(colour.pixels()[i]) * 255.0f + 0.5f, 255);
  return out;
}

std::size_t mark_clamped(Image<glm::u8vec4>& picture, const Frame& frame) {
  assert(picture.size() == frame.colour.size() && picture.size() == frame.covered.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const glm::vec3& c = frame.colour.pixels()[i];
    if (!frame.covered.pixels()[i] || (inside(c.r) && inside(c.g) && inside(c.b))) continue;
    picture.pixels()[i] = c.r > 1 || c.g > 1 || c.b > 1 ? clamped_high : clamped_low;
    ++count;
  }
  return count;
}

}  // namespace cg
