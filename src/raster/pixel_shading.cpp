#include "raster/pixel_shading.h"

#include <atomic>

#include "raster/interpolation.h"
#include "raster/recent_triangles.h"

namespace cg {

namespace {

constexpr std::size_t rows_a_part = 8;

// Where eight pixels stand: the first one's x; y counted from the bottom; those that show a triangle.
struct Place {
  int x, y;
  LaneBytes covered;
};

template <class Real>
bool shows_back(const DeferredShading<Real>& shading, const SeenTriangle& t) {
  return optional(shading.lighting.two_sided) && !is_front_face(t.window);
}

template <class Real>
const std::vector<Vec3<Real>>& vertex_colours(const DeferredShading<Real>& shading, const SeenTriangle& t) {
  const ShadedVertices<Real>& v = shading.objects[t.index].vertices;
  return shows_back(shading, t) ? v.back : v.front;
}

// Flat shading: the colour of the last vertex.
template <class Real>
class FlatTriangle {
 public:
  FlatTriangle() = default;
  FlatTriangle(const DeferredShading<Real>& shading, const SeenTriangle& t)
      : colour_(vertex_colours(shading, t)[t.vertices[2]]) {}
  void colours(const Place&, LaneVectors<Real>& I) const {
    I = {Lanes<Real>{} + colour_.x, Lanes<Real>{} + colour_.y, Lanes<Real>{} + colour_.z};
  }

 private:
  Vec3<Real> colour_{0};
};

// Gouraud shading: the colours of the vertices, interpolated.
template <class Real>
class GouraudTriangle {
 public:
  GouraudTriangle() = default;
  GouraudTriangle(const DeferredShading<Real>& shading, const SeenTriangle& t)
      : weights_(t.window), colour_(t.corners<Real>(vertex_colours(shading, t))) {}
  void colours(const Place& place, LaneVectors<Real>& I) const {
    Weights<Lanes<Real>> w;
    weights_.at(Lanes<Real>(lane_numbers<Real> + Real(place.x)), Real(place.y), w);
    colour_.at(w, I);
  }

 private:
  TriangleWeights<Real> weights_;
  CornerVectors<Real> colour_;
};

// Pixels whose colour comes from their triangle alone.
template <class Real, class Triangle>
class ColourPixels {
 public:
  ColourPixels(const Drawing& drawing, const DeferredShading<Real>& shading) : drawing_(drawing), shading_(shading) {}

  void shade(const Lanes<std::uint32_t>& ids, const Place& place, LaneVectors<Real>& I) {
    for_each_run(ids, place.covered, [&](std::uint32_t id, const Lanes<std::int32_t>& mask) {
      const Triangle& triangle = recent_.get(id, [&] { return Triangle(shading_, SeenTriangle(drawing_, id)); });
      LaneVectors<Real> colours;
      triangle.colours(place, colours);
      put(mask, colours, I);
    });
  }

 private:
  const Drawing& drawing_;
  const DeferredShading<Real>& shading_;
  RecentTriangles<Triangle> recent_;
};

// Phong shading: point, normal and radiosity interpolated, each where the light depends on it, and the light model at
// each pixel.
template <class Real, bool with_P, bool with_N, bool with_B>
class PhongPixels {
 public:
  PhongPixels(const Drawing& drawing, const DeferredShading<Real>& shading) : drawing_(drawing), shading_(shading) {}

  void shade(const Lanes<std::uint32_t>& ids, const Place& place, LaneVectors<Real>& I) {
    LaneVectors<Real> P{}, N{}, B{};
    Lanes<std::uint32_t> object{};
    for_each_run(ids, place.covered, [&](std::uint32_t id, const Lanes<std::int32_t>& mask) {
      const Triangle& t = recent_.get(id, [&] { return Triangle(shading_, SeenTriangle(drawing_, id)); });
      if constexpr (with_P || with_N || with_B) {
        Weights<Lanes<Real>> w;
        t.weights.at(Lanes<Real>(lane_numbers<Real> + Real(place.x)), Real(place.y), w);
        if constexpr (with_P) put_at(t.P, w, mask, P);
        if constexpr (with_N) put_at(t.N, w, mask, N);
        if constexpr (with_B) put_at(t.B, w, mask, B);
      }
      object = mask ? Lanes<std::uint32_t>{} + t.object : object;
    });
    for_each_run(object, place.covered, [&](std::uint32_t o, const Lanes<std::int32_t>& mask) {
      light(shading_.objects[o], mask, lane_bytes(mask) & place.covered, P, N, B, I);
    });
  }

