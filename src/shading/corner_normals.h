// Normals of a mesh's corners by the scene's rule: the file's own, the face's, or an average of the faces that
// meet at the vertex. This work is based on: Henri Gouraud, Continuous Shading of Curved Surfaces, 1971 (the mean);
// Grit Thürmer and Charles Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998 (weighted by angle);
// Nelson Max, Weights for Computing Vertex Normals from Facet Normals, 1999 (a comparison).
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "scene/mesh.h"
#include "scene/shading.h"

namespace cg {

// One number for each position, the same for equal positions: files that repeat a vertex (STL does so for each
// triangle) still have neighbours.
std::vector<std::uint32_t> weld_positions(const Mesh& mesh);

// One normal a corner. Unit, or 0 where the corner's face is degenerate; the file's own as they are, or 0 where
// they are not finite. `crease_angle` in degrees: two faces at a vertex are averaged when a chain of faces around
// that vertex joins them, each of whose shared edges bends by at most so much; 180 averages all faces at the
// vertex. Where an average vanishes the corner has its own face's normal.
std::vector<glm::dvec3> corner_normals(const Mesh& mesh, const std::vector<std::uint32_t>& point, NormalRule rule,
                                       double crease_angle);

}  // namespace cg
