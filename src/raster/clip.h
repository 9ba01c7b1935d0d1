// Triangles that cross the view volume, cut in homogeneous clip space, before the division by w.
// This work is based on: Ivan Sutherland and Gary Hodgman, Reentrant Polygon Clipping, 1974; planes and order of
// operations follow the OpenGL that the picture is compared with, so that new vertices fall on the same sub-pixel.
#pragma once
#include <array>

#include "raster/transform.h"

namespace cg {

// One triangle of the fan that a clipped triangle becomes.
struct ClippedTriangle {
  std::uint32_t source;  // index of the surface's triangle
  std::array<WindowVertex, 3> vertices;
  // What each of the three is made of: weights of the source's three vertices, with sum 1 before the division by
  // w, so that colours and normals follow.
  std::array<glm::vec3, 3> weights;
};

// The triangles of `surface` that are neither wholly inside nor wholly outside one plane, cut. Sorted by source.
void clip_triangles(const Surface& surface, const glm::mat4& surface_to_clip, const Viewport& viewport,
                    const std::vector<WindowVertex>& vertices, Workers& workers, std::vector<ClippedTriangle>& out);

// Clips one triangle; appends 0 to 7 triangles.
void clip_triangle(const std::array<glm::vec4, 3>& clip, std::uint32_t source, const Viewport& viewport,
                   std::vector<ClippedTriangle>& out);

}  // namespace cg
