// The layout as lines, for a picture on the screen or a file to paint over.
#pragma once
#include <string>

#include "image/display.h"
#include "mapping/uv_layout.h"

namespace cg {

struct LayoutLine {
  glm::dvec2 a, b;     // uv
  std::uint32_t face;  // one of the (at most two) faces whose edge it is
  bool border;         // of its chart
};

// Each edge once, as it lies in the texture: an edge on a seam has two.
std::vector<LayoutLine> layout_lines(const UvLayout& layout);

// An SVG of size x size pixels, the texture's lower left corner at its lower left: inner edges thin, borders of charts
// thick, nothing behind them.
std::string layout_svg(const UvLayout& layout, int size);

// The same as pixels on white, smooth; size from 1.
Picture layout_picture(const UvLayout& layout, int size);

}  // namespace cg
