#include "raster/deferred_shading.h"

#include <atomic>

#include "raster/interpolation.h"
#include "shading/light_batch.h"

namespace cg {

namespace {

constexpr int rows_a_part = 8;
constexpr std::size_t vertices_a_part = 4096;
constexpr std::uint8_t front_bit = 1, back_bit = 2;

int row_parts(const VisibilityBuffer& visibility) { return (visibility.height + rows_a_part - 1) / rows_a_part; }

// run(object, id, row y, first x, last x excluded) for each run of pixels in a row that show the same triangle.
template <class Run>
void for_each_run_of_part(const Drawing& drawing, const VisibilityBuffer& visibility, int part, const Run& run) {
  std::size_t object = 0;
  const int bottom = std::min((part + 1) * rows_a_part, visibility.height);
  for (int y = part * rows_a_part; y < bottom; ++y) {
    const std::uint32_t* triangle = &visibility.triangle[visibility.row(y)];
    for (int x = 0; x < visibility.width;) {
      const std::uint32_t id = triangle[x];
      int end = x + 1;
      while (end < visibility.width && triangle[end] == id) ++end;
      if (id != no_triangle) {
        const DrawnObject& o = drawing.objects[object];
        if (id < o.first || id >= o.end) object = drawing.object_of(id);
        run(object, id, y, x, end);
      }
      x = end;
    }
  }
}

template <class Run>
void for_each_run(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers, const Run& run) {
  workers.for_each(row_parts(visibility), [&](int part) { for_each_run_of_part(drawing, visibility, part, run); });
}

void mark(std::uint8_t& bits, std::uint8_t bit) {
  // Several threads may mark a vertex, each with the same bits.
  std::atomic_ref<std::uint8_t> shared(bits);
  if ((shared.load(std::memory_order_relaxed) & bit) == 0) shared.fetch_or(bit, std::memory_order_relaxed);
}

// Writes a pixel; returns 1 where it was not a number. A sliver's weights may carry a colour beyond float's range.
template <class Real>
[[gnu::always_inline]] inline std::size_t write(glm::vec3& pixel, const Vec3<Real>& colour) {
  constexpr Real most = Real(1e30);
  const glm::vec3 c(glm::min(glm::max(colour, Vec3<Real>(-most)), Vec3<Real>(most)));
  const float sum = c.x + c.y + c.z;
  const bool number = sum == sum;
  pixel = number ? c : glm::vec3(0);
  return number ? 0 : 1;
}

// Points that wait until eight can be lit at once. `done(which, colour)` takes each.
template <class Real, class Which, class Done>
class LightQueue {
 public:
  LightQueue(const EyeLighting<Real>& lighting, Done done) : lighting_(lighting), done_(done) {}

  // N is brought to unit length where the surface's normals are.
  void add(const ObjectShading<Real>& surface, const Vec3<Real>& P, const Vec3<Real>& N, Which which) {
    if (&surface != surface_) flush();
    surface_ = &surface;
    P_.set(count_, P), N_.set(count_, N);
    which_[count_++] = which;
    if (count_ == batch_size) flush();
  }

  void flush() {
    if (count_ == 0) return;
    for (int i = count_; i < batch_size; ++i) P_.set(i, P_.get(0)), N_.set(i, N_.get(0));
    if (surface_->normals.normalize) units(N_);
    EightVectors<Real> I;
    light_points(lighting_, surface_->material, P_, N_, I);
    for (int i = 0; i < count_; ++i) done_(which_[i], I.get(i));
    count_ = 0;
  }

