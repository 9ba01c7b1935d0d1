#include "gl/hemicube_items.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "gl/check.h"
#include "gl/gl_thread.h"
#include "gl/program.h"
#include "gl/surface_buffers.h"
#include "params/input_error.h"

namespace cg {

namespace {

// Nearness, near / distance, as depth: precise at all distances where depth may go from 0 to 1 (GL_ARB_clip_control).
constexpr const char* vertex_shader = R"(#version 330 core
uniform mat3 to_face;  // from the eye to x, y and w of clip space
uniform vec3 eye;
uniform float near, zero_to_one;
in vec3 position;
in uint normal;  // the item
flat out uint item;
void main() {
  vec3 p = to_face * (position - eye);
  gl_Position = vec4(p.xy, zero_to_one > 0.0 ? near : 2.0 * near - p.z, p.z);
  item = normal;
}
)";
constexpr const char* fragment_shader = R"(#version 330 core
flat in uint item;
out uint colour;
void main() { colour = gl_FrontFacing ? item : item | 0x80000000u; }
)";

// Where each face stands in the target, and what clip space's x, y and w are of the frame's x, y and z
// (radiosity/hemicube.h says how faces lie). Of a staggered frame the rows of the side faces are drawn four times as
// fine, and of each four samples one is taken.
constexpr int fine = int(row_stagger.size());
struct GlFace {
  int x, y, width, height;  // halves of R
  glm::dmat3 clip;          // rows: x, y, w
  int fine_x, fine_y;       // where it stands when it is finer
  bool along_x() const { return width > height; }
  bool is_side() const { return width != height; }
};
constexpr glm::ivec2 target_halves(2, 6), fine_target_halves(2 * fine, 2 + 2 * fine);
// Which of the fine samples of pixel 0 is the row's.
int fine_sample(int row) { return int((row_stagger[std::size_t(row % fine)] + 0.5) * fine); }

const std::array<GlFace, 5>& gl_faces() {
  const auto rows = [](const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& w) {
    return glm::transpose(glm::dmat3(x, y, w));
  };
  static const std::array<GlFace, 5> faces{{
      {0, 0, 2, 2, rows({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0, 0},
      {0, 2, 1, 2, rows({1, 0, -2}, {0, 1, 0}, {1, 0, 0}), 2, 0},
      {1, 2, 1, 2, rows({1, 0, 2}, {0, 1, 0}, {-1, 0, 0}), 3, 0},
      {0, 4, 2, 1, rows({1, 0, 0}, {0, 1, -2}, {0, 1, 0}), 0, 2 * fine},
      {0, 5, 2, 1, rows({1, 0, 0}, {0, 1, 2}, {0, -1, 0}), 0, 2 * fine + 1},
  }};
  return faces;
}

// Pixels of the target.
struct Place {
  int x, y, width, height;
};
Place place_of(const GlFace& face, int half, bool staggered) {
  if (!staggered) return {face.x * half, face.y * half, face.width * half, face.height * half};
  const int finer_x = face.is_side() && face.along_x() ? fine : 1,
            finer_y = face.is_side() && !face.along_x() ? fine : 1;
  return {face.fine_x * half, face.fine_y * half, face.width * half * finer_x, face.height * half * finer_y};
}

// Of the fine samples of a side face those that stand where its rows' do.
void take_rows(const GlFace& face, int half, const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& out) {
  const int width = face.width * half, height = face.height * half;
  out.resize(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int at =
          face.along_x() ? y * fine * width + fine * x + fine_sample(y) : (fine * y + fine_sample(x)) * width + x;
      out[std::size_t(y * width + x)] = from[std::size_t(at)];
    }
}

// Belongs to one context: every call on its thread.
class Drawer {
 public:
  explicit Drawer(std::span<const ItemPolygon> polygons) : polygons_(polygons) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const ItemPolygon& p : polygons)
      for (const glm::dvec3& c : p) low = glm::min(low, c), high = glm::max(high, c);
    if (polygons.empty()) return;
    centre_ = low * 0.5 + high * 0.5;
    const glm::dvec3 half = high - centre_;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) scale_ = 1 / largest;
  }
  void draw(const HemicubeFrame& frame, int resolution, const std::vector<bool>& drawn, ItemFaces& out);
  void release();

 private:
  void make();
  void choose(const std::vector<bool>& drawn);
  void bind_target(const glm::ivec2& size);

  std::span<const ItemPolygon> polygons_;
  glm::dvec3 centre_{0};
  double scale_ = 1;
  std::unique_ptr<Program> program_;
  GLuint array_ = 0, buffers_[3] = {0, 0, 0}, framebuffer_ = 0, renderbuffers_[2] = {0, 0};
  glm::ivec2 size_{0};
  std::vector<std::uint32_t> read_;
  bool zero_to_one_ = false;
  std::vector<bool> drawn_;
  GLsizei indices_ = 0;
};

