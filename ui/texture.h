// A picture on the graphics card. All functions need the window's OpenGL context to be current.
#pragma once
#include <imgui.h>

#include "image/display.h"

namespace cg {

class Texture {
 public:
  Texture() = default;
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  // Row 0 becomes the texture's first row. An empty image leaves an empty texture.
  void upload(const Picture& picture);
  void upload(const Image<float>& numbers);

  bool empty() const { return width_ == 0 || height_ == 0; }
  int width() const { return width_; }
  int height() const { return height_; }
  unsigned name() const { return name_; }
  ImTextureID id() const { return reinterpret_cast<ImTextureID>(std::uintptr_t(name_)); }
  // Whether a magnified texel is a square or fades into the next.
  void magnify(bool squares);

 private:
  void upload(int width, int height, int internal, unsigned format, unsigned type, const void* pixels);

  unsigned name_ = 0;
  int width_ = 0, height_ = 0, internal_ = 0;
  bool squares_ = false;
};

}  // namespace cg
