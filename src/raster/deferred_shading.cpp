#include "raster/deferred_shading.h"

#include <atomic>

#include "raster/interpolation.h"
#include "scene/pass_recorder.h"

namespace cg {

namespace {

constexpr std::size_t rows_a_part = 2 * VisibilityBuffer::tile_height;
constexpr std::size_t triangles_a_part = 16384, vertices_a_part = 4096;

// Several threads may mark the same place, each with the same 1.
void mark(std::uint8_t& place) { std::atomic_ref<std::uint8_t>(place).store(1, std::memory_order_relaxed); }

void cleared(std::vector<std::uint8_t>& marks, std::size_t count) {
  fit(marks, count);
  std::fill(marks.begin(), marks.end(), std::uint8_t(0));
}

// Marks the triangles that pixels show.
void mark_visible_triangles(const VisibilityBuffer& visibility, std::uint32_t triangle_count, Workers& workers,
                            std::vector<std::uint8_t>& seen) {
  cleared(seen, triangle_count);
  const std::size_t height = std::size_t(visibility.height);
  workers.for_each(part_count(height, rows_a_part), [&](int i) {
    const Part rows = part_of(height, rows_a_part, i);
    std::uint8_t* places = seen.data();
    for (int x = 0; x < visibility.width; x += lanes)
      for (std::size_t y = rows.begin; y < rows.end; ++y) {
        const Lanes<std::uint32_t>& ids = visibility.group(x, int(y)).triangle;
        const LaneBytes covered = lane_bytes(ids != no_triangle) & first_lanes(visibility.width - x);
        for_each_run(ids, covered, [&](std::uint32_t id, const Lanes<std::int32_t>&) { mark(places[id]); });
      }
  });
}

// Points that wait until eight can be lit at once.
template <class Real>
class LightQueue {
 public:
  explicit LightQueue(const ObjectShading<Real>& surface)
      : surface_(surface), radiosity_(optional(surface.light.uses_radiosity())) {}

  // N is brought to unit length where the surface's normals are; B as the vertex brings it, where its light uses it.
  void add(const Vec3<Real>& P, const Vec3<Real>& N, const Vec3<Real>& B, Vec3<Real>& colour) {
    P_.set(count_, P), N_.set(count_, N);
    if (radiosity_) B_.set(count_, B);
    colour_[count_++] = &colour;
    if (count_ == batch_size) flush();
  }

  void flush() {
    if (count_ == 0) return;
    for (int i = count_; i < batch_size; ++i) P_.set(i, P_.get(0)), N_.set(i, N_.get(0));
    for (int i = count_; i < batch_size && radiosity_; ++i) B_.set(i, B_.get(0));
    if (optional(surface_.normals.normalize) && surface_.light.uses_normal()) units(N_);
    EightVectors<Real> I;
    surface_.light.light(P_, N_, I, radiosity_ ? &B_ : nullptr);
    for (int i = 0; i < count_; ++i) *colour_[i] = I.get(i);
    count_ = 0;
  }

 private:
  const ObjectShading<Real>& surface_;
  const bool radiosity_;
  EightVectors<Real> P_, N_, B_;
  Vec3<Real>* colour_[batch_size];
  int count_ = 0;
};

// Where light is computed at the vertices, so are the numbers that layers give it: their pictures as they are, at level
// 0, since a vertex has no size.
template <class Real>
class LayeredVertex {
 public:
  LayeredVertex(const DeferredShading<Real>& shading, const ObjectShading<Real>& object, const Surface& surface)
      : shading_(shading), object_(object), surface_(surface) {}

  // P, N and B as for LightQueue.
  Vec3<Real> light(std::size_t vertex, const Vec3<Real>& P, const Vec3<Real>& N, const Vec3<Real>& B) const {
    SurfaceNumbers<Real> s{object_.material};
    for (const ShadedLayer<Real>& l : object_.before_light) {
      const Vec2<Real> uv = l.transform.point(Vec2<Real>(surface_.uv[l.set][vertex]));
      apply(*l.layer, texture_at_level(*l.layer->texture, l.layer->sampling, uv, Real(0)), s);
    }
    s.material.emission += B;
    return light_point(shading_.lighting, s.material, P, object_.normals.normalize ? unit(N) : N);
  }

