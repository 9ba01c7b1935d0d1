// Where a picture is on the screen, and which part of it is seen: looking at single pixels magnifies a region.
#pragma once
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace cg {

// The part of the picture that is seen, the same in both panes. Coordinates 0..1 from the top-left corner.
struct Region {
  double factor = 1;  // magnification, >= 1
  glm::dvec2 low{0, 0};
  double extent() const { return 1 / factor; }

  // Magnified by `by` so that `at` (0..1 of what is seen) stays where it is; never beyond the picture's edges.
  Region zoomed(double by, const glm::dvec2& at, double most) const {
    Region out;
    out.factor = std::clamp(factor * by, 1.0, std::max(1.0, most));
    if (out.factor < 1.02) return {};
    out.low = low + at * (extent() - out.extent());
    return out.kept_inside();
  }
  // Moved by a part of what is seen.
  Region moved(const glm::dvec2& by) const {
    Region out = *this;
    out.low -= by * extent();
    return out.kept_inside();
  }

 private:
  Region kept_inside() const {
    Region out = *this;
    const double most = 1 - extent();
    out.low = {std::clamp(low.x, 0.0, most), std::clamp(low.y, 0.0, most)};
    return out;
  }
};

// A picture of `width` x `height` pixels shown in the rectangle from `low` to `high` (screen pixels).
struct Place {
  ImVec2 low{0, 0}, high{0, 0};
  int width = 0, height = 0;
  Region region;

  double screen_width() const { return double(high.x - low.x); }
  double screen_height() const { return double(high.y - low.y); }
  bool empty() const { return !(high.x - low.x >= 1) || !(high.y - low.y >= 1) || width < 1 || height < 1; }
  ImVec2 middle() const { return {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}; }
  bool contains(ImVec2 p) const { return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y; }

  // 0..1 of what is seen.
  glm::dvec2 within(ImVec2 p) const {
    return {double(p.x - low.x) / screen_width(), double(p.y - low.y) / screen_height()};
  }
  // Pixels of the whole picture, fractional, from its top-left corner.
  glm::dvec2 to_picture(ImVec2 p) const {
    const glm::dvec2 at = region.low + within(p) * region.extent();
    return {at.x * width, at.y * height};
  }
  ImVec2 to_screen(const glm::dvec2& pixel) const {
    const glm::dvec2 at = (glm::dvec2(pixel.x / width, pixel.y / height) - region.low) * region.factor;
    return {float(double(low.x) + at.x * screen_width()), float(double(low.y) + at.y * screen_height())};
  }
  // Screen pixels for one pixel of the picture.
  double magnification() const { return screen_width() * region.factor / width; }
};

}  // namespace cg
