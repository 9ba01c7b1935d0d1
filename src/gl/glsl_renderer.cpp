#include "gl/glsl_renderer.h"

#include "gl/check.h"
#include "scene/cpu_clock.h"
#include "shading/clip_position.h"

namespace cg {

namespace {

void set_clamping() { glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE); }

void throw_if_cancelled(const Progress& progress) {
  if (progress.cancelled) throw Cancelled{};
}

}  // namespace

Frame GlslRenderer::render(const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
  throw_if_cancelled(progress);
  const std::vector<DrawItem> items = draw_list(scene, view);
  const glm::dmat4 world_to_eye = view_matrix(scene.camera);
  const EyeLighting<float> lighting = lighting_in_eye_space<float>(scene, world_to_eye);
  const EyeLighting<double> exact = lighting_in_eye_space<double>(scene, world_to_eye);
  const glm::mat4 to_clip = eye_to_clip(scene, view.width, view.height);
  const bool ids = plan.runs("ids"), normals = plan.runs("normals");
  throw_if_cancelled(progress);

  target_.bind(view.width, view.height, {ids, normals, view.samples});
  Frame frame = empty_frame(view);
  for (const DrawItem& item : items) buffers_.get(item.surface);
  const double start = process_cpu_ms();
  set_clamping();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  target_.clear(glm::vec3(scene.display.background));
  std::vector<IdSource> drawn;
  for (const DrawItem& item : items) {
    throw_if_cancelled(progress);
    const auto tracked = scene.shading.color_material;
    Program& program =
        programs_.get(shader_features(scene.shading, plan, exact, eye_material<double>(*item.material, tracked)));
    program.use();
    program.set(lighting);
    program.set(eye_material<float>(*item.material, tracked));
    program.set("surface_to_clip", surface_to_clip(to_clip, item.surface_to_eye));
    program.set("surface_to_eye", item.surface_to_eye);
    program.set("normal_to_eye", normals_to_eye<float>(item.object_to_eye, scene.shading.normal_length).matrix);
    if (normals) {
      const glm::dmat4 to_world = matrix(scene.objects[std::size_t(item.object)].transform);
      program.set("normal_to_world", normals_to_eye<float>(to_world, NormalLength::normalize).matrix);
    }
    drawn.push_back({item.object, item.surface});
    if (ids) program.set("object", int(drawn.size()));
    const GpuSurface& surface = buffers_.get(item.surface);
    glBindVertexArray(surface.array);
    surface.draw();
    progress.fraction = float(drawn.size()) / float(items.size());
  }
  target_.resolve();
  glFinish();
  frame.cpu_ms = process_cpu_ms() - start;
  throw_if_cancelled(progress);
  target_.read_colour(frame);
  target_.read_depth(frame);
  if (ids) set_ids(frame, target_.read_ids(1), drawn);
  if (normals) target_.read_normals(frame, ids ? 2 : 1);
  buffers_.end_frame();
  check_gl("gl frame");
  return frame;
}

void GlslRenderer::release() {
  target_.release();
  buffers_.clear();
  programs_.clear();
}

}  // namespace cg
