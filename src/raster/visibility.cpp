#include "raster/visibility.h"

#include "raster/visibility_threads.h"
#include "scene/pass_recorder.h"

namespace cg {

namespace {

std::vector<TrianglePart> parts_of(const Drawing& drawing, std::size_t part_size) {
  std::vector<TrianglePart> parts;
  for (std::size_t o = 0; o < drawing.objects.size(); ++o) {
    if (optional(drawing.objects[o].tested)) continue;
    const std::size_t count = drawing.objects[o].surface->triangle_count();
    for (int i = 0; i < part_count(count, part_size); ++i) parts.push_back({o, part_of(count, part_size, i)});
  }
  return parts;
}

std::size_t triangle_count(const Drawing& drawing) {
  std::size_t sum = 0;
  for (const DrawnObject& o : drawing.objects) sum += o.surface->triangle_count();
  return sum;
}

// One thread.
void draw_alone(const Drawing& drawing, const std::vector<TrianglePart>& parts, Workers& workers,
                VisibilityBuffer& out) {
  out.clear(out.width, out.height);
  for (const TrianglePart& part : parts) {
    workers.check();
    TriangleQueue queue({&out, 0, out.height});
    draw_part(drawing, part, queue);
    queue.flush();
  }
}

}  // namespace

// `rows` rounded up to whole tiles.
int VisibilityBuffer::whole_tiles(int rows) { return (rows + tile_height - 1) / tile_height * tile_height; }

// Odd: tiles above each other would contend for the same cache lines if they were a power of two apart.
unsigned VisibilityBuffer::groups_a_row(int w) { return unsigned(w + lanes - 1) / lanes | 1u; }

std::size_t VisibilityBuffer::bytes(int w, int h) {
  return std::size_t(whole_tiles(h)) * groups_a_row(w) * sizeof(PixelGroup);
}

void VisibilityBuffer::resize(int w, int h) {
  width = w, height = h;
  groups_a_row_ = groups_a_row(w);
  first_tile_row_ = 0;
  fit(groups_, bytes(w, h) / sizeof(PixelGroup));
}

void VisibilityBuffer::clear_around_row(int w, int h, int y) {
  resize(w, 1);
  height = h;
  first_tile_row_ = unsigned(y / tile_height);
  clear_tile_row(y / tile_height);
}

void VisibilityBuffer::clear(int w, int h) {
  resize(w, h);
  for (int y = 0; y < tile_rows(); ++y) clear_tile_row(y);
}

std::span<PixelGroup> VisibilityBuffer::tile_row(int tile_y) {
  const std::size_t size = std::size_t(groups_a_row_) * tile_height;
  return {groups_.data() + (std::size_t(tile_y) - first_tile_row_) * size, size};
}

void VisibilityBuffer::clear_tile_row(int tile_y) {
  const std::span<PixelGroup> row = tile_row(tile_y);
  std::fill(row.begin(), row.end(), PixelGroup{Lanes<float>{} + 1.0f, Lanes<std::uint32_t>{} + no_triangle});
}

void find_visible(const Drawing& drawing, Workers& workers, ThreadsMemory& memory, VisibilityBuffer& out) {
  const std::size_t threads = std::size_t(workers.threads()), triangles = triangle_count(drawing);
  const bool alone = only_plain || threads == 1;
  const bool apart = !alone && draws_triangles_apart(triangles, out.width, out.height, workers.threads());
  // Of a small mesh every thread shall have some parts.
  const std::size_t part_size = apart ? std::min(triangles / (16 * threads) + 1, triangles_a_part) : triangles_a_part;
  const std::vector<TrianglePart> parts = parts_of(drawing, part_size);
  if (!apart) fit(memory.pictures, 0);
  if (alone || apart) fit(memory.in_band, 0);
  if (alone)
    draw_alone(drawing, parts, workers, out);
  else if (apart)
    draw_triangles_apart(drawing, parts, workers, memory.pictures, out);
  else
    draw_rows_apart(drawing, parts, workers, memory.in_band, out);
}

std::uint32_t visible_at(const Drawing& drawing, int width, int height, int x, int y) {
  VisibilityBuffer buffer;
  buffer.clear_around_row(width, height, y);
  const int from_bottom = height - 1 - y;
  for (const DrawnObject& object : drawing.objects)
    for_each_triangle(object, {0, object.surface->triangle_count()},
                      [&](const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
                        const PixelBox box = pixel_box(v0, v1, v2);
                        const bool near_it =
                            box.low_x <= x && x <= box.high_x && box.low_y <= from_bottom && from_bottom <= box.high_y;
                        if (near_it) draw_triangle({&buffer, y, y + 1}, v0, v1, v2, id);
                      });
  return buffer.triangle(x, y);
}

}  // namespace cg
