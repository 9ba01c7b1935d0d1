#include "gl/fixed_renderer.h"

#include "gl/check.h"
#include "gl/fixed_by_hand.h"
#include "gl/fixed_extremes.h"
#include "gl/gl_plan.h"
#include "params/input_error.h"
#include "scene/cpu_clock.h"
#include "shading/clip_position.h"
#include "shading/fixed_function_scene.h"

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

struct FixedRenderer::Picture {
  const Scene& scene;
  const Plan& plan;
  Progress& progress;
  std::vector<GlCall> calls;
  std::vector<DrawItem> items;
  EyeLighting<double> lighting;
  double aspect;
  MeshBody body;
  bool as_listed;  // the lights
};

Frame FixedRenderer::render(const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
  if (auto why = unsupported_by_fixed_function(scene)) throw InputError("gl-fixed", *why);
  throw_if_cancelled(progress);
  Picture picture{scene, plan, progress, gl_calls(scene), draw_list(scene, view), {}, {}, {}, {}};
  picture.lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  picture.aspect = double(view.width) / double(view.height);
  picture.body = mesh_body(picture.calls);
  picture.as_listed = lights_as_listed(scene, picture.lighting, picture.items);
  const bool normalize = scene.shading.normal_length == NormalLength::normalize;
  for (const DrawItem& item : picture.items) buffers_.get(item.surface, normalize);
  throw_if_cancelled(progress);

  target_.bind(view.width, view.height, {});
  Frame frame = empty_frame(view);
  draw(picture, frame);
  if (frame.nan_pixels > 0 && picture.as_listed) {
    // A light in a vertex: no direction of OpenGL's. Relative to the eye both are rounded, each on its own.
    picture.as_listed = false;
    frame = empty_frame(view);
    draw(picture, frame);
  }
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  if (plan.runs("ids")) draw_ids(picture.items, projection, frame);
  if (plan.runs("normals")) draw_normals(scene, picture.items, projection, frame);
  buffers_.end_frame();
  check_gl("gl-fixed frame");
  return frame;
}

void FixedRenderer::draw(const Picture& picture, Frame& frame) {
  const double start = process_cpu_ms();
  FixedPlayer player(picture.aspect);
  glDisableClientState(GL_COLOR_ARRAY);  // where the frame before was not finished
  std::size_t drawn = 0;
  for (const GlCall& call : picture.calls) {
    play(call, picture, player);
    if (call.section != GlSection::draw) continue;
    picture.progress.fraction = std::min(float(++drawn) / float(picture.items.size()), 1.0f);
  }
  glFinish();
  frame.cpu_ms = process_cpu_ms() - start;
  throw_if_cancelled(picture.progress);
  target_.read_colour(frame);
  target_.read_depth(frame);
}

void FixedRenderer::play(const GlCall& call, const Picture& picture, FixedPlayer& player) {
  const Plan& plan = picture.plan;
  if (call.function == "glClear") return target_.clear(player.clear_colour());
  if (call.section == GlSection::lights && !picture.as_listed) return;
  if (call.path == "shading.local_viewer" && !plan.runs("local-viewer")) return;
  if (call.path == "shading.two_sided" && !plan.runs("two-sides")) return;
  player.play(call);
  if (call.section != GlSection::draw) return;
  for (const DrawItem& item : picture.items) {
    if (item.object != call.object) continue;
    throw_if_cancelled(picture.progress);
    draw_mesh(item, picture, player);
  }
}

void FixedRenderer::draw_mesh(const DrawItem& item, const Picture& picture, const FixedPlayer& player) {
  const Scene& scene = picture.scene;
  double unit = 1;
  if (!picture.as_listed) {
    unit = eye_unit(glm::dmat4(item.surface_to_eye), item.surface->radius, scene.shading.normal_length);
    const Scene mistaken = with_mistaken_lights(scene);
    send_lights_from_eye(mistaken, lighting_in_eye_space<double>(mistaken, view_matrix(mistaken.camera)), unit);
  }
  send_emission_of_nan(eye_material<double>(*item.material, scene.shading.color_material), picture.lighting);
  const glm::mat4 modelview(player.view() * player.object() * item.surface->to_mesh());
  load_matrices(projection_in_unit(glm::mat4(player.projection()), unit), modelview_in_unit(modelview, unit));
  draw_arrays(item, picture);
}

void FixedRenderer::draw_arrays(const DrawItem& item, const Picture& picture) {
  const bool normalize = picture.scene.shading.normal_length == NormalLength::normalize;
  const MeshBody& body = picture.body;
  std::vector<glm::vec3> own;  // what the mistakes make of the normals
  if (body.by_hand)
    own = colours_by_hand(*item.surface, body.normals, picture.scene.mistakes);
  else if (body.normals == MeshBody::Normals::flipped)
    for (const glm::vec3& n : item.surface->normals) own.push_back(-n);
  const GpuSurface& surface = buffers_.get(item.surface, normalize);
  bind_positions(surface);
  if (!own.empty()) glBindBuffer(GL_ARRAY_BUFFER, 0);
  if (body.by_hand) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, 0, own.data());
  } else if (body.normals == MeshBody::Normals::none) {
    glNormal3f(0, 0, 1);
  } else {
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, 0, own.empty() ? surface.normal_offset() : own.data());
  }
  surface.draw();
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
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
