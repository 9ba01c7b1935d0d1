#include "ui/overlay_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>

namespace cg {

namespace {

const char* const vertex_source = R"(#version 330 core
layout(location = 0) in vec3 point;
uniform mat4 to_clip;
void main() { gl_Position = to_clip * vec4(point, 1.0); }
)";

// A line becomes a strip as wide as it is asked to be: core profiles need not draw wide lines.
const char* const geometry_source = R"(#version 330 core
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
uniform vec2 size;       // of the picture, pixels
uniform float half_width;  // pixels, with half a pixel to fade
noperspective out float across;

void emit(vec4 p, vec2 normal, float side) {
  across = side * half_width;
  gl_Position = vec4(p.xy + side * half_width * normal * 2.0 / size * p.w, p.zw);
  EmitVertex();
}

void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  float da = a.z + a.w, db = b.z + b.w;  // distances before the near plane
  if (da <= 0.0 && db <= 0.0) return;
  if (da < 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0) b = mix(b, a, db / (db - da));
  if (a.w <= 0.0 || b.w <= 0.0) return;
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  float length_ = length(along);
  if (length_ < 1e-6) return;
  vec2 normal = vec2(-along.y, along.x) / length_;
  emit(a, normal, -1.0);
  emit(a, normal, 1.0);
  emit(b, normal, -1.0);
  emit(b, normal, 1.0);
  EndPrimitive();
}
)";

const char* const fragment_source = R"(#version 330 core
uniform vec4 viewport;
uniform vec4 colour;
uniform float hidden;
uniform float half_width;
uniform vec2 planes;       // near, far
uniform bool perspective;
uniform bool has_depth;
uniform float tolerance;   // metres before the picture's surface that still count as on it
uniform sampler2D depth;
noperspective in float across;
out vec4 result;

float metres(float window_depth) {
  float n = planes.x, f = planes.y;
  return perspective ? n * f / (f - window_depth * (f - n)) : n + window_depth * (f - n);
}

void main() {
  float alpha = colour.a * clamp(half_width - abs(across), 0.0, 1.0);
  if (has_depth) {
    vec2 uv = (gl_FragCoord.xy - viewport.xy) / viewport.zw;
    float surface = metres(texture(depth, vec2(uv.x, 1.0 - uv.y)).r);
    if (metres(gl_FragCoord.z) > surface + tolerance) alpha *= hidden;
  }
  result = vec4(colour.rgb, alpha);
}
)";

unsigned compile(unsigned kind, const char* source) {
  const unsigned shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

unsigned line_program() {
  const unsigned program = glCreateProgram();
  for (const auto& [kind, source] : {std::pair<unsigned, const char*>{GL_VERTEX_SHADER, vertex_source},
                                     {GL_GEOMETRY_SHADER, geometry_source},
                                     {GL_FRAGMENT_SHADER, fragment_source}}) {
    const unsigned shader = compile(kind, source);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // goes with the program
  }
  glLinkProgram(program);
  int linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  char log[1024] = "";
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  std::fprintf(stderr, "shadebench: lines cannot be drawn: %s\n", log);
  glDeleteProgram(program);
  return 0;
}

unsigned line_array(unsigned buffer) {
  unsigned array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  return array;
}

}  // namespace

LineTarget line_target(const Place& p, const std::array<float, 4>& clip) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 scale = io.DisplayFramebufferScale;
  const float w = float(p.screen_width() * p.region.factor), h = float(p.screen_height() * p.region.factor);
  const float x = p.low.x - float(p.region.low.x) * w, y = p.low.y - float(p.region.low.y) * h;
  const auto up = [&](float screen_y) { return io.DisplaySize.y - screen_y; };
  LineTarget target;
  target.viewport = {x * scale.x, up(y + h) * scale.y, w * scale.x, h * scale.y};
  target.clip = {int(clip[0] * scale.x), int(up(clip[3]) * scale.y), int((clip[2] - clip[0]) * scale.x),
                 int((clip[3] - clip[1]) * scale.y)};
  return target;
}

