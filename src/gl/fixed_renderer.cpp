#include "gl/fixed_renderer.h"

#include "gl/check.h"
#include "gl/cpu_time.h"
#include "gl/fixed_lighting.h"
#include "gl/gl_plan.h"
#include "params/input_error.h"
#include "shading/clip_position.h"

namespace cg {

namespace {

void throw_if_cancelled(const Progress& progress) {
  if (progress.cancelled) throw Cancelled{};
}

void load_matrices(const glm::mat4& projection, const glm::mat4& modelview) {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(&projection[0].x);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(&modelview[0].x);
}

void bind_positions(const GpuSurface& s) {
  glBindBuffer(GL_ARRAY_BUFFER, s.vertices);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.indices);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
}

void unbind() {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

// Colours are numbers here: no light, no clamping.
void draw_numbers(GLenum shade_model) {
  glDisable(GL_LIGHTING);
  glDisable(GL_COLOR_MATERIAL);
  glShadeModel(shade_model);
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
  glDisableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
}

// Triangle numbers are split so that each half is exact in float.
constexpr std::uint32_t low_bits = 16, low_mask = 0xffff;

// One surface, every vertex of a triangle coloured by its number, in pieces so that little memory is needed.
void draw_numbered(const Surface& surface, int draw_number) {
  constexpr std::size_t piece = 1 << 15;  // triangles
  std::vector<glm::vec3> positions, colours;
  for (std::size_t first = 0; first < surface.triangle_count(); first += piece) {
    const std::size_t end = std::min(first + piece, surface.triangle_count());
    positions.clear();
    colours.clear();
    for (std::size_t t = first; t < end; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        positions.push_back(surface.positions[surface.indices[3 * t + k]]);
        colours.emplace_back(float(draw_number), float(t & low_mask), float(t >> low_bits));
      }
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    glColorPointer(3, GL_FLOAT, 0, colours.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(positions.size()));
  }
}

}  // namespace

Frame FixedRenderer::render(const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
  if (auto why = unsupported_by_fixed_function(scene)) throw InputError("gl-fixed", *why);
  throw_if_cancelled(progress);
  const std::vector<DrawItem> items = draw_list(scene, view);
  const EyeLighting<double> lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  const bool normalize = scene.shading.normal_length == NormalLength::normalize;
  for (const DrawItem& item : items) buffers_.get(item.surface, normalize);
  throw_if_cancelled(progress);

  target_.bind(view.width, view.height, {});
  Frame frame = empty_frame(view);
  const double start = process_cpu_ms();
  target_.clear(glm::vec3(scene.display.background));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisableClientState(GL_COLOR_ARRAY);  // where the frame before was not finished
  send_light_model(scene.shading, plan.runs("two-sides"), plan.runs("local-viewer"));
  std::size_t drawn = 0;
  for (const DrawItem& item : items) {
    throw_if_cancelled(progress);
    draw_lit(item, scene, lighting, projection);
    progress.fraction = float(++drawn) / float(items.size());
  }
  glFinish();
  frame.cpu_ms = process_cpu_ms() - start;
  throw_if_cancelled(progress);
  target_.read_colour(frame);
  target_.read_depth(frame);
  if (plan.runs("ids")) draw_ids(items, projection, frame);
  if (plan.runs("normals")) draw_normals(scene, items, projection, frame);
  buffers_.end_frame();
  check_gl("gl-fixed frame");
  return frame;
}

void FixedRenderer::draw_lit(const DrawItem& item, const Scene& scene, const EyeLighting<double>& lighting,
                             const glm::mat4& projection) {
  const double unit = eye_unit(glm::dmat4(item.surface_to_eye), item.surface->radius, scene.shading.normal_length);
  send_lights(scene, lighting, unit);
  send_material(*item.material, scene.shading.color_material, lighting);
  load_matrices(projection_in_unit(projection, unit), modelview_in_unit(item.surface_to_eye, unit));
  const GpuSurface& surface = buffers_.get(item.surface, scene.shading.normal_length == NormalLength::normalize);
  bind_positions(surface);
  glEnableClientState(GL_NORMAL_ARRAY);
  glNormalPointer(GL_FLOAT, 0, surface.normal_offset());
  surface.draw();
  glDisableClientState(GL_NORMAL_ARRAY);
  unbind();
}

void FixedRenderer::draw_ids(const std::vector<DrawItem>& items, const glm::mat4& projection, Frame& frame) {
  target_.clear(glm::vec3(0));
  draw_numbers(GL_FLAT);
  std::vector<IdSource> drawn;
  unbind();
  glEnableClientState(GL_VERTEX_ARRAY);
  for (const DrawItem& item : items) {
    drawn.push_back({item.object, item.surface});
    load_matrices(projection, item.surface_to_eye);
    draw_numbered(*item.surface, int(drawn.size()));
  }
  glDisableClientState(GL_COLOR_ARRAY);
  std::vector<glm::ivec2> ids;
  for (const glm::vec4& p : target_.read_floats(0))
    ids.emplace_back(int(p.r), int((std::uint32_t(p.b) << low_bits) | std::uint32_t(p.g)));
  set_ids(frame, ids, drawn);
}

void FixedRenderer::draw_normals(const Scene& scene, const std::vector<DrawItem>& items, const glm::mat4& projection,
                                 Frame& frame) {
  target_.clear(glm::vec3(0));
  draw_numbers(GL_SMOOTH);
  for (const DrawItem& item : items) {
    const glm::dmat4 to_world = matrix(scene.objects[std::size_t(item.object)].transform);
    const glm::mat3 normals = normals_to_eye<float>(to_world, NormalLength::normalize).matrix;
    std::vector<glm::vec3> colours;
    colours.reserve(item.surface->normals.size());
    for (const glm::vec3& n : item.surface->normals) colours.push_back(normals * n);
    load_matrices(projection, item.surface_to_eye);
    const GpuSurface& surface = buffers_.get(item.surface, scene.shading.normal_length == NormalLength::normalize);
    bind_positions(surface);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glColorPointer(3, GL_FLOAT, 0, colours.data());
    surface.draw();
  }
  glDisableClientState(GL_COLOR_ARRAY);
  unbind();
  target_.read_normals(frame, 0);
}

void FixedRenderer::release() {
  target_.release();
  buffers_.clear();
}

}  // namespace cg
