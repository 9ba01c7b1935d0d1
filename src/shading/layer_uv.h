// Which layers of textures an object is drawn with, and the uv that they need: each set once, whoever shares it.
#pragma once
#include <optional>
#include <vector>

#include "mapping/corner_uv.h"
#include "scene/scene.h"

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
// where Shading::transparency ignores it, and, where the object is drawn as the elements of `field`, for k_a and for
// what has uv by the mesh's corners, which the elements do not have.
LayerUv layer_uv(const Scene& scene, std::size_t object, const RadiosityField* field);

// A pair for each corner of the mesh, finite. All 0 where there is none (uv_problem). An unwrap takes seconds for a
// large mesh: it is made once and kept.
CornerUv uv_of(const UvSet& set, const MeshHandle& mesh);

// Why the mesh has no such uv, in a few words; nothing where it has.
std::optional<Text> uv_problem(const UvSet& set, const MeshHandle& mesh);

// What a plan has to say about the visible objects' layers.
std::vector<Text> layer_notes(const Scene& scene, const RadiosityField* field);

}  // namespace cg
