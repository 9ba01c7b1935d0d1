#include "gl/draw_list.h"

#include "shading/clip_position.h"

namespace cg {

std::vector<DrawItem> draw_list(const Scene& scene, const View& view, DrawnBy by) {
  const RadiosityField* field = only_plain ? nullptr : drawn_field(scene, by);
  const glm::dmat4 world_to_eye = view_matrix(scene.camera);
  const glm::mat4 to_clip = eye_to_clip(scene, view.width, view.height);
  std::vector<DrawItem> items;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!object.visible || !object.mesh) continue;
    const SurfaceHandle surface = drawn_surface(scene, i, field);
    if (surface->triangle_count() == 0) continue;
    const glm::mat4 to_eye(surface_to_eye(scene, object, *surface));
    if (!can_be_placed(to_eye, surface_to_clip(to_clip, to_eye))) continue;
    items.push_back({int(i), surface, &material_of(scene, object), world_to_eye * matrix(object.transform), to_eye});
  }
  return items;
}

LayerUv drawn_layers(const Scene& scene, const DrawItem& item, DrawnBy by) {
  return layer_uv(scene, std::size_t(item.object), drawn_field(scene, by));
}

void record_surfaces(const std::vector<DrawItem>& items, bool kept, std::size_t radiosity_buffers,
                     std::size_t uv_buffers, PassRecorder& record) {
  std::vector<const Surface*> all;
  std::size_t bytes = 0, radiosity = 0, uv = 0;
  for (const DrawItem& item : items) {
    if (std::find(all.begin(), all.end(), item.surface.get()) != all.end()) continue;
    all.push_back(item.surface.get());
    bytes += item.surface->bytes(), radiosity += bytes_of(item.surface->radiosity), uv += item.surface->uv_bytes();
  }
  record.item("surfaces", bytes, kept);
  if (radiosity > 0) record.item("radiosity", radiosity + radiosity_buffers, kept);
  if (uv > 0) record.item("uv", uv + uv_buffers, kept);
}

}  // namespace cg
