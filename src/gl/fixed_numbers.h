// Numbers as colours, for the fixed function has no other output: which triangle, which normal.
#pragma once
#include <epoxy/gl.h>

#include "shading/surface.h"

namespace cg {

// Colours are numbers from here on: no light, no clamping. GL_COLOR_ARRAY is on, and stays on.
void draw_numbers(GLenum shade_model);

// One surface, every vertex of a triangle coloured (draw_number, low half, high half) of the triangle's number, in
// pieces so that little memory is needed. Returns its bytes.
std::size_t draw_numbered(const Surface& surface, int draw_number);
// The same, foretold for a surface of so many triangles.
std::size_t numbered_bytes(std::size_t triangles);
// The triangle's number from the two halves.
std::uint32_t numbered_triangle(float low, float high);

}  // namespace cg
