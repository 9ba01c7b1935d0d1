// Textures in OpenGL's memory, kept as long as they are used; all levels as TextureImage has them, so that no driver
// makes its own.
#pragma once
#include <epoxy/gl.h>

#include <map>

#include "scene/texture.h"
#include "scene/texture_image.h"

namespace cg {

// Sets what the bound texture of `target` is read with. Sampling::anisotropy counts where the driver has it.
void set_sampling(GLenum target, const Sampling& sampling);

// Belongs to one context: every call on its thread.
class TextureObjects {
 public:
  // Uploaded at the first call; `kept`, if not null: whether it was there already. Row 0 is the lowest, as OpenGL's.
  // Throws InputError where OpenGL's memory does not suffice.
  GLuint get(const TextureHandle& image, bool* kept = nullptr);
  // To be called once a frame: frees what the last 8 frames did not use.
  void end_frame();
  void clear();
  std::size_t bytes() const;  // as asked of OpenGL

 private:
  struct Kept {
    TextureHandle image;  // so that no address is used twice
    GLuint name = 0;
    std::size_t bytes = 0;
    long last_used = 0;
  };
  long frame_ = 0;
  std::map<const TextureImage*, Kept> kept_;
};

}  // namespace cg
