#include "raster/clip.h"

namespace cg {

namespace {

struct PolygonVertex {
  glm::vec4 clip;
  glm::vec3 weights;
  bool made;  // by clipping
};

struct Polygon {
  std::array<PolygonVertex, 10> vertices;  // three, and one more for each of six planes at most
  int count = 0;
  void add(const PolygonVertex& v) { vertices[std::size_t(count++)] = v; }
};

// Signed distance, in units of w, from plane 0..5 in the order of the bits; inside is >= 0.
float distance(int plane, const glm::vec4& c) {
  const float coordinate = plane < 2 ? c.x : plane < 4 ? c.y : c.z;
  const bool upper = plane == 0 || plane == 2 || plane == 5;
  return upper ? c.w - coordinate : coordinate + c.w;
}

// The point where the edge from `from` (weight 1 - t) to `to` meets the plane.
PolygonVertex between(const PolygonVertex& from, const PolygonVertex& to, float t) {
  return {from.clip + t * (to.clip - from.clip), from.weights + t * (to.weights - from.weights), true};
}

// Interpolates from the end that lies nearer to the plane, as there the rounding is least.
PolygonVertex crossing(const PolygonVertex& a, float distance_a, const PolygonVertex& b, float distance_b) {
  return std::abs(distance_b) < std::abs(distance_a) ? between(b, a, distance_b / (distance_b - distance_a))
                                                     : between(a, b, -distance_a / (distance_b - distance_a));
}

Polygon clipped_by(int plane, const Polygon& in) {
  Polygon out;
  for (int i = 0; i < in.count; ++i) {
    const PolygonVertex& a = in.vertices[std::size_t(i)];
    const PolygonVertex& b = in.vertices[std::size_t((i + 1) % in.count)];
    const float distance_a = distance(plane, a.clip), distance_b = distance(plane, b.clip);
    if (distance_a >= 0) out.add(a);
    if ((distance_a >= 0) != (distance_b >= 0)) out.add(crossing(a, distance_a, b, distance_b));
  }
  return out;
}

}  // namespace

void clip_triangle(const std::array<glm::vec4, 3>& clip, std::uint32_t source, const Viewport& viewport,
                   std::vector<ClippedTriangle>& out) {
  Polygon polygon;
  std::uint32_t crossed = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    glm::vec3 weights(0);
    weights[int(k)] = 1;
    polygon.add({clip[k], weights, false});
    crossed |= outside_of_view(clip[k]);
  }
  for (int plane = 0; plane < 6 && polygon.count >= 3; ++plane)
    if (crossed & (1u << plane)) polygon = clipped_by(plane, polygon);
  // The fan keeps the polygon's first vertex last, where OpenGL puts the provoking vertex.
  const auto vertex = [&](int i) {
    const PolygonVertex& v = polygon.vertices[std::size_t(i)];
    return to_window(v.clip, viewport, v.made);
  };
  for (int i = 2; i < polygon.count; ++i) {
    const std::array<int, 3> corner{i - 1, i, 0};
    ClippedTriangle t;
    t.source = source;
    std::uint32_t bad = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      t.vertices[k] = vertex(corner[k]);
      t.weights[k] = polygon.vertices[std::size_t(corner[k])].weights;
      bad |= t.vertices[k].outside;
    }
    if (bad == 0) out.push_back(t);
  }
}

void clip_triangles(const Surface& surface, const glm::mat4& surface_to_clip, const Viewport& viewport,
                    const std::vector<WindowVertex>& vertices, Workers& workers, std::vector<ClippedTriangle>& out) {
  constexpr std::size_t part_size = 16384;
  const int parts = part_count(surface.triangle_count(), part_size);
  std::vector<std::vector<ClippedTriangle>> of_part(static_cast<std::size_t>(parts));
  workers.for_each(parts, [&](int p) {
    const Part part = part_of(surface.triangle_count(), part_size, p);
    for (std::size_t t = part.begin; t < part.end; ++t) {
      const std::uint32_t* i = &surface.indices[3 * t];
      const std::uint32_t a = vertices[i[0]].outside, b = vertices[i[1]].outside, c = vertices[i[2]].outside;
      const std::uint32_t any = a | b | c;
      if (any == 0 || (a & b & c) != 0 || (any & not_finite) != 0) continue;
      clip_triangle({clip_position(surface_to_clip, surface.positions[i[0]]),
                     clip_position(surface_to_clip, surface.positions[i[1]]),
                     clip_position(surface_to_clip, surface.positions[i[2]])},
                    std::uint32_t(t), viewport, of_part[std::size_t(p)]);
    }
  });
  out.clear();
  for (const auto& clipped : of_part) out.insert(out.end(), clipped.begin(), clipped.end());
}

}  // namespace cg