 private:
  const EyeLighting<Real>& lighting_;
  Done done_;
  const ObjectShading<Real>* surface_ = nullptr;
  EightVectors<Real> P_, N_;
  Which which_[batch_size];
  int count_ = 0;
};

}  // namespace

template <class Real>
void mark_visible_vertices(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                           DeferredShading<Real>& shading) {
  for (std::size_t o = 0; o < drawing.objects.size(); ++o)
    shading.objects[o].vertices.visible.assign(drawing.objects[o].vertices.size(), 0);
  const bool flat = shading.mode == ShadingMode::flat;
  for_each_run(drawing, visibility, workers, [&](std::size_t o, std::uint32_t id, int, int, int) {
    const DrawnObject& object = drawing.objects[o];
    auto& visible = shading.objects[o].vertices.visible;
    const std::uint32_t* i = &object.surface->indices[3 * std::size_t(object.source(id))];
    const std::uint8_t bit = shading.lighting.two_sided && !is_front_face(object.window(id)) ? back_bit : front_bit;
    if (!flat) mark(visible[i[0]], bit), mark(visible[i[1]], bit);
    mark(visible[i[2]], bit);
  });
}

template <class Real>
void shade_vertices(const Drawing& drawing, Workers& workers, DeferredShading<Real>& shading) {
  for (std::size_t o = 0; o < drawing.objects.size(); ++o) {
    const DrawnObject& object = drawing.objects[o];
    const Surface& surface = *object.surface;
    ObjectShading<Real>& s = shading.objects[o];
    ShadedVertices<Real>& v = s.vertices;
    const std::size_t count = surface.positions.size();
    const bool phong = shading.mode == ShadingMode::phong;
    (phong ? v.P : v.front).resize(count);
    if (phong) v.N.resize(count);
    if (!phong && shading.lighting.two_sided) v.back.resize(count);
    const Mat4<Real> to_eye(object.to_eye);
    workers.for_each(part_count(count, vertices_a_part), [&](int i) {
      const Part part = part_of(count, vertices_a_part, i);
      const auto store = [](Vec3<Real>* colour, const Vec3<Real>& I) { *colour = I; };
      LightQueue<Real, Vec3<Real>*, decltype(store)> queue(shading.lighting, store);
      for (std::size_t k = part.begin; k < part.end; ++k) {
        if (v.visible[k] == 0) continue;
        const Vec3<Real> P(to_eye * Vec4<Real>(Vec3<Real>(surface.positions[k]), Real(1)));
        const Vec3<Real> N = eye_normal(s.normals, Vec3<Real>(surface.normals[k]));
        if (phong) {
          v.P[k] = P, v.N[k] = N;
        } else {
          if (v.visible[k] & front_bit) queue.add(s, P, N, &v.front[k]);
          if (v.visible[k] & back_bit) queue.add(s, P, -N, &v.back[k]);
        }
      }
      queue.flush();
    });
  }
}

// Flat and Gouraud shading: the vertices' colours, spread over the runs of one part of the picture. Returns how many
// pixels were not finite.
template <class Real>
std::size_t spread_colours(const Drawing& drawing, const VisibilityBuffer& visibility,
                           const DeferredShading<Real>& shading, int part, Frame& frame) {
  std::size_t bad = 0;
  for_each_run_of_part(drawing, visibility, part, [&](std::size_t o, std::uint32_t id, int y, int begin, int end) {
    const DrawnObject& object = drawing.objects[o];
    const ShadedVertices<Real>& v = shading.objects[o].vertices;
    const std::uint32_t* i = &object.surface->indices[3 * std::size_t(object.source(id))];
    const auto window = object.window(id);
    const auto& colours = shading.lighting.two_sided && !is_front_face(window) ? v.back : v.front;
    glm::vec3* pixels = frame.colour.row(y);
    if (shading.mode == ShadingMode::flat) {
      for (int x = begin; x < end; ++x) bad += write(pixels[x], colours[i[2]]);
      return;
    }
    const TrianglePixels<Real> triangle(object, id, window);
    const Vec3<Real> a = colours[i[0]], b = colours[i[1]], c = colours[i[2]];
    for (int x = begin; x < end; ++x)
      bad += write(pixels[x], interpolate(triangle.weights(x, visibility.height - 1 - y), a, b, c));
  });
  return bad;
}

// Phong shading: point and normal interpolated, and the light model at each pixel.
template <class Real>
std::size_t light_pixels(const Drawing& drawing, const VisibilityBuffer& visibility,
                         const DeferredShading<Real>& shading, int part, Frame& frame) {
  std::size_t bad = 0;
  const auto store = [&](glm::vec3* pixel, const Vec3<Real>& I) { bad += write(*pixel, I); };
  LightQueue<Real, glm::vec3*, decltype(store)> queue(shading.lighting, store);
  for_each_run_of_part(drawing, visibility, part, [&](std::size_t o, std::uint32_t id, int y, int begin, int end) {
    const DrawnObject& object = drawing.objects[o];
    const ShadedVertices<Real>& v = shading.objects[o].vertices;
    const std::uint32_t* i = &object.surface->indices[3 * std::size_t(object.source(id))];
    const auto window = object.window(id);
    const TrianglePixels<Real> triangle(object, id, window);
    const Real side = shading.lighting.two_sided && !is_front_face(window) ? Real(-1) : Real(1);
    const Vec3<Real> N0 = side * v.N[i[0]], N1 = side * v.N[i[1]], N2 = side * v.N[i[2]];
    const Vec3<Real> P0 = v.P[i[0]], P1 = v.P[i[1]], P2 = v.P[i[2]];
    for (int x = begin; x < end; ++x) {
      const Vec3<Real> w = triangle.weights(x, visibility.height - 1 - y);
      queue.add(shading.objects[o], interpolate(w, P0, P1, P2), interpolate(w, N0, N1, N2), &frame.colour.at(x, y));
    }
  });
  queue.flush();
  return bad;
}

template <class Real>
void shade_pixels(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                  Workers& workers, Frame& frame) {
  std::atomic<std::size_t> nan_pixels{0};
  workers.for_each(row_parts(visibility), [&](int part) {
    nan_pixels += shading.mode == ShadingMode::phong ? light_pixels(drawing, visibility, shading, part, frame)
                                                     : spread_colours(drawing, visibility, shading, part, frame);
  });
  frame.nan_pixels = nan_pixels.load();
}

void resolve_geometry(const Scene& scene, const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                      Frame& frame) {
  workers.for_each(visibility.height, [&](int y) {
    const float* depth = &visibility.depth[visibility.row(y)];
    const std::uint32_t* triangle = &visibility.triangle[visibility.row(y)];
    float* out = frame.depth.row(y);
    for (int x = 0; x < visibility.width; ++x) out[x] = saturate(depth[x]);  // a sliver's plane may overshoot
    std::uint8_t* covered = frame.covered.row(y);
    for (int x = 0; x < visibility.width; ++x) covered[x] = triangle[x] != no_triangle;
  });
  const bool ids = !frame.object.empty(), normals = !frame.normal.empty();
  if (!ids && !normals) return;
  std::vector<NormalTransform<double>> to_world;
  for (const DrawnObject& o : drawing.objects)
    to_world.push_back(
        normals_to_eye<double>(matrix(scene.objects[std::size_t(o.index)].transform), NormalLength::normalize));
  for_each_run(drawing, visibility, workers, [&](std::size_t o, std::uint32_t id, int y, int begin, int end) {
    const DrawnObject& object = drawing.objects[o];
    const Surface& surface = *object.surface;
    const std::uint32_t source = object.source(id);
    if (ids) {
      std::fill(frame.object.row(y) + begin, frame.object.row(y) + end, std::int32_t(object.index));
      std::fill(frame.triangle.row(y) + begin, frame.triangle.row(y) + end, std::int32_t(surface.triangle[source]));
    }
    if (normals) {
      const TrianglePixels<double> triangle(object, id, object.window(id));
      const std::uint32_t* i = &surface.indices[3 * std::size_t(source)];
      for (int x = begin; x < end; ++x) {
        const glm::dvec3 n =
            interpolate(triangle.weights(x, visibility.height - 1 - y), glm::dvec3(surface.normals[i[0]]),
                        glm::dvec3(surface.normals[i[1]]), glm::dvec3(surface.normals[i[2]]));
        frame.normal.at(x, y) = glm::vec3(eye_normal(to_world[o], n));
      }
    }
  });
}

template void mark_visible_vertices(const Drawing&, const VisibilityBuffer&, Workers&, DeferredShading<float>&);
template void mark_visible_vertices(const Drawing&, const VisibilityBuffer&, Workers&, DeferredShading<double>&);
template void shade_vertices(const Drawing&, Workers&, DeferredShading<float>&);
template void shade_vertices(const Drawing&, Workers&, DeferredShading<double>&);
template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<float>&, Workers&, Frame&);
template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<double>&, Workers&, Frame&);

}  // namespace cg
