#include "raster/software.h"

#include <mutex>
#include <string>

#include "params/input_error.h"
#include "raster/alpha_test.h"
#include "raster/frame_layers.h"
#include "raster/pixel_shading.h"
#include "raster/software_plan.h"
#include "raster/software_trace.h"
#include "raster/texel_lanes.h"
#include "shading/ambient_term.h"
#include "shading/layer_uv.h"

namespace cg {

namespace {

// Buffers that are kept from picture to picture, so that a frame does not begin by asking for memory.
struct Buffers {
  Drawing drawing;
  VisibilityBuffer visibility;
  ThreadsMemory threads;
  DeferredShading<float> float_shading;
  DeferredShading<double> double_shading;
  template <class Real>
  DeferredShading<Real>& shading() {
    if constexpr (sizeof(Real) == sizeof(float))
      return float_shading;
    else
      return double_shading;
  }
  template <class Real>
  void keep_only() {
    if constexpr (sizeof(Real) == sizeof(float))
      double_shading = {};
    else
      float_shading = {};
  }
};

class BufferPool {
 public:
  std::unique_ptr<Buffers> take() {
    const std::lock_guard lock(mutex_);
    if (!kept_) return std::make_unique<Buffers>();
    return std::move(kept_);
  }
  void give(std::unique_ptr<Buffers> buffers) {
    const std::lock_guard lock(mutex_);
    kept_ = std::move(buffers);
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<Buffers> kept_;
};

// A picture beyond this would take gigabytes before its first pixel is drawn.
constexpr std::size_t most_pixels = std::size_t(16384) * 16384;

void refuse_beyond_limits(const View& view) {
  if (view.width <= 0 || view.height <= 0 || std::size_t(view.width) * std::size_t(view.height) <= most_pixels) return;
  const std::string size = std::to_string(view.width) + "x" + std::to_string(view.height);
  throw InputError("size", {"a picture of " + size + " is too large", size + " の画像は大きすぎます"},
                   Words{"at most as many pixels as 16384x16384", "16384x16384 の画素数以下にしてください"});
}

// The picture itself, of the view's size. Where something is drawn, shade_pixels() writes all of it.
Frame make_frame(const Scene& scene, const Plan& plan, const View& view, PassRecorder& record) {
  Frame f;
  const int w = std::max(view.width, 0), h = std::max(view.height, 0);
  if (plan.runs("transform")) {
    f.colour = ColourImage::unwritten(w, h);
    f.depth = Image<float>::unwritten(w, h);
    f.covered = Image<std::uint8_t>::unwritten(w, h);
  } else {
    f.colour = ColourImage(w, h, glm::vec3(scene.display.background));
    f.depth = Image<float>(w, h, 1.0f);
    f.covered = Image<std::uint8_t>(w, h);
  }
  if (!f.colour.empty()) record.item("picture", bytes_of(f.colour) + bytes_of(f.depth) + bytes_of(f.covered));
  return f;
}

// Which triangle each pixel shows: transform, clip, visibility. Kept where it is the same as in the picture before.
void find_geometry(const Scene& scene, const Plan& plan, const View& view, Workers& workers, PassRecorder& record,
                   Buffers& buffers) {
  Drawing& drawing = buffers.drawing;
  VisibilityBuffer& visibility = buffers.visibility;
  const bool same_size = visibility.width == view.width && visibility.height == view.height;
  const bool kept = optional(gather_objects(scene, view, workers, drawing) && same_size && view.reuse);
  if constexpr (!only_plain) record_surfaces(drawing, kept, record);
  std::size_t vertices = 0, clipped = 0;
  const Viewport viewport(view.width, view.height);
  const auto done = [&](std::string id, std::size_t bytes) {
    if (kept)
      record.item(std::move(id), bytes, true);
    else
      record.pass(std::move(id), bytes);
  };
  if (!kept) transform_objects(viewport, workers, drawing);
  for (const DrawnObject& o : drawing.objects) vertices += bytes_of(o.vertices);
  done("transform", vertices);
  if (!kept) clip_objects(viewport, optional(plan.runs("clip")), workers, drawing);
  for (const DrawnObject& o : drawing.objects) clipped += bytes_of(o.clipped);
  if (optional(plan.runs("clip"))) done("clip", clipped);
  workers.done(0.1f);
  if (!kept) {
    visibility.resize(view.width, view.height);
    find_visible(drawing, workers, buffers.threads, visibility);
  }
  done("visibility", visibility.bytes());
  if (optional(workers.threads() > 1)) record.item("bands", buffers.threads.bytes(), kept);
  workers.done(0.6f);
}

// The layers of textures that the object is drawn with, by when they are applied.
template <class Real>
void begin_layers(const Scene& scene, std::size_t object, DeferredShading<Real>& shading, ObjectShading<Real>& s) {
  const LayerUv uv = layer_uv(scene, object, drawn_field(scene));
  for (std::size_t i = 0; i < uv.layers.size(); ++i) {
    const TextureLayer& layer = *uv.layers[i];
    auto& list = layer.target == LayerTarget::opacity  ? s.opacity
                 : layer.target == LayerTarget::colour ? s.after_light
                                                       : s.before_light;
    list.push_back(
        {&layer, std::size_t(uv.set_of_layer[i]), TextureTransform<Real>(layer.matrix), plain_picture(layer)});
    shading.uses_layers = shading.uses_layers || layer.target != LayerTarget::opacity;
  }
}

template <class Real>
EyeMaterial<Real> changeable(const ObjectShading<Real>& s) {
  std::vector<const TextureLayer*> layers;
  for (const ShadedLayer<Real>& l : s.before_light) layers.push_back(l.layer);
  return changeable(s.material, layers);
}

template <class Real>
bool has_bumps(const ObjectShading<Real>& s) {
  const auto bump = [](const ShadedLayer<Real>& l) { return l.layer->target == LayerTarget::normal; };
  return std::any_of(s.before_light.begin(), s.before_light.end(), bump) && s.light.uses_normal();
}

template <class Real>
void begin_shading(const Scene& scene, const Plan& plan, const Drawing& drawing, DeferredShading<Real>& shading) {
  shading.mode = plan.runs("face-lighting")     ? ShadingMode::flat
                 : plan.runs("vertex-lighting") ? ShadingMode::gouraud
                                                : ShadingMode::phong;
  shading.lighting = lighting_in_eye_space<Real>(scene, view_matrix(scene.camera));
  shading.lighting.local_viewer = plan.runs("local-viewer");
  shading.lighting.two_sided = plan.runs("two-sides");
  shading.lighting.clamp = plan.runs("clamp");
  shading.uses_position = shading.uses_normal = shading.uses_radiosity = shading.uses_layers = false;
  shading.objects.resize(drawing.objects.size());
  for (std::size_t k = 0; k < drawing.objects.size(); ++k) {
    const Object& object = scene.objects[std::size_t(drawing.objects[k].index)];
    ObjectShading<Real>& s = shading.objects[k];
    const Surface& surface = *drawing.objects[k].surface;
    s.material = drawn_material<Real>(scene, object, surface);
    s.before_light.clear(), s.after_light.clear(), s.opacity.clear();
    if (optional(!material_of(scene, object).layers.empty()))
      begin_layers(scene, std::size_t(drawing.objects[k].index), shading, s);
    s.light = LightBatch<Real>(shading.lighting, optional(!s.before_light.empty()) ? changeable(s) : s.material,
                               !surface.radiosity.empty());
    s.normals = normals_to_eye<Real>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
    shading.uses_position = shading.uses_position || s.light.uses_position() || optional(has_bumps(s));
    shading.uses_normal = shading.uses_normal || s.light.uses_normal();
    shading.uses_radiosity = shading.uses_radiosity || s.light.uses_radiosity();
  }
}

// Light for what is visible.
template <class Real>
void shade(const Scene& scene, const Plan& plan, Workers& workers, PassRecorder& record, Buffers& buffers,
           Frame& frame) {
  const Drawing& drawing = buffers.drawing;
  DeferredShading<Real>& shading = buffers.template shading<Real>();
  begin_shading(scene, plan, drawing, shading);
  if constexpr (!only_plain) {
    record_parts(drawing, shading, record);
    record_layers(drawing, shading, record);
  }
  if (optional(plan.runs("alpha-test"))) {
    test_alpha(drawing, shading, scene.shading.alpha_threshold, workers, buffers.visibility);
    record.pass("alpha-test");
  }
  mark_visible_vertices(drawing, buffers.visibility, workers, shading);
  if constexpr (!only_plain) record_marks(drawing, shading, record);
  shade_vertices(drawing, workers, shading);
  if constexpr (!only_plain) record_vertices(shading, record);
  workers.done(0.8f);
  shade_pixels(drawing, buffers.visibility, shading, glm::vec3(scene.display.background), workers, frame);
  record.pass(shading.mode == ShadingMode::phong ? "pixel-lighting" : "interpolation");
}

// The pipeline, in the order of the lecture.
template <class Real>
Frame draw(const Scene& scene, const Plan& plan, const View& view, Progress& progress, Buffers& buffers) {
  PassRecorder record;
  Workers workers(view.threads, progress);
  Frame frame = make_frame(scene, plan, view, record);
  const bool draws = !frame.colour.empty() && plan.runs("transform");
  if (draws) {
    buffers.keep_only<Real>();
    find_geometry(scene, plan, view, workers, record, buffers);
    shade<Real>(scene, plan, workers, record, buffers, frame);
  } else {
    buffers = {};
  }
  if (optional(plan.runs("ids"))) {
    frame.object = frame.triangle = Image<std::int32_t>(view.width, view.height, nothing);
    if (draws) fill_ids(buffers.drawing, buffers.visibility, workers, frame);
    record.pass("ids", bytes_of(frame.object) + bytes_of(frame.triangle));
  }
  if (optional(plan.runs("normals"))) {
    frame.normal = Image<glm::vec3>(view.width, view.height, glm::vec3(0));
    if (draws) fill_normals(scene, buffers.drawing, buffers.visibility, workers, frame);
    record.pass("normals", bytes_of(frame.normal));
  }
  workers.done(1.0f);
  frame.cpu_ms = record.finish(frame);
  return frame;
}

}  // namespace

Technique software_technique() {
  Technique t;
  t.id = "software";
  t.name = {"Software", "ソフトウェア"};
  t.unsupported = [](const Scene&) { return std::nullopt; };
  t.plan = software_plan;
  t.render = [pool = std::make_shared<BufferPool>()](const Scene& scene, const Plan& plan, const View& view,
                                                     Progress& progress) {
    refuse_beyond_limits(view);
    std::unique_ptr<Buffers> buffers = pool->take();
    Frame frame = scene.shading.precision == Precision::double_precision
                      ? draw<double>(scene, plan, view, progress, *buffers)
                      : draw<float>(scene, plan, view, progress, *buffers);
    if (!view.reuse)
      for (DrawnObject& o : buffers->drawing.objects) o.surface.reset();  // keep memory, not meshes
    pool->give(std::move(buffers));
    return frame;
  };
  return t;
}

}  // namespace cg
