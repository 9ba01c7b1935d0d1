#include "image/compose.h"

#include <algorithm>

#include "math/vec.h"

namespace cg {

namespace {
constexpr glm::u8vec4 line{255, 255, 255, 255}, gap_colour{32, 32, 32, 255};
constexpr int gap = 4;
}  // namespace

Picture wipe(const Picture& left, const Picture& right, double at) {
  assert(left.width() == right.width() && left.height() == right.height());
  Picture out = right;
  const int x = int(saturate(at) * left.width() + 0.5);
  for (int y = 0; y < out.height(); ++y) {
    std::copy_n(left.row(y), x, out.row(y));
    if (x > 0 && x < out.width()) out.at(x, y) = line;
  }
  return out;
}

Picture side_by_side(const std::vector<Picture>& pictures) {
  int width = 0, height = 0;
  for (const Picture& p : pictures) {
    width += (width ? gap : 0) + p.width();
    height = std::max(height, p.height());
  }
  Picture out(width, height, gap_colour);
  int left = 0;
  for (const Picture& p : pictures) {
    for (int y = 0; y < p.height(); ++y) std::copy_n(p.row(y), p.width(), out.row(y) + left);
    left += p.width() + gap;
  }
  return out;
}

}  // namespace cg
