// Polygons divided into patches, and patches into elements: patches shoot, elements receive.
// This work is based on: Cindy Goral, Kenneth Torrance, Donald Greenberg, Bennett Battaile, Modeling the Interaction of
// Light Between Diffuse Surfaces, 1984; Michael Cohen, Donald Greenberg, David Immel, Philip Brock, An Efficient
// Radiosity Approach for Realistic Image Synthesis, 1986 (patches and elements).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"
#include "scene/frame.h"
#include "scene/radiosity.h"
#include "scene/scene.h"

namespace cg {

// A plane convex polygon with three or four corners, in world coordinates, counter-clockwise seen from the side that
// reflects.
struct Patch {
  std::array<glm::dvec3, 4> corner;
  int corners = 4;                  // 3 or 4
  glm::dvec3 centre{0}, normal{0};  // normal: unit; 0 where the patch has no area (it takes part in nothing)
  double area = 0;                  // m^2
  glm::dvec3 reflectance{0};        // rho: k_d of its material, 0..1
  glm::dvec3 emission{0};           // E over pi: the material's emission
  std::uint32_t object = 0;         // index into Scene::objects
  std::uint32_t face = 0;           // of the object's mesh
};

// An element: a part of a patch, its corners among `vertices`.
struct Element {
  std::array<std::uint32_t, 4> vertex;  // indices into Patches::vertices, counter-clockwise
  int corners = 4;
  std::uint32_t patch = 0;
  double area = 0;
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<Element> elements;  // by patch, in order: those of patch p are first_element[p] .. first_element[p+1]-1
  std::vector<std::uint32_t> first_element{0};
  // Shared by elements that meet in one plane of one object, so that light is interpolated across them and not across
  // an edge; a T-junction's vertex is a corner of the large element's triangulation too (see elements_of_object).
  std::vector<glm::dvec3> vertices;
  bool closed = false;         // every edge has two faces: rows of F sum to 1
  std::size_t degenerate = 0;  // faces without area, left out
};

// Faces of every visible object, cut until no side is longer than options.patch_size. Triangles are cut into triangles
// in four, quads into quads; other polygons into triangles first. Throws InputError where a reflectance is above 1 or a
// patch count would pass 2^22, Cancelled.
Patches make_patches(const Scene& scene, const Radiosity& options, Progress& progress);

// A number that is the same for scenes whose patches are: meshes, transforms, patch size. Not for their materials.
std::uint64_t geometry_key(const Scene& scene, const Radiosity& options);

}  // namespace cg
