#include "gl/surface_buffers.h"

#include "gl/check.h"

namespace cg {

void GpuSurface::draw() const {
  glDrawElements(GL_TRIANGLES, GLsizei(surface->indices.size()), GL_UNSIGNED_INT, nullptr);
}

namespace {

std::vector<glm::vec3> normals_within_float(std::vector<glm::vec3> normals) {
  for (glm::vec3& n : normals) {
    const float square = glm::dot(n, n);
    if (!(square > 1e-20f && square < 1e20f)) n = unit(n);
  }
  return normals;
}

}  // namespace

const GpuSurface& SurfaceBuffers::get(const SurfaceHandle& surface, bool within_float) {
  const auto key = std::pair(surface.get(), within_float);
  GpuSurface& s = buffers_[key];
  s.last_used = frame_;
  if (s.surface) return s;
  s.surface = surface;
  const auto half = GLsizeiptr(surface->positions.size() * sizeof(glm::vec3));
  if (arrays_) {
    glGenVertexArrays(1, &s.array);
    glBindVertexArray(s.array);
  }
  glGenBuffers(1, &s.vertices);
  glGenBuffers(1, &s.indices);
  glBindBuffer(GL_ARRAY_BUFFER, s.vertices);
  glBufferData(GL_ARRAY_BUFFER, 2 * half, nullptr, GL_STATIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, half, surface->positions.data());
  if (within_float)
    glBufferSubData(GL_ARRAY_BUFFER, half, half, normals_within_float(surface->normals).data());
  else
    glBufferSubData(GL_ARRAY_BUFFER, half, half, surface->normals.data());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(surface->indices.size() * sizeof(std::uint32_t)),
               surface->indices.data(), GL_STATIC_DRAW);
  if (arrays_) {
    glEnableVertexAttribArray(position_attribute);
    glVertexAttribPointer(position_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(normal_attribute);
    glVertexAttribPointer(normal_attribute, 3, GL_FLOAT, GL_FALSE, 0, s.normal_offset());
    glBindVertexArray(0);
  }
  try {
    check_gl("vertex upload");
  } catch (...) {
    release(s);
    buffers_.erase(key);
    throw;
  }
  return s;
}

void SurfaceBuffers::release(GpuSurface& s) {
  glDeleteBuffers(1, &s.vertices);
  glDeleteBuffers(1, &s.indices);
  if (s.array) glDeleteVertexArrays(1, &s.array);
}

void SurfaceBuffers::end_frame() {
  constexpr long kept_frames = 8;
  for (auto i = buffers_.begin(); i != buffers_.end();)
    if (frame_ - i->second.last_used >= kept_frames) {
      release(i->second);
      i = buffers_.erase(i);
    } else {
      ++i;
    }
  ++frame_;
}

void SurfaceBuffers::clear() {
  for (auto& [key, s] : buffers_) release(s);
  buffers_.clear();
}

}  // namespace cg
