// Which layers of textures an object is drawn with, and the uv that they need: each set once, whoever shares it.
#pragma once
#include <optional>
#include <vector>

#include "mapping/corner_uv.h"
#include "scene/scene.h"
#include "shading/light_model.h"

namespace cg {

// Where uv come from, compared by value. What `source` does not name is as it is by default.
struct UvSet {
  UvSource source = UvSource::mesh;
  Projector projector;
  Unwrapping unwrapping;
  friend bool operator==(const UvSet&, const UvSet&) = default;
};

struct LayerUv {
  std::vector<const TextureLayer*> layers;  // of the scene's material or the object's own, in their order
  std::vector<UvSet> sets;                  // each once, in the order of Surface::uv
  std::vector<int> set_of_layer;            // one a layer: the index of its set
};

// The layers that a technique without rays draws: those that count (shading/layers.h), but for k_r and k_t, for opacity
// where Shading::transparency ignores it, for normals where no pixel has one (flat, Gouraud), and, where the object is
// drawn as the elements of `field`, for k_a and for what has uv by the mesh's corners, which the elements do not have.
LayerUv layer_uv(const Scene& scene, std::size_t object, const RadiosityField* field);

// What the light model is given, and so is changed before there is light.
constexpr bool is_before_light(LayerTarget target) {
  return target != LayerTarget::colour && target != LayerTarget::opacity;
}

// Whether the object has layers that may make it transparent, and Shading::transparency tests alpha. As in the fixed
// function, a picture's alpha counts where it is combined with the lit colour, too.
bool tests_alpha(const Scene& scene, std::size_t object, const RadiosityField* field);

// The material with 1 for each number that a layer may change: which parts of the light model it may need.
template <class Real>
EyeMaterial<Real> changeable(EyeMaterial<Real> m, const std::vector<const TextureLayer*>& layers) {
  for (const TextureLayer* l : layers) {
    if (l->target == LayerTarget::k_a) m.k_a = Vec3<Real>(Real(1));
    if (l->target == LayerTarget::k_d) m.k_d = Vec3<Real>(Real(1));
    if (l->target == LayerTarget::k_s) m.k_s = Vec3<Real>(Real(1));
    if (l->target == LayerTarget::emission) m.emission = Vec3<Real>(Real(1));
  }
  return m;
}

// A pair for each corner of the mesh, finite. All 0 where there is none (uv_problem). An unwrap takes seconds for a
// large mesh: it is made once and kept.
CornerUv uv_of(const UvSet& set, const MeshHandle& mesh);

// Why the mesh has no such uv, in a few words; nothing where it has.
std::optional<Text> uv_problem(const UvSet& set, const MeshHandle& mesh);

// What a plan has to say about the visible objects' layers.
std::vector<Text> layer_notes(const Scene& scene, const RadiosityField* field);

}  // namespace cg
