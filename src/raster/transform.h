// From a surface's positions to the picture: clip space, division by w, viewport, and the grid that vertices are
// snapped to. Follows The OpenGL Graphics System 2.1, sections 2.11 and 2.12, in the order of operations of the
// OpenGL that the picture is compared with.
#pragma once
#include <cstdint>
#include <vector>

#include "raster/workers.h"
#include "shading/clip_position.h"

namespace cg {

// Vertices are snapped to 1/256 of a pixel, OpenGL's SUBPIXEL_BITS = 8 (Mesa's llvmpipe).
inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;

// The six planes of the view volume -w <= x, y, z <= w, as bits: on which sides a vertex lies outside.
inline constexpr std::uint32_t outside_x_max = 1, outside_x_min = 2, outside_y_max = 4, outside_y_min = 8,
                               outside_near = 16, outside_far = 32, not_finite = 64;

// A vertex in window coordinates: x to the right, y UP as in OpenGL, pixel centres at .5; z = depth 0..1.
struct WindowVertex {
  float x, y, z;
  float w_inverse;         // 1/w of clip space
  std::int32_t snapped_x;  // (x - 0.5) * subpixels, rounded to even: pixel i's centre is at i * subpixels
  std::int32_t snapped_y;
  std::uint32_t outside;  // bits; x..snapped_y mean nothing where it is not 0
};

struct Viewport {
  float half_width, half_height;
  Viewport(int width, int height) : half_width(float(width) * 0.5f), half_height(float(height) * 0.5f) {}
};

// a b + c as llvmpipe's compiled vertex and fragment stages do it: fused where the processor can (built with every
// instruction of this machine), as LLVM's fmuladd. Everywhere else a product is rounded before it is added.
inline float multiply_add(float a, float b, float c) {
#ifdef __FMA__
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

// On which sides of the view volume a clip-space position lies.
std::uint32_t outside_of_view(const glm::vec4& clip);

// Division by w and viewport. `clip` lies in the view volume. llvmpipe transforms the vertices that it was given in
// its compiled vertex stage, and those that clipping made (`made_by_clipping`) in plain C.
WindowVertex to_window(const glm::vec4& clip, const Viewport& viewport, bool made_by_clipping = false);

// All positions of a surface. `out` gets one vertex a position; returns the bits of all vertices, or-ed.
std::uint32_t transform_vertices(const std::vector<glm::vec3>& positions, const glm::mat4& surface_to_clip,
                                 const Viewport& viewport, Workers& workers, std::vector<WindowVertex>& out);

}  // namespace cg
