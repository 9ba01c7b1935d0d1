#include "gl/frame_target.h"

#include <cmath>
#include <string>

#include "gl/check.h"
#include "math/vec.h"
#include "params/input_error.h"

namespace cg {

namespace {

// The largest width and height that can be drawn at once.
glm::ivec2 largest_picture() {
  GLint viewport[2] = {0, 0}, renderbuffer = 0;
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  return {std::min(viewport[0], renderbuffer), std::min(viewport[1], renderbuffer)};
}

void refuse_beyond_limits(int width, int height) {
  const glm::ivec2 most = largest_picture();
  if (width <= most.x && height <= most.y) return;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const std::string limit = std::to_string(most.x) + "x" + std::to_string(most.y);
  throw InputError(
      "size",
      {"a picture of " + size + " is larger than this OpenGL can draw",
       size + " の画像はこの OpenGL で描ける大きさを超えています"},
      {"at most " + limit + ", or the technique software", limit + " 以下にするか、ソフトウェア描画を使ってください"});
}

}  // namespace

Frame empty_frame(const Scene& scene, const View& view, PassRecorder& record) {
  if (view.width > 0 && view.height > 0) refuse_beyond_limits(view.width, view.height);  // before its memory is taken
  const int w = std::max(view.width, 0), h = std::max(view.height, 0);
  Frame frame;
  frame.colour = ColourImage(w, h, glm::vec3(scene.display.background));
  frame.depth = Image<float>(w, h, 1.0f);
  frame.covered = Image<std::uint8_t>(w, h);
  if (view.ids) frame.object = frame.triangle = Image<std::int32_t>(w, h, nothing);
  if (view.normals) frame.normal = Image<glm::vec3>(w, h);
  if (!frame.colour.empty())
    record.item("picture", bytes_of(frame.colour) + bytes_of(frame.depth) + bytes_of(frame.covered));
  return frame;
}

Frame finish_empty(Frame frame, const View& view, PassRecorder& record) {
  if (view.ids) record.item("ids", id_bytes(frame));
  if (view.normals) record.item("normals", bytes_of(frame.normal));
  record.finish(frame);
  return frame;
}

bool FrameTarget::bind(int width, int height, Layers layers) {
  if (framebuffer_ && width == width_ && height == height_ && layers == layers_) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width, height);
    return true;
  }
  refuse_beyond_limits(width, height);
  release();
  const GLsizei samples = layers.ids || layers.normals || layers.samples < 2 ? 0 : layers.samples;
  auto attach = [&](GLenum format, std::size_t pixel, GLenum attachment, GLsizei samples, std::size_t& bytes) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    renderbuffers_.push_back(buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    bytes += std::size_t(width) * std::size_t(height) * pixel * std::size_t(std::max(samples, 1));
  };
  const GLenum colour = like_a_window_ ? GL_RGBA8 : GL_RGBA32F;
  const std::size_t colour_pixel = like_a_window_ ? sizeof(std::uint32_t) : sizeof(glm::vec4);
  if (samples > 0) {
    glGenFramebuffers(1, &resolved_);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
    attach(colour, colour_pixel, GL_COLOR_ATTACHMENT0, 0, bytes_.picture);
    attach(GL_DEPTH_COMPONENT32F, sizeof(float), GL_DEPTH_ATTACHMENT, 0, bytes_.picture);
  }
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  std::vector<GLenum> outputs{GL_COLOR_ATTACHMENT0};
  attach(colour, colour_pixel, GL_COLOR_ATTACHMENT0, samples, samples > 0 ? bytes_.samples : bytes_.picture);
  if (layers.ids) {
    outputs.push_back(GL_COLOR_ATTACHMENT0 + GLenum(outputs.size()));
    attach(GL_RG32I, sizeof(glm::ivec2), outputs.back(), 0, bytes_.ids);
  }
  if (layers.normals) {
    outputs.push_back(GL_COLOR_ATTACHMENT0 + GLenum(outputs.size()));
    attach(GL_RGBA32F, sizeof(glm::vec4), outputs.back(), 0, bytes_.normals);
  }
  attach(GL_DEPTH_COMPONENT32F, sizeof(float), GL_DEPTH_ATTACHMENT, samples,
         samples > 0 ? bytes_.samples : bytes_.picture);
  if (like_a_window_ && epoxy_has_gl_extension("GL_MESA_framebuffer_flip_y"))
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
  glDrawBuffers(GLsizei(outputs.size()), outputs.data());
  width_ = width, height_ = height, layers_ = layers;
  try {
    check_gl("framebuffer");
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw InputError("OpenGL", Words{"the driver cannot draw into floating-point pictures of this size",
                                       "ドライバーがこの大きさの浮動小数点画像に描けません"});
  } catch (...) {
    release();
    throw;
  }
  glViewport(0, 0, width, height);
  return false;
}

