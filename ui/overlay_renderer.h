// Draws lines in world space over a picture, by OpenGL 3.3 core: one pixel and more wide, smooth, and faint where
// the picture's own depth says that they are hidden.
#pragma once
#include <array>
#include <functional>
#include <glm/vec4.hpp>
#include <span>

#include "ui/pane_place.h"
#include "ui/texture.h"
#include "workbench/overlay.h"

namespace cg {

struct LineStyle {
  glm::vec4 colour{1};
  float hidden = 0.15f;  // of its alpha, where something stands before it
  float width = 1.5f;    // pixels
};

// Where the picture is on the framebuffer, in pixels from the lower left corner, and how much of it may be drawn to.
struct LineTarget {
  glm::vec4 viewport;       // x, y, width, height of the whole picture
  std::array<int, 4> clip;  // the same of what is visible of it
};

// Of the picture at `place`; `clip` is what of the screen may be drawn to: left, top, right, bottom.
LineTarget line_target(const Place& place, const std::array<float, 4>& clip);

// Needs the window's context to be current, in the destructor too.
class OverlayRenderer {
 public:
  OverlayRenderer() = default;
  ~OverlayRenderer();
  OverlayRenderer(const OverlayRenderer&) = delete;
  OverlayRenderer& operator=(const OverlayRenderer&) = delete;

  // Lines that stay for many pictures: uploaded once.
  void keep(std::vector<Lines> lines);
  // Draws what was kept, then `more`. `depth`: of the picture (window depth, row 0 at the top); may be empty.
  // Changes program, vertex array, viewport, scissor, blending and texture unit 0.
  void draw(std::span<const Lines> more, const Camera& camera, const LineTarget& target, const Texture& depth,
            const std::function<LineStyle(Mark)>& style);

 private:
  struct Range {
    Mark mark;
    glm::dvec3 origin;
    int first, count;
  };
  void prepare();
  void draw_ranges(unsigned vertices, std::span<const Range> ranges, const Camera& camera, const LineTarget& target,
                   const std::function<LineStyle(Mark)>& style);
  static std::vector<Range> upload(unsigned buffer, std::span<const Lines> lines, unsigned usage);

  unsigned program_ = 0, kept_buffer_ = 0, more_buffer_ = 0, kept_array_ = 0, more_array_ = 0;
  std::vector<Range> kept_;
  std::vector<Lines> waiting_;  // kept, not yet uploaded
  bool changed_ = false, failed_ = false;
};

}  // namespace cg
