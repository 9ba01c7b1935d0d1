// The technique `gl-fixed`: OpenGL's fixed function, as the slides and the assignments call it. It plays the list of
// calls that the listing shows (shading/gl_calls.h), in its order.
#pragma once
#include <functional>

#include "gl/draw_list.h"
#include "gl/fixed_player.h"
#include "gl/frame_target.h"
#include "gl/surface_buffers.h"
#include "gl/texture_objects.h"

namespace cg {

// Belongs to one legacy context: every call on its thread.
class FixedRenderer {
 public:
  // `like_a_window`: see FrameTarget.
  explicit FixedRenderer(bool like_a_window = false) : target_(like_a_window) {}

  // Runs the passes of `plan`. Throws Cancelled, or InputError (scene not supported, picture or scene too large).
  Frame render(const Scene& scene, const Plan& plan, const View& view, Progress& progress);
  void release();

  // What lives in the context, for tests that ask OpenGL about it.
  const SurfaceBuffers& buffers() const { return buffers_; }
  const FrameTarget& target() const { return target_; }

 private:
  struct Picture;  // what is the same for all calls of one picture
  void upload(const Picture& picture);
  void draw(Picture& picture, Frame& frame);
  void play(const GlCall& call, Picture& picture, FixedPlayer& player);
  void upload_textures(const Picture& picture);
  void bind_texture(const GlCall& call, const Picture& picture);
  void draw_mesh(const DrawItem& item, Picture& picture, const FixedPlayer& player);
  void draw_arrays(const DrawItem& item, Picture& picture);
  void draw_again(const Picture& picture, const glm::mat4& projection,
                  const std::function<void(const DrawItem&)>& draw);
  void draw_ids(const Picture& picture, const glm::mat4& projection, Frame& frame);
  void draw_normals(const Picture& picture, const glm::mat4& projection, Frame& frame);

  FrameTarget target_;
  SurfaceBuffers buffers_{false};
  TextureObjects textures_;
};

}  // namespace cg