 private:
  struct Triangle {
    TriangleWeights<Real> weights;
    CornerVectors<Real> P, N, B;
    std::uint32_t object = 0;
    Triangle() = default;
    Triangle(const DeferredShading<Real>& shading, const SeenTriangle& t) : object(std::uint32_t(t.index)) {
      const ShadedVertices<Real>& v = shading.objects[t.index].vertices;
      if constexpr (with_P || with_N || with_B) weights = TriangleWeights<Real>(t.window);
      if constexpr (with_P) P = t.corners<Real>(v.P);
      if constexpr (with_N) N = t.corners<Real>(v.N, shows_back(shading, t) ? Real(-1) : Real(1));
      if constexpr (with_B)
        if (const auto& list = t.object.surface->radiosity; !list.empty()) B = t.corners<Real>(list);
    }
  };

  static void put_at(const CornerVectors<Real>& corners, const Weights<Lanes<Real>>& w, const Lanes<std::int32_t>& mask,
                     LaneVectors<Real>& out) {
    LaneVectors<Real> here;
    corners.at(w, here);
    put(mask, here, out);
  }

  static EightVectors<Real> eight(const LaneVectors<Real>& v) {
    static_assert(lanes == batch_size);
    EightVectors<Real> out;
    std::memcpy(&out.x, &v.x, sizeof v.x), std::memcpy(&out.y, &v.y, sizeof v.y), std::memcpy(&out.z, &v.z, sizeof v.z);
    return out;
  }

  // The lanes `lit` belong to one object. The others are lit with the numbers of one of them, so that nothing out of
  // the ordinary stands there, and left out.
  void light(const ObjectShading<Real>& surface, const Lanes<std::int32_t>& mask, LaneBytes lit,
             const LaneVectors<Real>& P, const LaneVectors<Real>& N, const LaneVectors<Real>& B, LaneVectors<Real>& I) {
    EightVectors<Real> points = eight(P), normals = eight(N), lights;
    const int one = first_lane(lit);
    for (int i = 0; i < lanes && lit != ~LaneBytes(0); ++i)
      if (!has_lane(lit, i)) points.set(i, points.get(one)), normals.set(i, normals.get(one));
    if (with_N && optional(surface.normals.normalize) && surface.light.uses_normal()) units(normals);
    if constexpr (with_B) {
      const EightVectors<Real> radiosity = eight(B);
      surface.light.light(points, normals, lights, surface.light.uses_radiosity() ? &radiosity : nullptr);
    } else {
      surface.light.light(points, normals, lights);
    }
    LaneVectors<Real> colours;
    std::memcpy(&colours.x, &lights.x, sizeof colours.x);
    std::memcpy(&colours.y, &lights.y, sizeof colours.y);
    std::memcpy(&colours.z, &lights.z, sizeof colours.z);
    put(mask, colours, I);
  }

