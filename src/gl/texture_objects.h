// Textures in OpenGL's memory, kept as long as they are used; all levels as TextureImage has them, so that no driver
// makes its own.
#pragma once
#include <epoxy/gl.h>

#include <map>
#include <tuple>
#include <vector>

#include "scene/texture.h"
#include "scene/texture_image.h"
#include "scene/texture_layer.h"

namespace cg {

// Sets what the bound texture of `target` is read with. Sampling::anisotropy counts where the driver has it.
void set_sampling(GLenum target, const Sampling& sampling);

// How exactly a texture is read: drivers interpolate 8 bits with weights of 8 bits, which normals would show. `fine`
// holds them in more.
enum class Stored { as_given, fine };
inline Stored stored_for(const TextureLayer& layer) {
  const bool normals = layer.target == LayerTarget::normal && layer.bump == BumpKind::normal_map;
  return normals ? Stored::fine : Stored::as_given;
}

// As OpenGL holds it, all levels.
std::size_t texture_bytes(const TextureImage& image, Stored stored = Stored::as_given);

// One sampler object a texture unit, so that two layers read one picture in two ways. Belongs to one context.
class UnitSamplers {
 public:
  void bind(int unit, const Sampling& sampling);
  void unbind(int units);
  void clear();

 private:
  std::vector<GLuint> names_;
};

// Belongs to one context: every call on its thread.
class TextureObjects {
 public:
  // Uploaded at the first call; `kept`, if not null: whether it was there already. Row 0 is the lowest, as OpenGL's.
  // Throws InputError where OpenGL's memory does not suffice.
  // `copy`: texture objects of one image that are read in different ways at once, where there are no samplers.
  GLuint get(const TextureHandle& image, bool* kept = nullptr, int copy = 0, Stored stored = Stored::as_given);
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
  std::map<std::tuple<const TextureImage*, int, Stored>, Kept> kept_;
};

}  // namespace cg
