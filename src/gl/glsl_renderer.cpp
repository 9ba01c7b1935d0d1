#include "gl/glsl_renderer.h"

#include "gl/check.h"
#include "shading/clip_position.h"

namespace cg {

namespace {

void set_clamping() { glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE); }

void throw_if_cancelled(const Progress& progress) {
  if (progress.cancelled) throw Cancelled{};
}

}  // namespace

struct GlslRenderer::Item {
  DrawItem drawn;
  EyeMaterial<float> material, changeable;
  LayerUv layers;
  Program* program;
  const GpuSurface* surface;
};

// Everything that may be there from a picture before: programs, buffers, the picture that OpenGL draws into.
std::vector<GlslRenderer::Item> GlslRenderer::prepare(const Scene& scene, const Plan& plan, const View& view,
                                                      PassRecorder& record, Frame& frame) {
  const auto lighting = lighting_in_eye_space<float>(scene, view_matrix(scene.camera));
  const std::vector<DrawItem> list = draw_list(scene, view);
  const FrameTarget::Layers layers{plan.runs("ids"), plan.runs("normals"), plan.runs("samples") ? view.samples : 1};
  const bool target_kept = target_.bind(view.width, view.height, layers);
  record.item("target", target_.bytes().picture, target_kept);
  if (target_.bytes().samples > 0) record.item("samples", target_.bytes().samples, target_kept);
  record.skip();
  std::vector<Item> items;
  bool all_kept = true;
  for (const DrawItem& drawn : list) {
    const Surface& surface = *drawn.surface;
    const auto material = drawn_material<float>(scene, scene.objects[std::size_t(drawn.object)], surface);
    const bool radiosity = optional(!surface.radiosity.empty());
    LayerUv layers;
    if constexpr (!only_plain) layers = drawn_layers(scene, drawn);
    const EyeMaterial<float> possible = changeable(material, layers.layers);
    bool kept = false;
    Program& program =
        programs_.get(shader_features(scene.shading, plan, lighting, possible, radiosity, layer_uses(layers)), &kept);
    items.push_back({drawn, material, possible, std::move(layers), &program, nullptr});
    if constexpr (only_plain) continue;
    const std::string text = program.features().text();
    const auto same = [&](const CodeRun& c) { return c.parts == text; };
    if (std::any_of(frame.code.begin(), frame.code.end(), same)) continue;
    frame.code.push_back({text, program.compile_ms(), kept});
    all_kept = all_kept && kept;
    if constexpr (!only_plain)
      for (const char* id : part_ids(program.features())) record.item(id);
  }
  record.pass("compile", 0, all_kept);
  std::vector<const GpuSurface*> uploaded;
  std::size_t bytes = 0, normal_bytes = 0, radiosity_bytes = 0, uv_bytes = 0;
  all_kept = true;
  for (Item& item : items) {
    const bool normals = item.program->features().has("VERTEX_NORMAL");
    bool kept = false;
    item.surface = &buffers_.get(item.drawn.surface, normals ? UploadedNormals::given : UploadedNormals::none, &kept);
    if (std::find(uploaded.begin(), uploaded.end(), item.surface) != uploaded.end()) continue;
    uploaded.push_back(item.surface);
    bytes += item.surface->bytes, normal_bytes += item.surface->normal_bytes;
    radiosity_bytes += item.surface->radiosity_bytes, uv_bytes += item.surface->uv_bytes;
    all_kept = all_kept && kept;
  }
  record.pass("vertex-upload", bytes, all_kept);
  if (normal_bytes > 0) record.item("normal-buffers", normal_bytes, all_kept);
  if constexpr (!only_plain) {
    record_surfaces(list, all_kept, radiosity_bytes, uv_bytes, record);
    upload_textures(items, record);
  }
  return items;
}

void GlslRenderer::upload_textures(const std::vector<Item>& items, PassRecorder& record) {
  std::vector<std::pair<const TextureImage*, Stored>> pictures;
  std::size_t bytes = 0;
  bool all_kept = true;
  for (const Item& item : items)
    for (const LayerUse& use : item.program->features().layers) {
      const TextureLayer& layer = *item.layers.layers[std::size_t(use.layer)];
      const std::pair picture(layer.texture.get(), stored_for(layer));
      if (std::find(pictures.begin(), pictures.end(), picture) != pictures.end()) continue;
      pictures.push_back(picture);
      bool kept = false;
      textures_.get(layer.texture, &kept, 0, picture.second);
      all_kept = all_kept && kept;
      bytes += texture_bytes(*layer.texture, picture.second);
    }
  if (!pictures.empty()) record.pass("texture-upload", bytes, all_kept);
}

