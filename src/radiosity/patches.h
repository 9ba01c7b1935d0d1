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
  std::array<glm::dvec3, 4> corner{};
  int corners = 4;                  // 3 or 4
  glm::dvec3 centre{0}, normal{0};  // normal: unit; 0 where the patch has no area (it takes part in nothing)
  double area = 0;                  // m^2
  glm::dvec3 reflectance{0};        // rho: k_d of its material, 0..1
  glm::dvec3 emission{0};           // E over pi: the material's emission
  std::uint32_t object = 0;         // index into Scene::objects
  std::uint32_t face = 0;           // of the object's mesh
};

// Where elements meet.
struct ElementVertex {
  glm::dvec3 position{0};     // world
  glm::dvec3 local{0};        // the same in the object's own coordinates
  glm::dvec3 normal{0};       // the mesh's own, in the object's coordinates, any length; 0 where it has none
  std::uint32_t surface = 0;  // its plane, or smooth surface, of one object: light goes over from element to element
                              // within one and not beyond
};

// An element: a part of a patch, its corners among `vertices`.
struct Element {
  std::array<std::uint32_t, 4> vertex;  // indices into Patches::vertices, counter-clockwise
  int corners = 4;
  std::uint32_t patch = 0;
  int level = 0;  // how often the patch was cut in four; 0 is all of it
  double area = 0;
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<Element> elements;  // by patch, in order: those of patch p are first_element[p] .. first_element[p+1]-1
  std::vector<std::uint32_t> first_element{0};
  // Shared by the elements that meet in one surface. Where elements of different sizes meet, a vertex of the small ones
  // lies inside an edge of the large one (a T-junction): radiosity/elements.h finds those.
  std::vector<ElementVertex> vertices;
  // Whatever leaves a front meets another front: rows of F sum to 1. Known from the solid angle of all faces, which
  // is 4 pi from everywhere in such a room however its faces meet.
  bool closed = false;
  std::size_t degenerate = 0;  // faces without area, left out
};

// Faces of every visible object, cut until no side is longer than options.patch_size. Triangles are cut into triangles
// in four, plane convex quads into quads; other polygons into triangles first. The front of a face is the side from
// which its corners are counter-clockwise; a transform that mirrors leaves outside outside. Each patch is one element.
// Throws InputError where a reflectance is not in 0..1 or a patch count would pass 2^22, Cancelled.
Patches make_patches(const Scene& scene, const Radiosity& options, Progress& progress);

// How many patches that would be, without making them. Throws as make_patches() where they are too many.
std::size_t count_patches(const Scene& scene, const Radiosity& options, Progress& progress);

// An element as a polygon of its own, with its patch's reflectance and emission.
Patch element_as_patch(const Patches& patches, std::uint32_t element);

// A number that is the same for scenes whose patches are: meshes, transforms, patch size. Not for their materials.
std::uint64_t geometry_key(const Scene& scene, const Radiosity& options);

}  // namespace cg
