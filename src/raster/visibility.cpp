#include "raster/visibility.h"

#include "raster/triangle_raster.h"
#include "scene/pass_recorder.h"

namespace cg {

namespace {

constexpr std::size_t part_size = 8192;  // triangles a part: less than a millisecond's work

// A run of an object's triangles, and the numbers of those that touch each band, in the order of drawing.
struct TrianglePart {
  std::size_t object;
  Part triangles;
  std::vector<std::vector<std::uint32_t>> of_band;
};

std::vector<TrianglePart> parts_of(const Drawing& drawing) {
  std::vector<TrianglePart> parts;
  for (std::size_t o = 0; o < drawing.objects.size(); ++o) {
    const std::size_t count = drawing.objects[o].surface->triangle_count();
    for (int i = 0; i < part_count(count, part_size); ++i) parts.push_back({o, part_of(count, part_size, i), {}});
  }
  return parts;
}

// `rows` rounded up to whole tiles.
int whole_tiles(int rows) {
  constexpr int tile = VisibilityBuffer::tile_height;
  return (rows + tile - 1) / tile * tile;
}

// Sorts a part's triangles into the bands of `band_rows` rows that they touch.
void sort_into_bands(const Drawing& drawing, int height, int band_rows, int band_count, TrianglePart& part) {
  part.of_band.assign(std::size_t(band_count), {});
  for (auto& list : part.of_band) list.reserve(part_size / std::size_t(band_count) * 2);
  for_each_triangle(drawing.objects[part.object], part.triangles,
                    [&](const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
                      const PixelBox box = pixel_box(v0, v1, v2);
                      if (box.empty()) return;
                      const int first = std::clamp((height - 1 - box.high_y) / band_rows, 0, band_count - 1);
                      const int last = std::clamp((height - 1 - box.low_y) / band_rows, 0, band_count - 1);
                      for (int b = first; b <= last; ++b) part.of_band[std::size_t(b)].push_back(id);
                    });
}

}  // namespace

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

void VisibilityBuffer::clear_tile_row(int tile_y) {
  const std::size_t size = std::size_t(groups_a_row_) * tile_height;
  const auto first = groups_.begin() + std::ptrdiff_t((std::size_t(tile_y) - first_tile_row_) * size);
  std::fill(first, first + std::ptrdiff_t(size),
            PixelGroup{Lanes<float>{} + 1.0f, Lanes<std::uint32_t>{} + no_triangle});
}

std::size_t find_visible(const Drawing& drawing, Workers& workers, VisibilityBuffer& out) {
  std::vector<TrianglePart> parts = parts_of(drawing);
  if (only_plain || workers.threads() == 1) {  // one band: no sorting
    out.clear(out.width, out.height);
    workers.for_each(int(parts.size()), [&](int i) {
      const TrianglePart& part = parts[std::size_t(i)];
      TriangleQueue queue({&out, 0, out.height});
      for_each_triangle(drawing.objects[part.object], part.triangles,
                        [&](const auto&... triangle) { queue.add(triangle...); });
      queue.flush();
    });
    return 0;
  }
  // More bands than threads, so that a thread whose bands are empty takes another's.
  const int band_count = std::min(8 * workers.threads(), std::max(out.height, 1));
  const int band_rows = whole_tiles((out.height + band_count - 1) / band_count);
  workers.for_each(int(parts.size()),
                   [&](int i) { sort_into_bands(drawing, out.height, band_rows, band_count, parts[std::size_t(i)]); });
  workers.for_each(band_count, [&](int b) {
    const Band band{&out, b * band_rows, std::min((b + 1) * band_rows, out.height)};
    for (int y = band.top; y < band.bottom; y += VisibilityBuffer::tile_height)
      out.clear_tile_row(y / VisibilityBuffer::tile_height);
    TriangleQueue queue(band);
    for (const TrianglePart& part : parts) {
      workers.check();
      for (const std::uint32_t id : part.of_band[std::size_t(b)])
        queue.add_seen(drawing.objects[part.object].window(id), id);
    }
    queue.flush();
  });
  std::size_t sorted = 0;
  for (const TrianglePart& part : parts)
    for (const auto& list : part.of_band) sorted += bytes_of(list);
  return sorted;
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
