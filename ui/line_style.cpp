#include "ui/line_style.h"

#include <algorithm>

#include "ui/look.h"

namespace cg {

namespace {

glm::vec4 vector_of(ImU32 colour) {
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  return {c.x, c.y, c.z, c.w};
}

}  // namespace

// N as drawn normals are, L as drawn lights, R and H in the specular term's yellow, V white.
ImU32 colour_of(Mark vector) {
  switch (vector) {
    case Mark::vector_N:
      return IM_COL32(120, 215, 225, 255);
    case Mark::vector_L:
      return IM_COL32(255, 244, 200, 255);
    case Mark::vector_R:
      return IM_COL32(240, 180, 60, 255);
    case Mark::vector_H:
      return IM_COL32(240, 228, 66, 255);
    default:
      return IM_COL32(235, 238, 245, 255);
  }
}

LineStyle style_of(float scale, Mark mark) {
  const float w = std::max(1.0f, scale);
  switch (mark) {
    case Mark::edge:
      return {vector_of(faded(IM_COL32(235, 238, 245, 255), 0.55f)), 0.12f, 0.9f * w};
    case Mark::face_normal:
      return {vector_of(IM_COL32(235, 238, 245, 235)), 0.12f, 1.3f * w};
    case Mark::vertex_normal:
      return {vector_of(IM_COL32(120, 215, 225, 255)), 0.12f, 1.3f * w};
    case Mark::light:
      return {vector_of(IM_COL32(255, 244, 200, 130)), 0.35f, 1.1f * w};
    case Mark::selected_light:
      return {vector_of(IM_COL32(255, 244, 200, 230)), 0.35f, 1.5f * w};
    case Mark::axis_x:
      return {vector_of(IM_COL32(213, 94, 0, 255)), 0.3f, 1.8f * w};
    case Mark::axis_y:
      return {vector_of(IM_COL32(0, 158, 115, 255)), 0.3f, 1.8f * w};
    case Mark::axis_z:
      return {vector_of(IM_COL32(86, 180, 233, 255)), 0.3f, 1.8f * w};
    case Mark::vector_edge:
      return {vector_of(IM_COL32(0, 0, 0, 150)), 0.35f, 4.2f * w};
    case Mark::vector_N:
    case Mark::vector_L:
    case Mark::vector_R:
    case Mark::vector_V:
    case Mark::vector_H:
      return {vector_of(colour_of(mark)), 0.35f, 2.2f * w};
    case Mark::probed_face:
      return {vector_of(IM_COL32(255, 255, 255, 200)), 0.2f, 1.4f * w};
    case Mark::patch:
      return {vector_of(patch_colour), 0.35f, 2.2f * w};
    case Mark::other_fill:
      return {vector_of(faded(other_patch_colour, 0.5f)), 0.2f, 1.2f * w};
    case Mark::other_patch:
      return {vector_of(other_patch_colour), 0.35f, 2.2f * w};
    case Mark::camera:
      return {vector_of(IM_COL32(235, 238, 245, 235)), 0.4f, 1.5f * w};
    case Mark::clip_volume:
      return {vector_of(IM_COL32(235, 238, 245, 110)), 0.4f, 1.1f * w};
  }
  return {};
}

}  // namespace cg