void GlslRenderer::bind_textures(const Item& item) {
  const std::vector<LayerUse>& uses = item.program->features().layers;
  for (int unit = 0; unit < int(uses.size()); ++unit) {
    const TextureLayer& layer = *item.layers.layers[std::size_t(uses[std::size_t(unit)].layer)];
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, textures_.get(layer.texture, nullptr, 0, stored_for(layer)));
    samplers_.bind(unit, layer.sampling);
    item.program->set(unit, layer);
  }
  glActiveTexture(GL_TEXTURE0);
}

void GlslRenderer::draw(const Scene& scene, const View& view, const std::vector<Item>& items, Progress& progress) {
  const auto lighting = lighting_in_eye_space<float>(scene, view_matrix(scene.camera));
  const glm::mat4 to_clip = eye_to_clip(scene, view.width, view.height);
  set_clamping();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  target_.clear(glm::vec3(scene.display.background));
  int drawn = 0;
  for (const Item& item : items) {
    throw_if_cancelled(progress);
    Program& program = *item.program;
    const ShaderFeatures& uses = program.features();
    const glm::mat4& to_eye = item.drawn.surface_to_eye;
    program.use();
    program.set(lighting, item.material, item.changeable);
    if (optional(!uses.layers.empty())) bind_textures(item);
    if (optional(uses.has("ALPHA_TEST"))) program.set("alpha_threshold", float(scene.shading.alpha_threshold));
    program.set("surface_to_clip", surface_to_clip(to_clip, to_eye));
    if (optional(uses.has("EYE_POSITION"))) program.set("surface_to_eye", to_eye);
    if (only_plain || uses.has("NORMAL"))
      program.set("normal_to_eye", normals_to_eye<float>(item.drawn.object_to_eye, scene.shading.normal_length).matrix);
    if (optional(uses.has("NORMALS"))) {
      const glm::dmat4 to_world = matrix(scene.objects[std::size_t(item.drawn.object)].transform);
      program.set("normal_to_world", normals_to_eye<float>(to_world, NormalLength::normalize).matrix);
    }
    ++drawn;
    if (optional(uses.has("IDS"))) program.set("object", drawn);
    glBindVertexArray(item.surface->array);
    item.surface->draw();
    progress.fraction = float(drawn) / float(items.size());
  }
  target_.resolve();
  glFinish();
  throw_if_cancelled(progress);
}

Frame GlslRenderer::render(const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
  throw_if_cancelled(progress);
  PassRecorder record;
  Frame frame = empty_frame(scene, view, record);
  if (!plan.runs("draw")) {
    return finish_empty(std::move(frame), view, record);
  }
  const std::vector<Item> items = prepare(scene, plan, view, record, frame);
  throw_if_cancelled(progress);
  draw(scene, view, items, progress);
  frame.cpu_ms = record.pass("draw");
  target_.read_colour(frame);
  target_.read_depth(frame);
  record.pass("read-back", target_.staging_bytes());
  const bool ids = optional(plan.runs("ids")), normals = optional(plan.runs("normals"));
  if (ids) {
    std::vector<IdSource> drawn;
    for (const Item& item : items) drawn.push_back({item.drawn.object, item.drawn.surface});
    const std::vector<glm::ivec2> read = target_.read_ids(1);
    set_ids(frame, read, drawn);
    record.pass("ids", target_.bytes().ids + bytes_of(read) + id_bytes(frame));
  }
  if (normals) {
    target_.read_normals(frame, ids ? 2 : 1);
    record.pass("normals", target_.bytes().normals + target_.staging_bytes() + bytes_of(frame.normal));
  }
  buffers_.end_frame();
  textures_.end_frame();
  check_gl("gl frame");
  record.finish(frame);
  return frame;
}

void GlslRenderer::release() {
  target_.release();
  buffers_.clear();
  programs_.clear();
  textures_.clear();
  samplers_.clear();
}

}  // namespace cg
