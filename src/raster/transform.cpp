#include "raster/transform.h"

#include <atomic>

#include "scene/pass_recorder.h"

namespace cg {

namespace {

float scale_and_offset(float x, float scale, bool made_by_clipping) {
  return made_by_clipping ? x * scale + scale : multiply_add(x, scale, scale);
}

// Rounds to nearest even, the default mode of the processor.
std::int32_t snap(float window) { return std::int32_t(std::lrint((window - 0.5f) * float(subpixels))); }

}  // namespace

std::uint32_t outside_of_view(const glm::vec4& c) {
  std::uint32_t bits = 0;
  if (c.x > c.w) bits |= outside_x_max;
  if (c.x + c.w < 0) bits |= outside_x_min;
  if (c.y > c.w) bits |= outside_y_max;
  if (c.y + c.w < 0) bits |= outside_y_min;
  if (c.z + c.w < 0) bits |= outside_near;
  if (c.z > c.w) bits |= outside_far;
  // One sum finds any NaN or infinity: such a vertex takes its triangles with it.
  const float sum = (std::abs(c.x) + std::abs(c.y)) + (std::abs(c.z) + std::abs(c.w));
  if (!(sum <= 1e38f)) bits |= not_finite;
  return bits;
}

WindowVertex to_window(const glm::vec4& clip, const Viewport& viewport, bool made_by_clipping) {
  const float w_inverse = 1.0f / clip.w;
  WindowVertex v{};
  // The inside of the view volume has w > 0, but for the eye itself, which has no place in the picture.
  if (!(w_inverse > 0 && w_inverse < 1e38f)) {
    v.outside = not_finite;
    return v;
  }
  v.x = scale_and_offset(clip.x * w_inverse, viewport.half_width, made_by_clipping);
  v.y = scale_and_offset(clip.y * w_inverse, viewport.half_height, made_by_clipping);
  v.z = scale_and_offset(clip.z * w_inverse, 0.5f, made_by_clipping);
  v.w_inverse = w_inverse;
  v.snapped_x = snap(v.x);
  v.snapped_y = snap(v.y);
  return v;
}

std::uint32_t transform_vertices(const std::vector<glm::vec3>& positions, const glm::mat4& surface_to_clip,
                                 const Viewport& viewport, Workers& workers, std::vector<WindowVertex>& out) {
  constexpr std::size_t part_size = 16384;
  fit(out, positions.size());
  std::atomic<std::uint32_t> all{0};
  workers.for_each(part_count(positions.size(), part_size), [&](int i) {
    const Part part = part_of(positions.size(), part_size, i);
    std::uint32_t bits = 0;
    for (std::size_t k = part.begin; k < part.end; ++k) {
      const glm::vec4 clip = clip_position(surface_to_clip, positions[k]);
      const std::uint32_t outside = outside_of_view(clip);
      if (outside != 0) {
        out[k].outside = outside;
      } else {
        out[k] = to_window(clip, viewport);
      }
      bits |= out[k].outside;
    }
    all.fetch_or(bits, std::memory_order_relaxed);
  });
  return all.load();
}

}  // namespace cg
