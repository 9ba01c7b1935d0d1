// What gives eight pixels their colours, for each way of shading.
// This work is based on: Henri Gouraud, Continuous Shading of Curved Surfaces, 1971; Bui Tuong Phong, Illumination for
// Computer Generated Pictures, 1975.
#pragma once
#include "raster/interpolation.h"
#include "raster/pixel_rows.h"
#include "raster/recent_triangles.h"

namespace cg {

// Of each file that includes it: the compiler knows all calls, and the loops over a picture hold what they call.
namespace {

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

}  // namespace

}  // namespace cg
