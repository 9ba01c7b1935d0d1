// The faces of a scene as radiosity takes them: plane convex triangles and quads in world coordinates, and which of
// them make one surface.
#pragma once
#include <array>
#include <vector>

#include "radiosity/patches.h"

namespace cg {

struct SurfaceFace {
  std::array<ElementVertex, 4> corner{};  // counter-clockwise seen from the front
  int corners = 4;
  glm::dvec3 normal{0};  // world, unit
  std::uint32_t object = 0, face = 0;
};

struct SurfaceFaces {
  std::vector<SurfaceFace> faces;  // by object, then by face
  std::size_t degenerate = 0;      // faces without area, left out
};

// Of every visible object that has a mesh. Corners have their surfaces: faces of one object that meet belong to one
// where they lie in one plane, or where their edge has the same two normals from both sides (then the file means it to
// be smooth). Throws Cancelled.
SurfaceFaces faces_of(const Scene& scene, const Progress& progress);

// Whether what is counter-clockwise in an object's coordinates is clockwise in the world's.
bool mirrors(const Transform& transform);

// The world coordinates of the corners.
std::array<glm::dvec3, 4> positions_of(const SurfaceFace& face);

// Whether whatever leaves the front of a face meets the front of another. The solid angle of all faces, positive from
// the front, is then 4 pi from everywhere in the room, however its edges meet and whatever else stands in it (which has
// 0 if it is closed). Asked in front of each face, or of some thousands of them where there are more. Throws Cancelled.
bool enclosed(const std::vector<SurfaceFace>& faces, const Progress& progress);

}  // namespace cg
