#include "raster/software_trace.h"

#include "shading/plan_maker.h"

namespace cg {

namespace {

std::vector<const Surface*> surfaces_of(const Drawing& drawing) {
  std::vector<const Surface*> all;
  for (const DrawnObject& o : drawing.objects)
    if (std::find(all.begin(), all.end(), o.surface.get()) == all.end()) all.push_back(o.surface.get());
  return all;
}

}  // namespace

void record_surfaces(const Drawing& drawing, bool kept, PassRecorder& record) {
  std::size_t bytes = 0;
  for (const Surface* s : surfaces_of(drawing)) bytes += s->bytes();
  record.item("surfaces", bytes, kept);
}

template <class Real>
void record_parts(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record) {
  LightParts parts;
  bool local_viewer = false;
  for (const ObjectShading<Real>& o : shading.objects)
    parts |= o.light.parts(), local_viewer = local_viewer || o.light.local_viewer();
  for (const char* id : part_ids(parts, local_viewer, shading.lighting.two_sided, shading.lighting.clamp))
    record.item(id);
  if (!parts.radiosity) return;
  std::size_t bytes = 0;
  for (const Surface* s : surfaces_of(drawing)) bytes += bytes_of(s->radiosity);
  record.item("radiosity", bytes);
}

template <class Real>
void record_layers(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record) {
  std::vector<const TextureImage*> pictures;
  std::size_t layers = 0, picture_bytes = 0, uv_bytes = 0;
  for (const ObjectShading<Real>& o : shading.objects)
    for (const auto* list : {&o.before_light, &o.after_light, &o.opacity})
      for (const ShadedLayer<Real>& l : *list) {
        ++layers;
        if (std::find(pictures.begin(), pictures.end(), l.layer->texture.get()) != pictures.end()) continue;
        pictures.push_back(l.layer->texture.get());
        picture_bytes += l.layer->texture->bytes();
      }
  if (layers == 0) return;
  for (const Surface* s : surfaces_of(drawing)) uv_bytes += s->uv_bytes();
  record.item("uv", uv_bytes);
  record.item("textures", picture_bytes);
  record.item("layers");
}

template <class Real>
void record_marks(const Drawing& drawing, const DeferredShading<Real>& shading, PassRecorder& record) {
  std::size_t clipped = 0, fronts = 0, backs = 0;
  for (const DrawnObject& o : drawing.objects) clipped += o.clipped.size();
  for (const ObjectShading<Real>& o : shading.objects)
    fronts += bytes_of(o.vertices.front_seen), backs += bytes_of(o.vertices.back_seen);
  record.pass("mark-visible", bytes_of(shading.seen) - clipped + fronts);
  record.hold("clip", clipped);
  record.hold("two-sides", backs);
}

template <class Real>
void record_vertices(const DeferredShading<Real>& shading, PassRecorder& record) {
  std::size_t fronts = 0, backs = 0, spaces = 0;
  for (const ObjectShading<Real>& o : shading.objects) {
    fronts += bytes_of(o.vertices.front), backs += bytes_of(o.vertices.back);
    spaces += bytes_of(o.vertices.P) + bytes_of(o.vertices.N);
  }
  record.hold("two-sides", backs);
  if (shading.mode == ShadingMode::phong) {
    if (shading.uses_position || shading.uses_normal) record.pass("vertex-to-eye", spaces);
  } else {
    record.pass(shading.mode == ShadingMode::flat ? "face-lighting" : "vertex-lighting", fronts);
  }
}

template void record_parts(const Drawing&, const DeferredShading<float>&, PassRecorder&);
template void record_parts(const Drawing&, const DeferredShading<double>&, PassRecorder&);
template void record_layers(const Drawing&, const DeferredShading<float>&, PassRecorder&);
template void record_layers(const Drawing&, const DeferredShading<double>&, PassRecorder&);
template void record_marks(const Drawing&, const DeferredShading<float>&, PassRecorder&);
template void record_marks(const Drawing&, const DeferredShading<double>&, PassRecorder&);
template void record_vertices(const DeferredShading<float>&, PassRecorder&);
template void record_vertices(const DeferredShading<double>&, PassRecorder&);

}  // namespace cg