OverlayRenderer::~OverlayRenderer() {
  if (!program_) return;
  glDeleteProgram(program_);
  const unsigned buffers[2] = {kept_buffer_, more_buffer_}, arrays[2] = {kept_array_, more_array_};
  glDeleteBuffers(2, buffers);
  glDeleteVertexArrays(2, arrays);
}

void OverlayRenderer::keep(std::vector<Lines> lines) {
  waiting_ = std::move(lines);
  changed_ = true;
}

void OverlayRenderer::prepare() {
  if (program_ || failed_) return;
  program_ = line_program();
  failed_ = !program_;
  if (failed_) return;
  unsigned buffers[2];
  glGenBuffers(2, buffers);
  kept_buffer_ = buffers[0], more_buffer_ = buffers[1];
  kept_array_ = line_array(kept_buffer_), more_array_ = line_array(more_buffer_);
}

std::vector<OverlayRenderer::Range> OverlayRenderer::upload(unsigned buffer, std::span<const Lines> lines,
                                                            unsigned usage) {
  std::vector<Range> ranges;
  std::size_t total = 0;
  for (const Lines& l : lines) total += l.points.size();
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(total * sizeof(glm::vec3)), nullptr, usage);
  std::size_t first = 0;
  for (const Lines& l : lines) {
    if (l.points.empty()) continue;
    glBufferSubData(GL_ARRAY_BUFFER, GLintptr(first * sizeof(glm::vec3)),
                    GLsizeiptr(l.points.size() * sizeof(glm::vec3)), l.points.data());
    ranges.push_back({l.mark, l.origin, int(first), int(l.points.size())});
    first += l.points.size();
  }
  return ranges;
}

void OverlayRenderer::draw_ranges(unsigned vertices, std::span<const Range> ranges, const Camera& camera,
                                  const LineTarget& target, const std::function<LineStyle(Mark)>& style) {
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  const glm::dmat4 to_clip =
      projection_matrix(camera, double(target.viewport.z) / double(target.viewport.w)) * view_matrix(camera);
  glBindVertexArray(vertices);
  for (const Range& r : ranges) {
    const glm::mat4 m(to_clip * translation(r.origin));
    const LineStyle s = style(r.mark);
    glUniformMatrix4fv(at("to_clip"), 1, GL_FALSE, &m[0][0]);
    glUniform4fv(at("colour"), 1, &s.colour[0]);
    glUniform1f(at("hidden"), s.hidden);
    glUniform1f(at("half_width"), s.width / 2 + 0.5f);
    glDrawArrays(GL_LINES, r.first, r.count);
  }
}

void OverlayRenderer::draw(std::span<const Lines> more, const Camera& camera, const LineTarget& target,
                           const Texture& depth, const std::function<LineStyle(Mark)>& style) {
  prepare();
  if (failed_ || target.viewport.z < 1 || target.viewport.w < 1 || target.clip[2] < 1 || target.clip[3] < 1) return;
  if (changed_) {
    kept_ = upload(kept_buffer_, waiting_, GL_STATIC_DRAW);
    waiting_.clear(), waiting_.shrink_to_fit();
    changed_ = false;
  }
  const std::vector<Range> ranges = upload(more_buffer_, more, GL_STREAM_DRAW);
  glUseProgram(program_);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST), glDisable(GL_CULL_FACE);
  const glm::vec4& v = target.viewport;
  glViewport(int(v.x), int(v.y), int(v.z), int(v.w));
  glEnable(GL_SCISSOR_TEST);
  glScissor(target.clip[0], target.clip[1], target.clip[2], target.clip[3]);
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniform2f(at("size"), v.z, v.w);
  glUniform4f(at("viewport"), v.x, v.y, v.z, v.w);
  glUniform2f(at("planes"), float(camera.near_plane), float(camera.far_plane));
  glUniform1i(at("perspective"), camera.projection == Projection::perspective);
  glUniform1i(at("has_depth"), !depth.empty());
  glUniform1f(at("tolerance"), 0.004f * float(glm::length(camera.target - camera.position)));
  glUniform1i(at("depth"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depth.name());
  draw_ranges(kept_array_, kept_, camera, target, style);
  draw_ranges(more_array_, ranges, camera, target, style);
  glBindVertexArray(0);
}

}  // namespace cg
