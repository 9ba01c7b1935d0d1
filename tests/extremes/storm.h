// Random states of a scene within everything that its parameters accept, ends of ranges and 1e±30 included.
#pragma once
#include <random>

#include "scene/technique.h"

namespace cg::storm {

// The meshes that a state may draw: ordinary ones, and some of extreme size, place, shape or normals.
std::vector<MeshHandle> meshes();

// The same `seed` gives the same scene, on every machine.
Scene random_scene(std::uint64_t seed, const std::vector<MeshHandle>& meshes);

// What is wrong with the picture of a state, or empty. `software` draws it in a few hundred pixels.
std::string fault(const Technique& software, const Scene& scene);

}  // namespace cg::storm
