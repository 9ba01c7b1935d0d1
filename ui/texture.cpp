#include "ui/texture.h"

#include <epoxy/gl.h>

namespace cg {

Texture::~Texture() {
  if (name_) glDeleteTextures(1, &name_);
}

void Texture::upload(const Picture& picture) {
  upload(picture.width(), picture.height(), GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels().data());
}

void Texture::upload(const Image<float>& numbers) {
  upload(numbers.width(), numbers.height(), GL_R32F, GL_RED, GL_FLOAT, numbers.pixels().data());
}

void Texture::upload(int width, int height, int internal, unsigned format, unsigned type, const void* pixels) {
  if (width <= 0 || height <= 0) {
    width_ = height_ = 0;
    return;
  }
  const bool first = name_ == 0;
  if (first) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  if (first) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  if (width != width_ || height != height_ || internal != internal_)
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, pixels);
  else
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, format, type, pixels);
  width_ = width, height_ = height, internal_ = internal;
}

void Texture::magnify(bool squares) {
  if (!name_ || squares == squares_) return;
  glBindTexture(GL_TEXTURE_2D, name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, squares ? GL_NEAREST : GL_LINEAR);
  squares_ = squares;
}

}  // namespace cg
