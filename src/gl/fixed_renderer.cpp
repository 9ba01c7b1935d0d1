#include "gl/fixed_renderer.h"

#include <cfloat>
#include <cmath>

#include "gl/check.h"
#include "gl/fixed_by_hand.h"
#include "gl/fixed_extremes.h"
#include "gl/fixed_numbers.h"
#include "gl/fixed_state.h"
#include "gl/gl_plan.h"
#include "params/input_error.h"
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
  glBindBuffer(GL_ARRAY_BUFFER, s.positions);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.indices);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
}

void unbind() {
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

// The uv of each texture unit, from the buffer with all of them.
void point_at_uv(const Scene& scene, const DrawItem& item, const GpuSurface& surface) {
  const LayerUv uv = drawn_layers(scene, item, DrawnBy::fixed_function);
  const auto stride = GLsizei(uv.sets.size() * sizeof(glm::vec2));
  int unit = 0;
  glBindBuffer(GL_ARRAY_BUFFER, surface.uv);
  for (std::size_t i = 0; i < uv.layers.size() && unit < gl_texture_unit_limit; ++i) {
    if (uv.layers[i]->target != LayerTarget::colour) continue;
    glClientActiveTexture(GLenum(GL_TEXTURE0 + unit++));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(2, GL_FLOAT, stride,
                      reinterpret_cast<const void*>(std::size_t(uv.set_of_layer[i]) * sizeof(glm::vec2)));
  }
}

void forget_uv() {
  for (int unit = gl_texture_unit_limit - 1; unit >= 0; --unit) {
    glClientActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
}

// What stands before the radiosity of an object's vertices in the sum; where it is NaN, what makes OpenGL's sum black
// as the other techniques' is.
glm::vec3 emission_of(const Scene& scene, const DrawItem& item) {
  const Object& object = scene.objects[std::size_t(item.object)];
  glm::vec3 emission = drawn_material<float>(scene, object, *item.surface).emission;
  for (int c = 0; c < 3; ++c)
    if (std::isnan(emission[c]) && scene.shading.clamp) emission[c] = -FLT_MAX;
  return emission;
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
  UploadedNormals normals;
  bool as_listed;  // the lights
  PassRecorder& record;
  std::size_t by_hand_bytes = 0;  // the most of an object
  bool state_recorded = false;    // since the last call that changed it
  struct Matrices {
    glm::mat4 projection, modelview;
  };
  std::vector<Matrices> matrices = {};  // that each item was drawn with
};

Frame FixedRenderer::render(const Scene& scene, const Plan& plan, const View& view, Progress& progress) {
  if (auto why = unsupported_by_fixed_function(scene)) throw InputError("gl-fixed", *why);
  throw_if_cancelled(progress);
  PassRecorder record;
  Frame frame = empty_frame(scene, view, record);
  if (!plan.runs("draw")) {
    return finish_empty(std::move(frame), view, record);
  }
  Picture picture{scene, plan, progress, gl_calls(scene), draw_list(scene, view, DrawnBy::fixed_function), {}, {},
                  {},    {},   {},       record};
  picture.lighting = lighting_in_eye_space<double>(scene, view_matrix(scene.camera));
  picture.aspect = double(view.width) / double(view.height);
  picture.body = mesh_body(picture.calls);
  picture.as_listed = lights_as_listed(scene, picture.lighting, picture.items);
  picture.normals = !plan.runs("normal-buffers")                             ? UploadedNormals::none
                    : scene.shading.normal_length == NormalLength::normalize ? UploadedNormals::within_float
                                                                             : UploadedNormals::given;
  upload(picture);
  throw_if_cancelled(progress);

  const bool target_kept = target_.bind(view.width, view.height, {});
  record.item("target", target_.bytes().picture, target_kept);
  record.skip();
  draw(picture, frame);
  if (frame.nan_pixels > 0 && picture.as_listed) {
    // A light in a vertex: no direction of OpenGL's. Relative to the eye both are rounded, each on its own.
    picture.as_listed = false;
    PassRecorder unrecorded;
    frame = empty_frame(scene, view, unrecorded);
    draw(picture, frame);
  }
  if (picture.by_hand_bytes > 0) record.item("by-hand", picture.by_hand_bytes);
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  if (plan.runs("texture-upload")) reset_texture_units();
  if (plan.runs("ids")) draw_ids(picture, projection, frame);
  if (plan.runs("normals")) draw_normals(picture, projection, frame);
  buffers_.end_frame();
  textures_.end_frame();
  check_gl("gl-fixed frame");
  record.finish(frame);
  return frame;
}

// The vertices, where they are not there from a picture before.
void FixedRenderer::upload(const Picture& picture) {
  std::vector<const GpuSurface*> all;
  std::size_t bytes = 0, normal_bytes = 0, radiosity_bytes = 0, uv_bytes = 0;
  bool all_kept = true;
  picture.record.skip();
  for (const DrawItem& item : picture.items) {
    bool kept = false;
    const GpuSurface& s = buffers_.get(item.surface, picture.normals, &kept);
    if (s.radiosity) buffers_.get_with_emission(item.surface, picture.normals, emission_of(picture.scene, item));
    if (std::find(all.begin(), all.end(), &s) != all.end()) continue;
    all.push_back(&s);
    bytes += s.bytes, normal_bytes += s.normal_bytes, radiosity_bytes += s.radiosity_bytes;
    uv_bytes += s.uv_bytes;
    all_kept = all_kept && kept;
  }
  picture.record.pass("vertex-upload", bytes, all_kept);
  if (normal_bytes > 0) picture.record.item("normal-buffers", normal_bytes, all_kept);
  record_surfaces(picture.items, all_kept, radiosity_bytes, uv_bytes, picture.record);
  upload_textures(picture);
}

namespace {

const TextureLayer& layer_of(const GlCall& call, const Scene& scene) {
  return material_of(scene, scene.objects[std::size_t(call.object)]).layers[std::size_t(call.layer)];
}

}  // namespace

void FixedRenderer::upload_textures(const Picture& picture) {
  std::vector<std::pair<const TextureImage*, int>> names;
  std::size_t bytes = 0;
  bool all_kept = true;
  for (const GlCall& call : picture.calls) {
    if (call.function != "glBindTexture") continue;
    const TextureHandle& image = layer_of(call, picture.scene).texture;
    const std::pair name(image.get(), call.layer);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.push_back(name);
    bool kept = false;
    textures_.get(image, &kept, call.layer);
    all_kept = all_kept && kept;
    bytes += texture_bytes(*image);
  }
  if (!names.empty()) picture.record.pass("texture-upload", bytes, all_kept);
}

// The parameters that the list does not say are OpenGL's own.
void FixedRenderer::bind_texture(const GlCall& call, const Picture& picture) {
  glBindTexture(GL_TEXTURE_2D, textures_.get(layer_of(call, picture.scene).texture, nullptr, call.layer));
  set_sampling(GL_TEXTURE_2D, Sampling{.min_filter = MinFilter::nearest_mipmap_linear});
}

void FixedRenderer::draw(Picture& picture, Frame& frame) {
  FixedPlayer player(picture.aspect);
  glDisableClientState(GL_COLOR_ARRAY);  // where the frame before was not finished
  picture.state_recorded = false;
  std::size_t drawn = 0;
  for (const GlCall& call : picture.calls) {
    play(call, picture, player);
    if (call.section != GlSection::draw) continue;
    picture.progress.fraction = std::min(float(++drawn) / float(picture.items.size()), 1.0f);
  }
  glFinish();
  frame.cpu_ms = picture.record.pass("draw");
  throw_if_cancelled(picture.progress);
  target_.read_colour(frame);
  target_.read_depth(frame);
  picture.record.pass("read-back", target_.staging_bytes());
}

void FixedRenderer::play(const GlCall& call, Picture& picture, FixedPlayer& player) {
  const Plan& plan = picture.plan;
  if (call.function == "glClear") return target_.clear(player.clear_colour());
  if (call.section == GlSection::lights && !picture.as_listed) return;
  if (call.path == "shading.local_viewer" && !plan.runs("local-viewer")) return;
  if (call.path == "shading.two_sided" && !plan.runs("two-sides")) return;
  if (call.function == "glBindTexture") bind_texture(call, picture);
  player.play(call);
  if (call.section != GlSection::draw && call.section != GlSection::transform) picture.state_recorded = false;
  if (call.section != GlSection::draw) return;
  for (const DrawItem& item : picture.items) {
    if (item.object != call.object) continue;
    throw_if_cancelled(picture.progress);
    draw_mesh(item, picture, player);
  }
}

void FixedRenderer::draw_mesh(const DrawItem& item, Picture& picture, const FixedPlayer& player) {
  const Scene& scene = picture.scene;
  double unit = 1;
  if (!picture.as_listed) {
    unit = eye_unit(glm::dmat4(item.surface_to_eye), item.surface->radius, scene.shading.normal_length);
    const Scene mistaken = with_mistaken_lights(scene);
    send_lights_from_eye(mistaken, lighting_in_eye_space<double>(mistaken, view_matrix(mistaken.camera)), unit);
  }
  if (item.surface->radiosity.empty()) {
    send_emission_of_nan(eye_material<double>(*item.material, scene.shading.color_material), picture.lighting);
  } else {
    const glm::vec3 emission = emission_of(scene, item);  // of a vertex without light
    glColor3fv(&emission.x);
  }
  const glm::mat4 modelview(player.view() * player.object() * item.surface->to_mesh());
  picture.matrices.resize(picture.items.size());
  Picture::Matrices& m = picture.matrices[std::size_t(&item - picture.items.data())];
  m = {projection_in_unit(glm::mat4(player.projection()), unit), modelview_in_unit(modelview, unit)};
  load_matrices(m.projection, m.modelview);
  if (!picture.state_recorded || !picture.as_listed) record_fixed_state(picture.record);
  picture.state_recorded = true;
  draw_arrays(item, picture);
}

void FixedRenderer::draw_arrays(const DrawItem& item, Picture& picture) {
  const MeshBody& body = picture.body;
  std::vector<glm::vec3> own;  // what the mistakes make of the normals
  if (body.by_hand) {
    own = colours_by_hand(*item.surface, body.normals, picture.scene.mistakes);
  } else if (body.normals == MeshBody::Normals::flipped) {
    own.reserve(item.surface->normals.size());
    for (const glm::vec3& n : item.surface->normals) own.push_back(-n);
  }
  picture.by_hand_bytes = std::max(picture.by_hand_bytes, bytes_of(own));
  const GpuSurface& surface = buffers_.get(item.surface, picture.normals);
  bind_positions(surface);
  if (body.radiosity && surface.radiosity) {
    glBindBuffer(GL_ARRAY_BUFFER, surface.radiosity);
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, 0, nullptr);
  }
  glBindBuffer(GL_ARRAY_BUFFER, own.empty() ? surface.normals : 0);
  if (body.by_hand) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, 0, own.data());
  } else if (own.empty() && !surface.normals) {
    glNormal3f(0, 0, 1);
  } else {
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, 0, own.empty() ? nullptr : own.data());
  }
  if (surface.uv) point_at_uv(picture.scene, item, surface);
  surface.draw();
  if (surface.uv) forget_uv();
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
  unbind();
}

