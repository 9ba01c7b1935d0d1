#include "raster/drawing.h"

#include "scene/pass_recorder.h"
#include "shading/ambient_term.h"
#include "shading/layer_uv.h"

namespace cg {

bool gather_objects(const Scene& scene, const View& view, Workers& workers, Drawing& drawing) {
  const glm::mat4 projection = eye_to_clip(scene, view.width, view.height);
  const RadiosityField* field = only_plain ? nullptr : drawn_field(scene);
  std::size_t used = 0;
  bool same = true;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    workers.check();
    if (!object.visible || !object.mesh) continue;
    SurfaceHandle surface = drawn_surface(scene, i, field);
    if (surface->triangle_count() == 0) continue;
    const glm::dmat4 to_eye = surface_to_eye(scene, object, *surface);
    const glm::mat4 to_clip = surface_to_clip(projection, glm::mat4(to_eye));
    if (!can_be_placed(glm::mat4(to_eye), to_clip)) continue;
    if (used == drawing.objects.size()) drawing.objects.emplace_back();
    DrawnObject& o = drawing.objects[used++];
    const bool tested = optional(tests_alpha(scene, i, field));
    same = same && o.index == int(i) && o.surface == surface && o.to_eye == to_eye && o.to_clip == to_clip &&
           o.tested == tested && !tested;
    o.index = int(i), o.surface = std::move(surface), o.to_eye = to_eye, o.to_clip = to_clip, o.tested = tested;
  }
  same = same && used == drawing.objects.size();
  drawing.objects.resize(used);
  return same;
}

void transform_objects(const Viewport& viewport, Workers& workers, Drawing& drawing) {
  for (DrawnObject& o : drawing.objects)
    o.outside = transform_vertices(o.surface->positions, o.to_clip, viewport, workers, o.vertices);
}

void clip_objects(const Viewport& viewport, bool clip, Workers& workers, Drawing& drawing) {
  std::uint32_t next = 0;
  for (DrawnObject& o : drawing.objects) {
    clip ? o.clipped.clear() : fit(o.clipped, 0);
    if (clip && o.outside != 0) clip_triangles(*o.surface, o.to_clip, viewport, o.vertices, workers, o.clipped);
    o.first = next;
    o.end = next += std::uint32_t(o.surface->triangle_count() + o.clipped.size());
  }
}

Drawing drawing_of(const Scene& scene, const View& view, Workers& workers) {
  const Viewport viewport(view.width, view.height);
  Drawing drawing;
  gather_objects(scene, view, workers, drawing);
  transform_objects(viewport, workers, drawing);
  clip_objects(viewport, true, workers, drawing);
  return drawing;
}

}  // namespace cg
