#include "raster/software.h"

#include <ctime>
#include <mutex>
#include <string>

#include "params/input_error.h"
#include "raster/frame_layers.h"
#include "raster/pixel_shading.h"
#include "raster/software_plan.h"

namespace cg {

namespace {

// Buffers that are kept from picture to picture, so that a frame does not begin by asking for memory.
struct Buffers {
  Drawing drawing;
  VisibilityBuffer visibility;
  DeferredShading<float> float_shading;
  DeferredShading<double> double_shading;
  template <class Real>
  DeferredShading<Real>& shading() {
    if constexpr (sizeof(Real) == sizeof(float))
      return float_shading;
    else
      return double_shading;
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

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

// A picture beyond this would take gigabytes before its first pixel is drawn.
constexpr std::size_t most_pixels = std::size_t(16384) * 16384;

void refuse_beyond_limits(const View& view) {
  if (view.width <= 0 || view.height <= 0 || std::size_t(view.width) * std::size_t(view.height) <= most_pixels) return;
  const std::string size = std::to_string(view.width) + "x" + std::to_string(view.height);
  throw InputError("size", {"a picture of " + size + " is too large", size + " の画像は大きすぎます"},
                   Words{"at most as many pixels as 16384x16384", "16384x16384 の画素数以下にしてください"});
}

// A frame whose layers have the picture's size. Where something is drawn, shade_pixels() writes all of the first three.
Frame make_frame(const Scene& scene, const Plan& plan, const View& view) {
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
  if (plan.runs("ids")) f.object = f.triangle = Image<std::int32_t>(w, h, nothing);
  if (plan.runs("normals")) f.normal = Image<glm::vec3>(w, h, glm::vec3(0));
  return f;
}

template <class Real>
void begin_shading(const Scene& scene, const Plan& plan, const Drawing& drawing, DeferredShading<Real>& shading) {
  shading.mode = plan.runs("face-lighting")     ? ShadingMode::flat
                 : plan.runs("vertex-lighting") ? ShadingMode::gouraud
                                                : ShadingMode::phong;
  shading.lighting = lighting_in_eye_space<Real>(scene, view_matrix(scene.camera));
  shading.lighting.two_sided = plan.runs("two-sides");
  shading.objects.resize(drawing.objects.size());
  for (std::size_t k = 0; k < drawing.objects.size(); ++k) {
    const Object& object = scene.objects[std::size_t(drawing.objects[k].index)];
    shading.objects[k].material = eye_material<Real>(material_of(scene, object), scene.shading.color_material);
    shading.objects[k].normals =
        normals_to_eye<Real>(view_matrix(scene.camera) * matrix(object.transform), scene.shading.normal_length);
  }
}

// The pipeline, in the order of the lecture.
template <class Real>
Frame draw(const Scene& scene, const Plan& plan, const View& view, Progress& progress, Buffers& buffers) {
  Workers workers(view.threads, progress);
  Frame frame = make_frame(scene, plan, view);
  if (frame.colour.empty() || !plan.runs("transform")) return frame;
  Drawing& drawing = buffers.drawing;
  const Viewport viewport(view.width, view.height);

  gather_objects(scene, view, workers, drawing);
  transform_objects(viewport, workers, drawing);
  clip_objects(viewport, plan.runs("clip"), workers, drawing);
  workers.done(0.1f);

  buffers.visibility.resize(view.width, view.height);
  find_visible(drawing, workers, buffers.visibility);
  workers.done(0.6f);

  DeferredShading<Real>& shading = buffers.template shading<Real>();
  begin_shading(scene, plan, drawing, shading);
  mark_visible_vertices(drawing, buffers.visibility, workers, shading);
  shade_vertices(drawing, workers, shading);
  workers.done(0.8f);
  shade_pixels(drawing, buffers.visibility, shading, glm::vec3(scene.display.background), workers, frame);
  fill_ids_and_normals(scene, drawing, buffers.visibility, workers, frame);
  workers.done(1.0f);
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
    const double begin = cpu_ms();
    std::unique_ptr<Buffers> buffers = pool->take();
    Frame frame = scene.shading.precision == Precision::double_precision
                      ? draw<double>(scene, plan, view, progress, *buffers)
                      : draw<float>(scene, plan, view, progress, *buffers);
    for (DrawnObject& o : buffers->drawing.objects) o.surface.reset();  // keep memory, not meshes
    pool->give(std::move(buffers));
    frame.cpu_ms = cpu_ms() - begin;
    return frame;
  };
  return t;
}

}  // namespace cg
