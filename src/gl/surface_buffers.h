// The vertex and index buffers of surfaces, kept in OpenGL's memory as long as they are used.
#pragma once
#include <epoxy/gl.h>

#include <map>

#include "shading/surface.h"

namespace cg {

// Which normals are uploaded. `within_float`: those whose squares leave float's range are made unit first, for a
// GL_NORMALIZE that would lose them (it gives 0 for a length of 1e-20 or 1e25 on Mesa).
enum class UploadedNormals { none, given, within_float };

// Positions, normals and radiosity are three floats each, tightly packed, in a buffer each; normals only where they are
// needed, radiosity and uv where the surface has them.
struct GpuSurface {
  SurfaceHandle surface;
  GLuint positions = 0, indices = 0, normals = 0;
  GLuint radiosity = 0;  // in a legacy context with the emission below: the two are OpenGL's one emission there
  glm::vec3 emission{0};
  GLuint uv = 0;     // all sets: each vertex's pairs one after the other
  GLuint array = 0;  // vertex array object: the attributes below; 0 in a legacy context
  // As they were asked of OpenGL: positions and indices; normals; radiosity; uv.
  std::size_t bytes = 0, normal_bytes = 0, radiosity_bytes = 0, uv_bytes = 0;
  long last_used = 0;

  void draw() const;  // the buffers or the array must be bound
};

// Belongs to one context: every call on its thread.
class SurfaceBuffers {
 public:
  explicit SurfaceBuffers(bool arrays) : arrays_(arrays) {}
  // Uploads at the first call; `kept`, if not null: whether it was there already.
  // Throws InputError where OpenGL's memory does not suffice.
  const GpuSurface& get(const SurfaceHandle& surface, UploadedNormals normals, bool* kept = nullptr);
  // The same, with the radiosity of the vertices plus `emission`, which is uploaded again where it is another.
  const GpuSurface& get_with_emission(const SurfaceHandle& surface, UploadedNormals normals, const glm::vec3& emission);
  // To be called once a frame: frees what the last 8 frames did not use.
  void end_frame();
  void clear();
  std::size_t size() const { return buffers_.size(); }
  std::size_t bytes() const;  // of all of them

 private:
  static void release(GpuSurface& s);
  void upload(const SurfaceHandle& surface, UploadedNormals normals, GpuSurface& s) const;
  void uv_attributes(int sets) const;
  bool arrays_;
  long frame_ = 0;
  std::map<std::pair<const Surface*, UploadedNormals>, GpuSurface>
      buffers_;  // each keeps its surface, so that no address is used twice
};

// In every program of ours. Of uv, two sets share an attribute, the first one's.
inline constexpr GLuint position_attribute = 0, normal_attribute = 1, radiosity_attribute = 2, uv_attribute = 3;

}  // namespace cg
