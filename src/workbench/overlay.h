// Lines drawn over the picture: edges, normals, lights and axes, in world space. What they mean decides their
// colour, which is the window's affair.
#pragma once
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace cg {

enum class Mark {
  edge,
  face_normal,
  vertex_normal,
  light,
  selected_light,
  axis_x,
  axis_y,
  axis_z,
  vector_edge,  // dark, under the vectors of a probed point,
  vector_N,     // which are these
  vector_L,
  vector_R,
  vector_V,
  vector_H,
  probed_face,
  patch,        // that a panel points at,
  other_patch,  // and the one that it is seen from, or sees
  other_fill,   // and what lies in it
  camera,       // seen from outside
  clip_volume
};

// Line segments: points 2i and 2i+1 are the ends of one, relative to `origin` so that far scenes survive float.
struct Lines {
  Mark mark = Mark::edge;
  glm::dvec3 origin{0};  // world
  std::vector<glm::vec3> points;

  std::size_t count() const { return points.size() / 2; }
};

struct OverlayChoice {
  bool edges = false, face_normals = false, vertex_normals = false;
  double normal_length = 0.08;  // metres
  friend bool operator==(const OverlayChoice&, const OverlayChoice&) = default;
};

// More lines than this are a grey surface and not a drawing: they are thinned evenly down to it.
inline constexpr std::size_t most_lines = 200'000;

// Edges of the faces as the file has them (not of their triangles), normals in the middle of each face, and the
// vertices' normals as they are lit with (Scene::shading decides them). For large meshes a matter of 0.1 s:
// made on a worker. `thinned` tells whether lines were left out.
struct MeshOverlay {
  std::vector<Lines> lines;
  bool thinned = false;
};
MeshOverlay mesh_overlay(const Scene& scene, const OverlayChoice& choice);

// Where a point or spot light loses half of its strength by distance: the positive root of
// k_0 + k_1 r + k_2 r^2 = 2 k_0 (2 where k_0 is 0). Nothing where it does not fade.
std::optional<double> half_distance(const Light& light);

// The drawing of one light: a spot's cone and axis, the circle of half strength about a light that fades, the
// rays of a directional light. `size` is the extent of the drawing in metres (of what is seen).
Lines light_lines(const Light& light, bool selected, const Camera& camera, double size);

// The three axes from the world's origin, one metre times `length` each.
std::vector<Lines> axis_lines(double length);

}  // namespace cg
