#include "raster/visibility_threads.h"

#include <mutex>

#include "scene/pass_recorder.h"

namespace cg {

namespace {

// Bands of rows, each drawn by one thread, and the triangles of each part that touch each band, in the order of
// drawing.
class Bands {
 public:
  // More bands than threads, so that a thread whose bands are empty takes another's.
  Bands(int threads, int height)
      : height_(height),
        count_(std::min(8 * threads, std::max(height, 1))),
        rows_(VisibilityBuffer::whole_tiles((height + count_ - 1) / count_)) {}

  int count() const { return count_; }
  Band band(VisibilityBuffer& out, int b) const { return {&out, b * rows_, std::min((b + 1) * rows_, height_)}; }

  // Sorts a part's triangles into the bands that they touch: `lists`, one a band.
  void sort(const Drawing& drawing, const TrianglePart& part, std::vector<std::uint32_t>* lists) const {
    for (int b = 0; b < count_; ++b) lists[b].clear(), lists[b].reserve(triangles_a_part / std::size_t(count_) * 2);
    for_each_triangle(drawing.objects[part.object], part.triangles,
                      [&](const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
                        const PixelBox box = pixel_box(v0, v1, v2);
                        if (box.empty()) return;
                        const int first = band_of(box.high_y), last = band_of(box.low_y);
                        for (int b = first; b <= last; ++b) lists[b].push_back(id);
                      });
  }

 private:
  int band_of(int y) const { return std::clamp((height_ - 1 - y) / rows_, 0, count_ - 1); }
  int height_, count_, rows_;
};

// Its place in the order of drawing; of two cut from the same triangle it is the same.
std::uint32_t order_of(const Drawing& drawing, std::uint32_t id) {
  const DrawnObject& object = drawing.objects[drawing.object_of(id)];
  return object.first + object.source(id);
}

// Of two pictures of different triangles what lies in front; at the same depth what was drawn first.
class Merging {
 public:
  explicit Merging(const Drawing& drawing) : drawing_(drawing) {
    for (const DrawnObject& o : drawing.objects) ids_in_order_ = ids_in_order_ && o.clipped.empty();
  }

  void merge(const PixelGroup& from, PixelGroup& to) const {
    Lanes<std::int32_t> wins = from.depth < to.depth;
    const Lanes<std::int32_t> ties = (from.depth == to.depth) & (from.triangle != to.triangle);
    if (const LaneBytes tied = lane_bytes(ties); tied != 0) {
      Lanes<std::int32_t> first;
      find_first(from.triangle, to.triangle, tied, first);
      wins |= ties & first;
    }
    to.depth = wins ? from.depth : to.depth;
    to.triangle = wins ? from.triangle : to.triangle;
  }

 private:
  // `first`: -1 where `a` was drawn before `b`; asked for in the lanes `tied` alone.
  void find_first(const Lanes<std::uint32_t>& a, const Lanes<std::uint32_t>& b, LaneBytes tied,
                  Lanes<std::int32_t>& first) const {
    first = a < b;
    for (int i = 0; i < lanes && !ids_in_order_; ++i)
      if (has_lane(tied, i)) first[i] = order_of(drawing_, a[i]) < order_of(drawing_, b[i]) ? -1 : 0;
  }

  const Drawing& drawing_;
  bool ids_in_order_ = true;
};

}  // namespace

// To sort costs by the triangle, to clear and to merge pictures by the pixel, and in both ways the threads share it. By
// measurement (two threads, 1024x1024) the ways cost the same at about 100000 triangles.
bool draws_triangles_apart(std::size_t triangles, int width, int height, int threads) {
  return threads > 1 && 20 * triangles >= std::size_t(width) * std::size_t(height) * std::size_t(threads);
}

std::size_t ThreadsMemory::bytes() const {
  std::size_t sum = 0;
  for (const VisibilityBuffer& picture : pictures) sum += picture.bytes();
  for (const auto& list : in_band) sum += bytes_of(list);
  return sum;
}

void draw_rows_apart(const Drawing& drawing, const std::vector<TrianglePart>& parts, Workers& workers,
                     std::vector<std::vector<std::uint32_t>>& in_band, VisibilityBuffer& out) {
  const Bands bands(workers.threads(), out.height);
  const std::size_t count = std::size_t(bands.count());
  in_band.resize(parts.size() * count);
  workers.for_each(int(parts.size()),
                   [&](int i) { bands.sort(drawing, parts[std::size_t(i)], &in_band[std::size_t(i) * count]); });
  workers.for_each(bands.count(), [&](int b) {
    const Band band = bands.band(out, b);
    for (int y = band.top; y < band.bottom; y += VisibilityBuffer::tile_height)
      out.clear_tile_row(y / VisibilityBuffer::tile_height);
    TriangleQueue queue(band);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      workers.check();
      for (const std::uint32_t id : in_band[i * count + std::size_t(b)])
        queue.add_seen(drawing.objects[parts[i].object].window(id), id);
    }
    queue.flush();
  });
}

void draw_triangles_apart(const Drawing& drawing, const std::vector<TrianglePart>& parts, Workers& workers,
                          std::vector<VisibilityBuffer>& pictures, VisibilityBuffer& out) {
  const std::size_t threads = std::size_t(workers.threads());
  pictures.resize(threads - 1);
  // First one run for each thread; then, for who is ready, runs that become shorter, so that all end together.
  const std::size_t first_run = parts.size() / (2 * threads);
  std::mutex taking;
  std::size_t taken = threads * first_run;
  const auto take = [&] {
    const std::lock_guard lock(taking);
    const std::size_t begin = taken;
    taken += (parts.size() - taken + 2 * threads - 1) / (2 * threads);
    return Part{begin, taken};
  };
  workers.for_each(int(threads), [&](int t) {
    VisibilityBuffer& mine = t == 0 ? out : pictures[std::size_t(t - 1)];
    mine.clear(out.width, out.height);
    TriangleQueue queue({&mine, 0, out.height});
    const auto draw = [&](const Part& run) {
      for (std::size_t i = run.begin; i < run.end; ++i) workers.check(), draw_part(drawing, parts[i], queue);
    };
    draw({std::size_t(t) * first_run, std::size_t(t + 1) * first_run});
    for (Part run = take(); run.begin < run.end; run = take()) draw(run);
    queue.flush();
  });
  const Merging merging(drawing);
  workers.for_each(out.tile_rows(), [&](int tile_y) {
    const std::span<PixelGroup> to = out.tile_row(tile_y);
    for (VisibilityBuffer& picture : pictures) {
      const std::span<const PixelGroup> from = picture.tile_row(tile_y);
      for (std::size_t i = 0; i < to.size(); ++i) merging.merge(from[i], to[i]);
    }
  });
}

}  // namespace cg
