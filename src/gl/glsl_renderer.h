// The technique `gl`: the light model in GLSL, at the vertices (flat, Gouraud) or at the pixels (Phong).
#pragma once
#include "gl/frame_target.h"
#include "gl/program.h"
#include "gl/surface_buffers.h"

namespace cg {

// Belongs to one core context: every call on its thread.
class GlslRenderer {
 public:
  // Runs the passes of `plan`. Throws Cancelled, or InputError (picture or scene too large for this OpenGL).
  Frame render(const Scene& scene, const Plan& plan, const View& view, Progress& progress);
  void release();
  std::size_t programs() const { return programs_.size(); }

 private:
  FrameTarget target_;
  SurfaceBuffers buffers_{true};
  ProgramCache programs_;
};

}  // namespace cg
