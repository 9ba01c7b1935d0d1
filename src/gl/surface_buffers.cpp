#include "gl/surface_buffers.h"

#include <cstring>

#include "gl/check.h"
#include "scene/only_plain.h"

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

const GpuSurface& SurfaceBuffers::get(const SurfaceHandle& surface, UploadedNormals normals, bool* kept) {
  const auto key = std::pair(surface.get(), normals);
  GpuSurface& s = buffers_[key];
  s.last_used = frame_;
  if (kept) *kept = s.surface != nullptr;
  if (s.surface) return s;
  s.surface = surface;
  try {
    upload(surface, normals, s);
    check_gl("vertex upload");
  } catch (...) {
    release(s);
    buffers_.erase(key);
    throw;
  }
  return s;
}

const GpuSurface& SurfaceBuffers::get_with_emission(const SurfaceHandle& surface, UploadedNormals normals,
                                                    const glm::vec3& emission) {
  get(surface, normals);
  GpuSurface& s = buffers_.at({surface.get(), normals});
  if (std::memcmp(&s.emission, &emission, sizeof emission) == 0) return s;
  s.emission = emission;
  std::vector<glm::vec3> sums = surface->radiosity;
  for (glm::vec3& sum : sums) sum += emission;
  glBindBuffer(GL_ARRAY_BUFFER, s.radiosity);
  glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(s.radiosity_bytes), sums.data());
  check_gl("vertex upload");
  return s;
}

namespace {

// A vertex's pairs, of set after set.
std::vector<glm::vec2> interleaved(const std::vector<std::vector<glm::vec2>>& sets) {
  std::vector<glm::vec2> out;
  out.reserve(sets.size() * sets[0].size());
  for (std::size_t v = 0; v < sets[0].size(); ++v)
    for (const auto& set : sets) out.push_back(set[v]);
  return out;
}

}  // namespace

void SurfaceBuffers::uv_attributes(int sets) const {
  for (int first = 0; arrays_ && first < sets; first += 2) {
    const GLuint index = uv_attribute + GLuint(first / 2);
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 2 * std::min(sets - first, 2), GL_FLOAT, GL_FALSE, sets * GLsizei(sizeof(glm::vec2)),
                          reinterpret_cast<const void*>(std::size_t(first) * sizeof(glm::vec2)));
  }
}

void SurfaceBuffers::upload(const SurfaceHandle& surface, UploadedNormals normals, GpuSurface& s) const {
  if (arrays_) {
    glGenVertexArrays(1, &s.array);
    glBindVertexArray(s.array);
  }
  const auto fill = [](GLenum target, GLuint& buffer, const auto& list, std::size_t& bytes) {
    const std::size_t size = list.size() * sizeof(list[0]);
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(size), list.data(), GL_STATIC_DRAW);
    bytes += size;
  };
  const auto attribute = [&](GLuint index) {
    if (!arrays_) return;
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  };
  fill(GL_ARRAY_BUFFER, s.positions, surface->positions, s.bytes);
  attribute(position_attribute);
  if (normals == UploadedNormals::within_float)
    fill(GL_ARRAY_BUFFER, s.normals, normals_within_float(surface->normals), s.normal_bytes);
  else if (normals == UploadedNormals::given)
    fill(GL_ARRAY_BUFFER, s.normals, surface->normals, s.normal_bytes);
  if (normals != UploadedNormals::none) attribute(normal_attribute);
  if (optional(!surface->radiosity.empty())) {
    fill(GL_ARRAY_BUFFER, s.radiosity, surface->radiosity, s.radiosity_bytes);
    attribute(radiosity_attribute);
  }
  if (optional(!surface->uv.empty())) {
    fill(GL_ARRAY_BUFFER, s.uv, interleaved(surface->uv), s.uv_bytes);
    uv_attributes(int(surface->uv.size()));
  }
  fill(GL_ELEMENT_ARRAY_BUFFER, s.indices, surface->indices, s.bytes);
  if (arrays_) glBindVertexArray(0);
}

void SurfaceBuffers::release(GpuSurface& s) {
  for (GLuint* buffer : {&s.positions, &s.indices, &s.normals, &s.radiosity, &s.uv})
    if (*buffer) glDeleteBuffers(1, buffer);
  if (s.array) glDeleteVertexArrays(1, &s.array);
}

std::size_t SurfaceBuffers::bytes() const {
  std::size_t all = 0;
  for (const auto& [key, s] : buffers_) all += s.bytes + s.normal_bytes + s.radiosity_bytes + s.uv_bytes;
  return all;
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
