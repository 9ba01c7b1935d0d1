#include "gl/fixed_numbers.h"

#include <algorithm>

#include "scene/pass_recorder.h"

namespace cg {

namespace {

// Triangle numbers are split so that each half is exact in float.
constexpr std::uint32_t low_bits = 16, low_mask = 0xffff;
constexpr std::size_t piece = 1 << 15;  // triangles

}  // namespace

void draw_numbers(GLenum shade_model) {
  glDisable(GL_LIGHTING);
  glDisable(GL_COLOR_MATERIAL);
  glShadeModel(shade_model);
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
  glDisableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
}

std::size_t draw_numbered(const Surface& surface, int draw_number) {
  std::vector<glm::vec3> positions, colours;
  positions.reserve(3 * std::min(piece, surface.triangle_count()));
  colours.reserve(positions.capacity());
  for (std::size_t first = 0; first < surface.triangle_count(); first += piece) {
    const std::size_t end = std::min(first + piece, surface.triangle_count());
    positions.clear();
    colours.clear();
    for (std::size_t t = first; t < end; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        positions.push_back(surface.positions[surface.indices[3 * t + k]]);
        colours.emplace_back(float(draw_number), float(t & low_mask), float(t >> low_bits));
      }
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    glColorPointer(3, GL_FLOAT, 0, colours.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(positions.size()));
  }
  return bytes_of(positions) + bytes_of(colours);
}

std::size_t numbered_bytes(std::size_t triangles) { return std::min(piece, triangles) * 3 * 2 * sizeof(glm::vec3); }

std::uint32_t numbered_triangle(float low, float high) {
  return (std::uint32_t(high) << low_bits) | std::uint32_t(low);
}

}  // namespace cg