void Drawer::make() {
  program_ = std::make_unique<Program>(ShaderSource{vertex_shader, fragment_shader}, ShaderFeatures{});
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> items;
  for (std::uint32_t i = 0; i < polygons_.size(); ++i)
    for (const glm::dvec3& c : polygons_[i]) {
      positions.push_back(glm::vec3((c - centre_) * scale_));
      items.push_back(i);
    }
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(3, buffers_);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(positions.size() * sizeof positions[0]), positions.data(), GL_STATIC_DRAW);
  glVertexAttribPointer(position_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(position_attribute);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(items.size() * sizeof items[0]), items.data(), GL_STATIC_DRAW);
  glVertexAttribIPointer(normal_attribute, 1, GL_UNSIGNED_INT, 0, nullptr);
  glEnableVertexAttribArray(normal_attribute);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
  zero_to_one_ = epoxy_has_gl_extension("GL_ARB_clip_control");
  if (zero_to_one_) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  check_gl("hemicube");
}

// Both triangles of the polygons that are above the horizon.
void Drawer::choose(const std::vector<bool>& drawn) {
  if (drawn == drawn_) return;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < polygons_.size(); ++i) {
    if (!drawn[i]) continue;
    for (const std::uint32_t corner : {0u, 1u, 2u}) indices.push_back(4 * i + corner);
    if (polygons_[i][3] == polygons_[i][2]) continue;
    for (const std::uint32_t corner : {0u, 2u, 3u}) indices.push_back(4 * i + corner);
  }
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof indices[0]), indices.data(),
               GL_DYNAMIC_DRAW);
  indices_ = GLsizei(indices.size());
  drawn_ = drawn;
}

void Drawer::bind_target(const glm::ivec2& size) {
  if (size == size_) return;
  if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_), glGenRenderbuffers(2, renderbuffers_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  const auto attach = [&](GLuint buffer, GLenum format, GLenum attachment) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  };
  attach(renderbuffers_[0], GL_R32UI, GL_COLOR_ATTACHMENT0);
  attach(renderbuffers_[1], GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  check_gl("hemicube target");
  size_ = size;
}

void Drawer::draw(const HemicubeFrame& frame, int resolution, const std::vector<bool>& drawn, ItemFaces& out) {
  if (!program_) make();
  choose(drawn);
  const int half = resolution / 2;
  bind_target((frame.staggered ? fine_target_halves : target_halves) * half);
  glDisable(GL_SCISSOR_TEST), glDisable(GL_DITHER), glDisable(GL_BLEND), glDisable(GL_CULL_FACE);
  glFrontFace(GL_CW);  // the cross shows the hemisphere's inside with x to the right: as in a mirror
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  const GLuint background[4] = {no_item, no_item, no_item, no_item};
  const GLfloat farthest = 0;
  glClearBufferuiv(GL_COLOR, 0, background);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  program_->use();
  program_->set("eye", glm::vec3((frame.position - centre_) * scale_));
  program_->set("near", zero_to_one_ ? 1e-6f : 1e-4f);
  program_->set("zero_to_one", zero_to_one_ ? 1.0f : 0.0f);
  const glm::dmat3 to_frame = glm::transpose(glm::dmat3(frame.x, frame.y, frame.z));
  glEnable(GL_SCISSOR_TEST);
  for (const GlFace& face : gl_faces()) {
    const Place at = place_of(face, half, frame.staggered);
    glViewport(at.x, at.y, at.width, at.height);
    glScissor(at.x, at.y, at.width, at.height);
    // The scene is moved against the samples.
    glm::dmat3 beside(1);
    beside[2][0] = -2 * frame.beside_s / (face.width * half), beside[2][1] = -2 * frame.beside_t / (face.height * half);
    program_->set("to_face", glm::mat3(beside * face.clip * to_frame));
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
  }
  for (std::size_t f = 0; f < out.size(); ++f) {
    const GlFace& face = gl_faces()[f];
    const Place at = place_of(face, half, frame.staggered);
    const bool staggered = frame.staggered && face.is_side();
    std::vector<std::uint32_t>& pixels = staggered ? read_ : out[f];
    pixels.resize(std::size_t(at.width) * std::size_t(at.height));
    glReadPixels(at.x, at.y, at.width, at.height, GL_RED_INTEGER, GL_UNSIGNED_INT, pixels.data());
    if (staggered) take_rows(face, half, read_, out[f]);
  }
  check_gl("hemicube");
}

void Drawer::release() {
  if (!program_) return;
  program_->release();
  program_.reset();
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(3, buffers_);
  if (framebuffer_) glDeleteFramebuffers(1, &framebuffer_), glDeleteRenderbuffers(2, renderbuffers_);
}

// A drawer with the thread that its context lives on, which ends first.
struct Threaded {
  Drawer drawer;
  GlThread thread{GlProfile::core};
  explicit Threaded(std::span<const ItemPolygon> polygons) : drawer(polygons) {
    thread.at_exit([this] { drawer.release(); });
  }
};

}  // namespace

MakeDrawItems gl_draw_items() {
  return [](std::span<const ItemPolygon> polygons) -> DrawItems {
    return [threaded = std::make_shared<Threaded>(polygons)](const HemicubeFrame& frame, int resolution,
                                                             const std::vector<bool>& drawn, ItemFaces& out) {
      try {
        threaded->thread.run([&] { threaded->drawer.draw(frame, resolution, drawn, out); });
      } catch (const NoContext& none) {
        throw InputError("radiosity.item_buffer", none.reason, {"software", "software"});
      }
    };
  };
}

}  // namespace cg