 private:
  const DeferredShading<Real>& shading_;
  const ObjectShading<Real>& object_;
  const Surface& surface_;
};

}  // namespace

template <class Real>
void mark_visible_vertices(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                           DeferredShading<Real>& shading) {
  mark_visible_triangles(visibility, drawing.objects.empty() ? 0 : drawing.objects.back().end, workers, shading.seen);
  const bool flat = optional(shading.mode == ShadingMode::flat), two_sided = optional(shading.lighting.two_sided);
  for (std::size_t o = 0; o < drawing.objects.size(); ++o) {
    const DrawnObject& object = drawing.objects[o];
    ShadedVertices<Real>& v = shading.objects[o].vertices;
    cleared(v.front_seen, object.vertices.size());
    cleared(v.back_seen, two_sided ? object.vertices.size() : 0);
    const std::size_t count = object.end - object.first;
    workers.for_each(part_count(count, triangles_a_part), [&](int i) {
      const Part part = part_of(count, triangles_a_part, i);
      for (std::size_t t = part.begin; t < part.end; ++t) {
        const std::uint32_t id = object.first + std::uint32_t(t);
        if (shading.seen[id] == 0) continue;
        const SeenTriangle triangle(drawing, o, id);
        auto& seen = two_sided && !is_front_face(triangle.window) ? v.back_seen : v.front_seen;
        if (!flat) mark(seen[triangle.vertices[0]]), mark(seen[triangle.vertices[1]]);
        mark(seen[triangle.vertices[2]]);
      }
    });
  }
}

template <class Real>
void shade_vertices(const Drawing& drawing, Workers& workers, DeferredShading<Real>& shading) {
  for (std::size_t o = 0; o < drawing.objects.size(); ++o) {
    const DrawnObject& object = drawing.objects[o];
    const Surface& surface = *object.surface;
    ObjectShading<Real>& s = shading.objects[o];
    ShadedVertices<Real>& v = s.vertices;
    const std::size_t count = surface.positions.size();
    const bool phong = shading.mode == ShadingMode::phong, two_sided = optional(shading.lighting.two_sided);
    const bool position = optional(shading.uses_position), normal = only_plain || shading.uses_normal;
    const bool radiosity = optional(s.light.uses_radiosity());
    fit(v.P, phong && position ? count : 0);
    fit(v.N, phong && normal ? count : 0);
    fit(v.front, phong ? 0 : count);
    fit(v.back, !phong && two_sided ? count : 0);
    if (phong && !position && !normal) continue;
    const Mat4<Real> to_eye(object.to_eye);
    workers.for_each(part_count(count, vertices_a_part), [&](int i) {
      const Part part = part_of(count, vertices_a_part, i);
      LightQueue<Real> queue(s);
      const LayeredVertex<Real> layered(shading, s, surface);
      const bool layers = optional(!s.before_light.empty());
      for (std::size_t k = part.begin; k < part.end; ++k) {
        const bool front = v.front_seen[k] != 0, back = two_sided && v.back_seen[k] != 0;
        if (!front && !back) continue;
        Vec3<Real> P(Real(0)), N(Real(0)), B(Real(0));
        if (position) P = Vec3<Real>(to_eye * Vec4<Real>(Vec3<Real>(surface.positions[k]), Real(1)));
        if (normal) N = eye_normal(s.normals, Vec3<Real>(surface.normals[k]));
        if (phong) {
          if (position) v.P[k] = P;
          if (normal) v.N[k] = N;
        } else {
          if (radiosity) B = Vec3<Real>(surface.radiosity[k]);
          if (layers) {
            if (front) v.front[k] = layered.light(k, P, N, B);
            if (back) v.back[k] = layered.light(k, P, -N, B);
            continue;
          }
          if (front) queue.add(P, N, B, v.front[k]);
          if (back) queue.add(P, -N, B, v.back[k]);
        }
      }
      queue.flush();
    });
  }
}

template void mark_visible_vertices(const Drawing&, const VisibilityBuffer&, Workers&, DeferredShading<float>&);
template void mark_visible_vertices(const Drawing&, const VisibilityBuffer&, Workers&, DeferredShading<double>&);
template void shade_vertices(const Drawing&, Workers&, DeferredShading<float>&);
template void shade_vertices(const Drawing&, Workers&, DeferredShading<double>&);

}  // namespace cg
