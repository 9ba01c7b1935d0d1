#include "gl/texture_objects.h"

#include <array>

#include "gl/check.h"

namespace cg {

namespace {

constexpr int frames_kept = 8;

GLint wrap_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return GL_REPEAT;
    case Wrap::mirror:
      return GL_MIRRORED_REPEAT;
    case Wrap::clamp:
      return GL_CLAMP_TO_EDGE;
    case Wrap::border:
      return GL_CLAMP_TO_BORDER;
  }
  return GL_REPEAT;
}

GLint filter_of(MinFilter filter) {
  constexpr std::array<GLint, 6> tokens{GL_NEAREST,
                                        GL_LINEAR,
                                        GL_NEAREST_MIPMAP_NEAREST,
                                        GL_LINEAR_MIPMAP_NEAREST,
                                        GL_NEAREST_MIPMAP_LINEAR,
                                        GL_LINEAR_MIPMAP_LINEAR};
  return tokens[std::size_t(filter)];
}

struct Storage {
  GLint format;
  std::size_t texel_bytes;
};

// By the kind of level 0. OpenGL has no sRGB of 16 bits: such an image goes as light, in floats.
Storage storage_of(const TextureImage& image, Stored stored) {
  const bool srgb = image.encoding() == Encoding::srgb, fine = stored == Stored::fine;
  const bool bytes = std::holds_alternative<Image<glm::u8vec4>>(image.texels(0));
  if (bytes && !fine) return {srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, 4};
  if ((bytes || std::holds_alternative<Image<glm::u16vec4>>(image.texels(0))) && !srgb) return {GL_RGBA16, 8};
  return {GL_RGBA32F, 16};
}

void upload(GLint level, GLint format, const TextureImage& image) {
  const int w = image.width(level), h = image.height(level);
  const auto send = [&](GLenum type, const void* texels) {
    glTexImage2D(GL_TEXTURE_2D, level, format, w, h, 0, GL_RGBA, type, texels);
  };
  if (format == GL_RGBA32F && image.encoding() == Encoding::srgb) {
    Image<glm::vec4> light = Image<glm::vec4>::unwritten(w, h);
    for (int j = 0; j < h; ++j)
      for (int i = 0; i < w; ++i) light.at(i, j) = image.texel(level, i, j);
    return send(GL_FLOAT, light.row(0));
  }
  const Texels& texels = image.texels(level);
  if (const auto* bytes = std::get_if<Image<glm::u8vec4>>(&texels)) return send(GL_UNSIGNED_BYTE, bytes->row(0));
  if (const auto* words = std::get_if<Image<glm::u16vec4>>(&texels)) return send(GL_UNSIGNED_SHORT, words->row(0));
  send(GL_FLOAT, std::get<Image<glm::vec4>>(texels).row(0));
}

}  // namespace

namespace {

// `i`, `f` and `fv` set a parameter: of a texture, or of a sampler object.
template <class SetInteger, class SetNumber, class SetNumbers>
void set_parameters(const Sampling& s, SetInteger i, SetNumber f, SetNumbers fv) {
  i(GL_TEXTURE_WRAP_S, wrap_of(s.wrap_s));
  i(GL_TEXTURE_WRAP_T, wrap_of(s.wrap_t));
  i(GL_TEXTURE_MAG_FILTER, s.mag_filter == MagFilter::linear ? GL_LINEAR : GL_NEAREST);
  i(GL_TEXTURE_MIN_FILTER, filter_of(s.min_filter));
  f(GL_TEXTURE_LOD_BIAS, float(s.bias));
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    f(GL_TEXTURE_MAX_ANISOTROPY_EXT, float(s.anisotropy));
  const glm::vec4 border(glm::vec3(s.border), float(s.border_alpha));
  fv(GL_TEXTURE_BORDER_COLOR, &border.x);
}

}  // namespace

void set_sampling(GLenum target, const Sampling& s) {
  set_parameters(
      s, [&](GLenum name, GLint v) { glTexParameteri(target, name, v); },
      [&](GLenum name, GLfloat v) { glTexParameterf(target, name, v); },
      [&](GLenum name, const GLfloat* v) { glTexParameterfv(target, name, v); });
}

std::size_t texture_bytes(const TextureImage& image, Stored stored) {
  std::size_t texels = 0;
  for (int level = 0; level < image.levels(); ++level)
    texels += std::size_t(image.width(level)) * std::size_t(image.height(level));
  return texels * storage_of(image, stored).texel_bytes;
}

void UnitSamplers::bind(int unit, const Sampling& s) {
  while (int(names_.size()) <= unit) glGenSamplers(1, &names_.emplace_back());
  const GLuint name = names_[std::size_t(unit)];
  set_parameters(
      s, [&](GLenum what, GLint v) { glSamplerParameteri(name, what, v); },
      [&](GLenum what, GLfloat v) { glSamplerParameterf(name, what, v); },
      [&](GLenum what, const GLfloat* v) { glSamplerParameterfv(name, what, v); });
  glBindSampler(GLuint(unit), name);
}

void UnitSamplers::unbind(int units) {
  for (int i = 0; i < units; ++i) glBindSampler(GLuint(i), 0);
}

void UnitSamplers::clear() {
  if (!names_.empty()) glDeleteSamplers(GLsizei(names_.size()), names_.data());
  names_.clear();
}

GLuint TextureObjects::get(const TextureHandle& image, bool* kept, int copy, Stored stored) {
  Kept& k = kept_[{image.get(), copy, stored}];
  k.last_used = frame_;
  if (kept) *kept = k.image != nullptr;
  if (k.image) return k.name;
  try {
    const Storage storage = storage_of(*image, stored);
    glGenTextures(1, &k.name);
    glBindTexture(GL_TEXTURE_2D, k.name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, image->levels() - 1);
    for (int level = 0; level < image->levels(); ++level) upload(level, storage.format, *image);
    k.bytes = texture_bytes(*image, stored);
    glBindTexture(GL_TEXTURE_2D, 0);
    check_gl("texture upload");
  } catch (...) {
    glDeleteTextures(1, &k.name);
    kept_.erase({image.get(), copy, stored});
    throw;
  }
  k.image = image;
  return k.name;
}

void TextureObjects::end_frame() {
  ++frame_;
  std::erase_if(kept_, [&](const auto& entry) {
    const bool old = frame_ - entry.second.last_used > frames_kept;
    if (old) glDeleteTextures(1, &entry.second.name);
    return old;
  });
}

void TextureObjects::clear() {
  for (const auto& [image, k] : kept_) glDeleteTextures(1, &k.name);
  kept_.clear();
}

std::size_t TextureObjects::bytes() const {
  std::size_t sum = 0;
  for (const auto& [image, k] : kept_) sum += k.bytes;
  return sum;
}

}  // namespace cg