void FrameTarget::clear(const glm::vec3& background) const {
  const GLfloat colour[4] = {background.r, background.g, background.b, 1};
  const GLfloat no_normal[4] = {0, 0, 0, 0}, far_depth = 1;
  const GLint no_id[4] = {0, 0, 0, 0};
  GLint output = 0;
  glClearBufferfv(GL_COLOR, output++, colour);
  if (layers_.ids) glClearBufferiv(GL_COLOR, output++, no_id);
  if (layers_.normals) glClearBufferfv(GL_COLOR, output++, no_normal);
  glClearBufferfv(GL_DEPTH, 0, &far_depth);
}

void FrameTarget::resolve() const {
  if (!resolved_) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
}

void FrameTarget::release() {
  if (framebuffer_) glDeleteFramebuffers(1, &framebuffer_);
  if (resolved_) glDeleteFramebuffers(1, &resolved_);
  if (!renderbuffers_.empty()) glDeleteRenderbuffers(GLsizei(renderbuffers_.size()), renderbuffers_.data());
  framebuffer_ = resolved_ = 0;
  renderbuffers_.clear();
  bytes_ = {};
  width_ = height_ = 0;
}

std::vector<glm::vec4> FrameTarget::read_floats(int attachment) const {
  std::vector<glm::vec4> pixels(std::size_t(width_) * std::size_t(height_));
  glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(attachment));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

void FrameTarget::read_colour(Frame& frame) const {
  const std::vector<glm::vec4> pixels = read_floats(0);
  for (int y = 0; y < height_; ++y) {
    const glm::vec4* from = pixels.data() + std::size_t(height_ - 1 - y) * std::size_t(width_);
    glm::vec3* to = frame.colour.row(y);
    for (int x = 0; x < width_; ++x) {
      const glm::vec3 c(from[x]);
      const bool fine = is_finite(c);
      to[x] = fine ? c : glm::vec3(0);
      frame.nan_pixels += !fine;
    }
  }
}

void FrameTarget::read_depth(Frame& frame) const {
  glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, frame.depth.row(0));
  for (int y = 0; y < height_ / 2; ++y)
    std::swap_ranges(frame.depth.row(y), frame.depth.row(y) + width_, frame.depth.row(height_ - 1 - y));
  // Depth is cleared to 1 and the test is GL_LESS: what was drawn is nearer than 1, and nothing else is.
  for (std::size_t i = 0; i < frame.depth.size(); ++i) frame.covered.pixels()[i] = frame.depth.pixels()[i] < 1;
}

void FrameTarget::read_normals(Frame& frame, int attachment) const {
  const std::vector<glm::vec4> pixels = read_floats(attachment);
  for (int y = 0; y < height_; ++y) {
    const glm::vec4* from = pixels.data() + std::size_t(height_ - 1 - y) * std::size_t(width_);
    for (int x = 0; x < width_; ++x) frame.normal.at(x, y) = unit(glm::vec3(from[x]));
  }
}

std::vector<glm::ivec2> FrameTarget::read_ids(int attachment) const {
  std::vector<glm::ivec2> ids(std::size_t(width_) * std::size_t(height_));
  glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(attachment));
  glReadPixels(0, 0, width_, height_, GL_RG_INTEGER, GL_INT, ids.data());
  return ids;
}

void set_ids(Frame& frame, const std::vector<glm::ivec2>& ids, const std::vector<IdSource>& drawn) {
  const int width = frame.object.width(), height = frame.object.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::ivec2 id = ids[std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)];
      if (id.x <= 0 || std::size_t(id.x) > drawn.size()) continue;
      const IdSource& object = drawn[std::size_t(id.x) - 1];
      if (std::size_t(id.y) >= object.surface->triangle.size()) continue;
      frame.object.at(x, y) = object.index;
      frame.triangle.at(x, y) = std::int32_t(object.surface->triangle[std::size_t(id.y)]);
    }
}

}  // namespace cg
