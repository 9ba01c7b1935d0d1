// Where a mesh's faces lie in the texture: a value to copy, compare and undo.
#pragma once
#include "mapping/corner_uv.h"
#include "mapping/distortion.h"
#include "scene/mapping_parameters.h"

namespace cg {

struct UvLayout {
  MeshHandle mesh;
  CornerUv uv;                       // of each corner of the mesh, finite
  std::vector<std::uint32_t> chart;  // of each face; no_index: without area
  std::uint32_t charts = 0;
  friend bool operator==(const UvLayout&, const UvLayout&) = default;
};

// Charts are the faces that hang together by edges along which the uv of both sides are equal.
UvLayout make_layout(MeshHandle mesh, CornerUv uv);

// The edges where the uv of the two sides differ, and the mesh's borders.
EdgeCuts layout_cuts(const UvLayout& layout, const UnwrapSurface& surface);

// Those of them that have faces on both sides, each once.
std::vector<SeamEdge> seams_of(const UvLayout& layout);

// Of each of the mesh's triangles.
std::vector<Stretch> stretches_of(const UvLayout& layout);

struct LayoutFigures {
  DistortionSum distortion;
  std::size_t pixels = 0;              // of the whole texture
  std::size_t covered_pixels = 0;      // whose centre lies in a triangle
  std::size_t overlapping_pixels = 0;  // whose centre lies in two or more
  double share_used() const { return pixels > 0 ? double(covered_pixels) / double(pixels) : 0; }
};

// Counted on size x size pixels; a centre on a common edge belongs to one of its two triangles.
LayoutFigures figures_of(const UvLayout& layout, int size = 2048);

// How many triangles cover each pixel's centre, at most 255; row 0 is at v = 0. Triangles outside 0..1 are cut off.
std::vector<std::uint8_t> coverage_of(const UvLayout& layout, int size);

}  // namespace cg
