// The technique `gl`: the light model in GLSL, at the vertices (flat, Gouraud) or at the pixels (Phong).
#pragma once
#include "gl/draw_list.h"
#include "gl/frame_target.h"
#include "gl/program.h"
#include "gl/surface_buffers.h"
#include "gl/texture_objects.h"

namespace cg {

// Belongs to one core context: every call on its thread.
class GlslRenderer {
 public:
  // Runs the passes of `plan`. Throws Cancelled, or InputError (picture or scene too large for this OpenGL).
  Frame render(const Scene& scene, const Plan& plan, const View& view, Progress& progress);
  void release();

  // What lives in the context, for tests that ask OpenGL about it.
  const ProgramCache& programs() const { return programs_; }
  const SurfaceBuffers& buffers() const { return buffers_; }
  const FrameTarget& target() const { return target_; }
  const TextureObjects& textures() const { return textures_; }

 private:
  struct Item;  // what one object is drawn with
  void upload_textures(const std::vector<Item>& items, PassRecorder& record);
  void bind_textures(const Item& item);
  std::vector<Item> prepare(const Scene& scene, const Plan& plan, const View& view, PassRecorder& record, Frame& frame);
  void draw(const Scene& scene, const View& view, const std::vector<Item>& items, Progress& progress);

  FrameTarget target_;
  SurfaceBuffers buffers_{true};
  ProgramCache programs_;
  TextureObjects textures_;
  UnitSamplers samplers_;
};

}  // namespace cg