  const Drawing& drawing_;
  const DeferredShading<Real>& shading_;
  RecentTriangles<Triangle> recent_;
};

// Brings colours into a float's range; those that are not numbers become 0. Returns how many of the lanes `covered`
// these are. A sliver's weights may carry a colour beyond float's range.
// In the loop over the picture: a call would carry eight pixels through memory and back.
template <class Real>
[[gnu::always_inline]] inline int finish(const LaneVectors<Real>& I, LaneBytes covered, LaneVectors<float>& out) {
  const Lanes<Real> most = Lanes<Real>{} + Real(1e30), least = -most;
  const auto limited = [&](const Lanes<Real>& c, Lanes<float>& to) {
    const Lanes<Real> above = c < least ? least : c;
    to = __builtin_convertvector(above > most ? most : above, Lanes<float>);
  };
  limited(I.x, out.x), limited(I.y, out.y), limited(I.z, out.z);
  const Lanes<float> sum = out.x + out.y + out.z;
  const Lanes<std::int32_t> bad = sum != sum;
  const LaneBytes bad_bytes = lane_bytes(bad) & covered;
  if (bad_bytes == 0) return 0;
  put(bad, LaneVectors<float>{}, out);
  return lane_count(bad_bytes);
}

// Limited as saturate() does it: a sliver's plane may overshoot.
[[gnu::always_inline]] inline void store_depth(const Lanes<float>& depth, int count, float* to) {
  const Lanes<float> zero{}, one = zero + 1.0f, above = depth > zero ? depth : zero;
  const Lanes<float> limited = above < one ? above : one;
  std::memcpy(to, &limited, std::size_t(count) * sizeof *to);
}

// x y z x y z ... in memory, as Image has them.
[[gnu::always_inline]] inline void store(const LaneVectors<float>& v, int count, glm::vec3* to) {
  // clang-format off
  const Lanes<float> xy0 = __builtin_shufflevector(v.x, v.y, 0, 8, 0, 1, 9, 0, 2, 10);
  const Lanes<float> xy1 = __builtin_shufflevector(v.x, v.y, 0, 3, 11, 0, 4, 12, 0, 5);
  const Lanes<float> xy2 = __builtin_shufflevector(v.x, v.y, 13, 0, 6, 14, 0, 7, 15, 0);
  const Lanes<float> pixels[3] = {__builtin_shufflevector(xy0, v.z, 0, 1, 8, 3, 4, 9, 6, 7),
                                  __builtin_shufflevector(xy1, v.z, 10, 1, 2, 11, 4, 5, 12, 7),
                                  __builtin_shufflevector(xy2, v.z, 0, 13, 2, 3, 14, 5, 6, 15)};
  // clang-format on
  if (count < lanes) {
    std::memcpy(to, pixels, std::size_t(count) * sizeof *to);
    return;
  }
  // One by one: to copy all at once, the processor would wait until they have come to memory.
  float* numbers = &to->x;
  for (int i = 0; i < 3; ++i) std::memcpy(numbers + i * lanes, &pixels[i], sizeof pixels[i]);
}

// Writes eight pixels of the picture, from (x, y) on. Returns how many of them were not finite.
template <class Real, class Pixels>
int shade_group(const VisibilityBuffer& visibility, int x, int y, const LaneVectors<float>& background, Pixels& pixels,
                Frame& frame) {
  const PixelGroup& group = visibility.group(x, y);
  const int count = std::min(visibility.width - x, lanes);
  const Lanes<std::int32_t> empty = group.triangle == no_triangle;
  const LaneBytes covered = ~lane_bytes(empty) & first_lanes(count);
  LaneVectors<float> colour = background;
  int bad = 0;
  if (covered != 0) {
    LaneVectors<Real> I{};
    pixels.shade(group.triangle, {x, visibility.height - 1 - y, covered}, I);
    bad = finish(I, covered, colour);
    put(empty, background, colour);
  }
  store(colour, count, frame.colour.row(y) + x);
  store_depth(group.depth, count, frame.depth.row(y) + x);
  const LaneBytes ones = covered & one_in_each_lane;
  std::memcpy(frame.covered.row(y) + x, &ones, std::size_t(count));
  return bad;
}

// The whole picture, with one `Pixels` for each part.
template <class Real, class Pixels>
void shade_rows(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                const glm::vec3& background, Workers& workers, Frame& frame) {
  const Lanes<float> zero{};
  const LaneVectors<float> nothing_there{zero + background.x, zero + background.y, zero + background.z};
  std::atomic<std::size_t> bad{0};
  const std::size_t height = std::size_t(visibility.height);
  workers.for_each(part_count(height, rows_a_part), [&](int i) {
    const Part rows = part_of(height, rows_a_part, i);
    Pixels pixels(drawing, shading);
    int here = 0;
    // Column by column: what lies above and below shows the same triangles.
    for (int x = 0; x < visibility.width; x += lanes)
      for (std::size_t y = rows.begin; y < rows.end; ++y)
        here += shade_group<Real>(visibility, x, int(y), nothing_there, pixels, frame);
    bad += std::size_t(here);
  });
  frame.nan_pixels = bad.load();
}

template <class Real, bool with_B, class Shade>
void shade_phong(const DeferredShading<Real>& shading, const Shade& shade) {
  if (shading.uses_position)
    return shading.uses_normal ? shade(shade_rows<Real, PhongPixels<Real, true, true, with_B>>)
                               : shade(shade_rows<Real, PhongPixels<Real, true, false, with_B>>);
  return shading.uses_normal ? shade(shade_rows<Real, PhongPixels<Real, false, true, with_B>>)
                             : shade(shade_rows<Real, PhongPixels<Real, false, false, with_B>>);
}

}  // namespace

template <class Real>
void shade_pixels(const Drawing& drawing, const VisibilityBuffer& visibility, const DeferredShading<Real>& shading,
                  const glm::vec3& background, Workers& workers, Frame& frame) {
  const auto shade = [&](const auto& rows) { rows(drawing, visibility, shading, background, workers, frame); };
  if constexpr (only_plain) {
    if (shading.mode == ShadingMode::phong) return shade(shade_rows<Real, PhongPixels<Real, false, true, false>>);
    return shade(shade_rows<Real, ColourPixels<Real, GouraudTriangle<Real>>>);
  }
  switch (shading.mode) {
    case ShadingMode::flat:
      return shade(shade_rows<Real, ColourPixels<Real, FlatTriangle<Real>>>);
    case ShadingMode::gouraud:
      return shade(shade_rows<Real, ColourPixels<Real, GouraudTriangle<Real>>>);
    case ShadingMode::phong:
      return shading.uses_radiosity ? shade_phong<Real, true>(shading, shade)
                                    : shade_phong<Real, false>(shading, shade);
  }
}

template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<float>&, const glm::vec3&,
                           Workers&, Frame&);
template void shade_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<double>&, const glm::vec3&,
                           Workers&, Frame&);

}  // namespace cg
