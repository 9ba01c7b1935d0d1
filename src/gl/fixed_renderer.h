// The technique `gl-fixed`: OpenGL's fixed function, as the slides and the assignments call it.
#pragma once
#include "gl/draw_list.h"
#include "gl/frame_target.h"
#include "gl/surface_buffers.h"

namespace cg {

// Belongs to one legacy context: every call on its thread.
class FixedRenderer {
 public:
  // Runs the passes of `plan`. Throws Cancelled, or InputError (scene not supported, picture or scene too large).
  Frame render(const Scene& scene, const Plan& plan, const View& view, Progress& progress);
  void release();

 private:
  void draw_lit(const DrawItem& item, const Scene& scene, const EyeLighting<double>& lighting,
                const glm::mat4& projection);
  void draw_ids(const std::vector<DrawItem>& items, const glm::mat4& projection, Frame& frame);
  void draw_normals(const Scene& scene, const std::vector<DrawItem>& items, const glm::mat4& projection, Frame& frame);

  FrameTarget target_;
  SurfaceBuffers buffers_{false};
};

}  // namespace cg