// Draws once more what was drawn, without texture: where alpha was tested only what is there, which has its depth.
void FixedRenderer::draw_again(const Picture& picture, const glm::mat4& projection,
                               const std::function<void(const DrawItem&)>& draw) {
  const bool holes = picture.plan.runs("alpha-test");
  if (holes) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthFunc(GL_EQUAL);
  } else {
    target_.clear(glm::vec3(0));
  }
  for (std::size_t i = 0; i < picture.items.size(); ++i) {
    if (holes)
      load_matrices(picture.matrices[i].projection, picture.matrices[i].modelview);
    else
      load_matrices(projection, picture.items[i].surface_to_eye);
    draw(picture.items[i]);
  }
}

void FixedRenderer::draw_ids(const Picture& picture, const glm::mat4& projection, Frame& frame) {
  draw_numbers(GL_FLAT);
  std::vector<IdSource> drawn;
  unbind();
  glEnableClientState(GL_VERTEX_ARRAY);
  std::size_t bytes = 0;  // the most of an object
  draw_again(picture, projection, [&](const DrawItem& item) {
    drawn.push_back({item.object, item.surface});
    bytes = std::max(bytes, draw_numbered(*item.surface, int(drawn.size())));
  });
  glDisableClientState(GL_COLOR_ARRAY);
  const std::vector<glm::vec4> read = target_.read_floats(0);
  std::vector<glm::ivec2> ids;
  ids.reserve(read.size());
  for (const glm::vec4& p : read) ids.emplace_back(int(p.r), int(numbered_triangle(p.g, p.b)));
  set_ids(frame, ids, drawn);
  picture.record.pass("ids", bytes + bytes_of(read) + bytes_of(ids) + id_bytes(frame));
}

void FixedRenderer::draw_normals(const Picture& picture, const glm::mat4& projection, Frame& frame) {
  draw_numbers(GL_SMOOTH);
  std::size_t bytes = 0;  // the most of an object
  draw_again(picture, projection, [&](const DrawItem& item) {
    const glm::dmat4 to_world = matrix(picture.scene.objects[std::size_t(item.object)].transform);
    const glm::mat3 normals = normals_to_eye<float>(to_world, NormalLength::normalize).matrix;
    std::vector<glm::vec3> colours;
    colours.reserve(item.surface->normals.size());
    for (const glm::vec3& n : item.surface->normals) colours.push_back(normals * n);
    bytes = std::max(bytes, bytes_of(colours));
    const GpuSurface& surface = buffers_.get(item.surface, picture.normals);
    bind_positions(surface);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glColorPointer(3, GL_FLOAT, 0, colours.data());
    surface.draw();
  });
  glDisableClientState(GL_COLOR_ARRAY);
  unbind();
  target_.read_normals(frame, 0);
  picture.record.pass("normals", bytes + target_.staging_bytes() + bytes_of(frame.normal));
}

void FixedRenderer::release() {
  target_.release();
  buffers_.clear();
  textures_.clear();
}

}  // namespace cg
