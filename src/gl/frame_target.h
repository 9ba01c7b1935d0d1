// The picture that OpenGL draws into, and its way into a Frame: colour in RGBA32F, depth in 32F, on demand ids
// and normals. OpenGL's row 0 is the bottom; a Frame's is the top.
#pragma once
#include <epoxy/gl.h>

#include <vector>

#include "scene/pass_recorder.h"
#include "scene/scene.h"
#include "shading/surface.h"

namespace cg {

// The layers that `view` asks for, with the background in them, recorded as "picture". Throws InputError where OpenGL
// cannot draw so many pixels; needs its context unless there are none.
Frame empty_frame(const Scene& scene, const View& view, PassRecorder& record);
// Nothing is drawn: the picture is that one.
Frame finish_empty(Frame frame, const View& view, PassRecorder& record);
// Of the layers with the ids.
inline std::size_t id_bytes(const Frame& frame) { return bytes_of(frame.object) + bytes_of(frame.triangle); }

// Belongs to one context: every call on its thread.
class FrameTarget {
 public:
  // `like_a_window`: with what a window has, for comparisons with programs that draw into one: 8 bits a channel, and
  // the rows in the order in which drivers keep a window's, top first, where they offer it (GL_MESA_framebuffer_flip_y;
  // it changes how what is interpolated is rounded).
  explicit FrameTarget(bool like_a_window = false) : like_a_window_(like_a_window) {}

  struct Layers {
    bool ids = false;      // colour attachment 1: RG32I, object and primitive
    bool normals = false;  // colour attachment 2 (1 without ids): RGBA32F
    int samples = 1;       // a pixel; only without ids and normals
    friend bool operator==(const Layers&, const Layers&) = default;
  };

  // Binds a target of this size, made anew where it differs from the last. Throws InputError where the size is
  // beyond OpenGL's limits. `attachment` numbers: layers are bound to fragment outputs 0, 1, 2 in that order.
  // Returns whether the last one could be kept.
  bool bind(int width, int height, Layers layers);
  void clear(const glm::vec3& background) const;
  // After drawing, before reading: of several samples the mean, and of depths one.
  void resolve() const;
  void release();

  // From what is bound into layers of this size. Colours that are NaN or infinite become 0 and are counted.
  void read_colour(Frame& frame) const;
  void read_depth(Frame& frame) const;  // and Frame::covered
  void read_normals(Frame& frame, int attachment) const;
  // Of the pixels between OpenGL and the frame, in one of these: colour, or normals.
  std::size_t staging_bytes() const { return std::size_t(width_) * std::size_t(height_) * sizeof(glm::vec4); }
  // Rows from the bottom.
  std::vector<glm::ivec2> read_ids(int attachment) const;
  std::vector<glm::vec4> read_floats(int attachment) const;

  // As they were asked of OpenGL.
  struct Bytes {
    std::size_t picture = 0, samples = 0, ids = 0, normals = 0;  // picture, samples: colour and depth
  };
  const Bytes& bytes() const { return bytes_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  const bool like_a_window_;
  int width_ = 0, height_ = 0;
  Layers layers_;
  GLuint framebuffer_ = 0, resolved_ = 0;  // resolved_: of several samples a pixel; else 0
  std::vector<GLuint> renderbuffers_;
  Bytes bytes_;
};

// One object's part in a picture's ids, for the primitive number of a draw call to become the mesh's triangle.
struct IdSource {
  int index;  // into Scene::objects
  SurfaceHandle surface;
};

// Fills Frame::object and Frame::triangle. `ids`: per pixel, rows from the bottom, the draw's number + 1 (0 where
// nothing is) and the primitive.
void set_ids(Frame& frame, const std::vector<glm::ivec2>& ids, const std::vector<IdSource>& drawn);

}  // namespace cg
