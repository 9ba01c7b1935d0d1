#include "shading/layer_uv.h"

#include <algorithm>

#include "mapping/projection.h"
#include "mapping/unwrap.h"
#include "params/input_error.h"
#include "shading/layers.h"
#include "shading/made_once.h"

namespace cg {

namespace {

struct UnwrappedUv {
  CornerUv uv;  // empty where there is a problem
  std::optional<Text> problem;
};

// A mesh and its unwrap do not change: what was computed is kept for as long as the mesh.
std::shared_ptr<const UnwrappedUv> unwrapped(const MeshHandle& mesh, const Unwrapping& how) {
  static MadeOnce<Unwrapping, std::shared_ptr<const UnwrappedUv>> kept(4);
  return kept.get({mesh, mesh.get()}, how, [&] {
    UnwrappedUv out;
    try {
      out.uv = unwrap(mesh, how).uv;
    } catch (const InputError& e) {
      out.problem = e.found;
    }
    return std::make_shared<const UnwrappedUv>(std::move(out));
  });
}

// A face with a corner that has no number has none at all.
void zero_where_not_finite(const MeshData& data, CornerUv& uv) {
  const auto bad = [](const glm::dvec2& p) { return !std::isfinite(p.x) || !std::isfinite(p.y); };
  for (std::size_t f = 0; f < data.face_count(); ++f) {
    const auto first = uv.begin() + data.first_corner[f], end = uv.begin() + data.first_corner[f + 1];
    if (std::any_of(first, end, bad)) std::fill(first, end, glm::dvec2(0));
  }
}

UvSet set_of(const TextureLayer& layer, const Object& object) {
  UvSet set;
  set.source = layer.uv;
  if (layer.uv == UvSource::projector) set.projector = layer.projector;
  if (layer.uv == UvSource::unwrap) set.unwrapping = object.unwrapping;
  return set;
}

bool takes_part(const RadiosityField* field, std::size_t object) { return field && field->objects[object].mesh; }

bool needs_corners(const TextureLayer& layer) { return layer.uv != UvSource::projector; }

}  // namespace

LayerUv layer_uv(const Scene& scene, std::size_t object, const RadiosityField* field) {
  LayerUv out;
  const Material& material = material_of(scene, scene.objects[object]);
  if (material.layers.empty()) return out;
  const bool elements = takes_part(field, object);
  for (const TextureLayer* layer : counting(material.layers)) {
    const LayerTarget target = layer->target;
    if (target == LayerTarget::k_r || target == LayerTarget::k_t) continue;
    if (target == LayerTarget::opacity && scene.shading.transparency == Transparency::opaque) continue;
    if (target == LayerTarget::normal && scene.shading.mode != ShadingMode::phong) continue;
    if (elements && (target == LayerTarget::k_a || needs_corners(*layer))) continue;
    const UvSet set = set_of(*layer, scene.objects[object]);
    const auto place = std::find(out.sets.begin(), out.sets.end(), set);
    out.layers.push_back(layer);
    out.set_of_layer.push_back(int(place - out.sets.begin()));
    if (place == out.sets.end()) out.sets.push_back(set);
  }
  return out;
}

bool tests_alpha(const Scene& scene, std::size_t object, const RadiosityField* field) {
  if (scene.shading.transparency != Transparency::test) return false;
  const LayerUv uv = layer_uv(scene, object, field);
  return std::any_of(uv.layers.begin(), uv.layers.end(),
                     [](const TextureLayer* l) { return !is_before_light(l->target); });
}

CornerUv uv_of(const UvSet& set, const MeshHandle& mesh) {
  CornerUv uv;
  switch (set.source) {
    case UvSource::mesh:
      uv = corner_uv(mesh->data());
      break;
    case UvSource::projector:
      uv = projected_uv(mesh->data(), set.projector);
      break;
    case UvSource::unwrap:
      uv = unwrapped(mesh, set.unwrapping)->uv;
      break;
  }
  uv.resize(mesh->data().corners.size(), glm::dvec2(0));
  zero_where_not_finite(mesh->data(), uv);
  return uv;
}

std::optional<Text> uv_problem(const UvSet& set, const MeshHandle& mesh) {
  if (set.source == UvSource::mesh && !mesh->has_uvs())
    return Text(Words{"the mesh has no uv", "メッシュに uv がない"});
  return set.source == UvSource::unwrap ? unwrapped(mesh, set.unwrapping)->problem : std::nullopt;
}

std::vector<Text> layer_notes(const Scene& scene, const RadiosityField* field) {
  const auto before = [](const TextureLayer* l) { return is_before_light(l->target); };
  std::vector<Text> notes;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const Material& material = material_of(scene, object);
    if (!object.visible || !object.mesh || material.layers.empty()) continue;
    for (const TextureLayer* layer : counting(material.layers)) {
      if (layer->target == LayerTarget::k_r || layer->target == LayerTarget::k_t)
        notes.push_back(Words{"textures of k_r and k_t need ray tracing: left out",
                              "k_r と k_t のテクスチャはレイトレーシングが必要なので省く"});
      else if (layer->target == LayerTarget::normal && scene.shading.mode != ShadingMode::phong)
        notes.push_back(Words{"normals from textures need Phong shading, which has a normal at each pixel: left out",
                              "法線のテクスチャには画素ごとの法線が必要。フォンシェーディングでないので省く"});
      else if (takes_part(field, i) && layer->target == LayerTarget::k_a)
        notes.push_back(Words{"textures of k_a are left out: a radiosity solution stands in for the ambient term",
                              "環境光項はラジオシティの解なので k_a のテクスチャは省く"});
      else if (takes_part(field, i) && needs_corners(*layer))
        notes.push_back(
            Words{"the elements of a radiosity solution have no uv of the mesh: only projected textures "
                  "are drawn",
                  "ラジオシティの要素にはメッシュの uv がないので、投影したテクスチャだけを描く"});
    }
    const LayerUv uv = layer_uv(scene, i, field);
    const bool at_vertices = scene.shading.mode != ShadingMode::phong;
    if (at_vertices && std::any_of(uv.layers.begin(), uv.layers.end(), before))
      notes.push_back(Words{"light is computed at the vertices: textures that change the material count there alone",
                            "光源計算は頂点で行うので、素材を変えるテクスチャは頂点でだけ読む"});
    for (const UvSet& set : uv.sets)
      if (const auto problem = uv_problem(set, object.mesh))
        notes.push_back({object.name + ": uv are 0: " + problem->en, object.name + "：uv は 0：" + problem->ja});
  }
  return notes;
}

}  // namespace cg
