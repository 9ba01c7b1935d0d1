// Surfaces made once and shared: several techniques draw the same mesh by the same rule at the same time.
#pragma once
#include "scene/radiosity_field.h"
#include "shading/layer_uv.h"
#include "shading/made_once.h"
#include "shading/surface.h"

namespace cg {

// Safe to use from several threads. Keeps, of each mesh, the few surfaces used last, and none of a mesh that is gone.
class SurfaceCache {
 public:
  explicit SurfaceCache(std::size_t surfaces_a_mesh = 3) : surfaces_(surfaces_a_mesh) {}

  // As make_surface, with the uv of each set. Who asks while another thread makes the same surface waits for it; others
  // do not.
  SurfaceHandle get(const MeshHandle& mesh, NormalRule rule, double crease_angle, std::vector<UvSet> uv = {}) {
    const Key key = key_of(rule, crease_angle, std::move(uv));
    return surfaces_.get({mesh, mesh.get()}, key, [&] { return make(mesh, key, nullptr); });
  }
  // The same of the elements of an object, which takes part in the solution.
  SurfaceHandle get(const RadiosityHandle& field, std::size_t object, NormalRule rule, double crease_angle,
                    std::vector<UvSet> uv = {}) {
    const ObjectRadiosity& elements = field->objects[object];
    const Key key = key_of(rule, crease_angle, std::move(uv));
    return surfaces_.get({field, &elements}, key, [&] { return make(elements.mesh, key, &elements.corners); });
  }

 private:
  struct Key {
    NormalRule rule;
    double crease_angle;
    std::vector<UvSet> uv;
    friend bool operator==(const Key&, const Key&) = default;
  };
  static Key key_of(NormalRule rule, double crease_angle, std::vector<UvSet> uv) {
    return {rule, rule == NormalRule::face ? 180 : crease_angle, std::move(uv)};  // flat faces have no crease
  }
  static SurfaceHandle make(const MeshHandle& mesh, const Key& key, const std::vector<glm::vec3>* radiosity) {
    std::vector<CornerUv> uv;
    for (const UvSet& set : key.uv) uv.push_back(uv_of(set, mesh));
    return make_surface(*mesh, key.rule, key.crease_angle, radiosity, uv);
  }

  MadeOnce<Key, SurfaceHandle> surfaces_;
};

// The program's own: what it holds never changes a result, only when it is computed.
inline SurfaceCache& surface_cache() {
  static SurfaceCache cache;
  return cache;
}

}  // namespace cg
