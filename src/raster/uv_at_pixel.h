// Texture coordinates over a visible triangle: perspective-correct, or linear over the picture as early hardware had
// them. This work is based on: The OpenGL Graphics System 2.1, section 3.5.1, equation 3.6; Paul Heckbert and Henry
// Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991.
#pragma once
#include "raster/deferred_shading.h"
#include "raster/interpolation.h"

namespace cg {

// What is read of a visible triangle again and again.
template <class Real>
struct LayeredTriangle {
  TriangleWeights<Real> weights;
  const DrawnObject* object = nullptr;
  const std::uint32_t* vertices = nullptr;
  const std::array<glm::vec3, 3>* cut = nullptr;
  std::uint32_t index = 0;  // of the object in Drawing::objects
  bool back = false;

  LayeredTriangle() = default;
  explicit LayeredTriangle(const SeenTriangle& t)
      : weights(t.window),
        object(&t.object),
        vertices(t.vertices),
        cut(t.cut),
        index(std::uint32_t(t.index)),
        back(!is_front_face(t.window)) {}

  // What stands in a list for its vertices; those that clipping made have theirs interpolated.
  template <class Vector, class From>
  std::array<Vector, 3> corners(const std::vector<From>& list) const {
    const std::array<Vector, 3> whole = source_corners<Vector>(list);
    if (!cut) return whole;
    const auto of = [&](const glm::vec3& w) {
      using Real_ = typename Vector::value_type;
      return whole[0] + (Real_(w.y) * (whole[1] - whole[0]) + Real_(w.z) * (whole[2] - whole[0]));
    };
    return {of((*cut)[0]), of((*cut)[1]), of((*cut)[2])};
  }
  // Of the surface's triangle that it is, or was cut from.
  template <class Vector, class From>
  std::array<Vector, 3> source_corners(const std::vector<From>& list) const {
    return {Vector(list[vertices[0]]), Vector(list[vertices[1]]), Vector(list[vertices[2]])};
  }
};

// A triangle's texture coordinates in one set, at its pixels.
template <class Real>
class UvPlane {
 public:
  UvPlane() = default;
  UvPlane(const LayeredTriangle<Real>& t, std::size_t set) {
    const auto uv = t.template corners<Vec2<Real>>(t.object->surface->uv[set]);
    a_ = uv[0], to_b_ = uv[1] - uv[0], to_c_ = uv[2] - uv[0];
  }
  Footprint<Real> at(const typename TriangleWeights<Real>::template Slopes<Real>& w) const {
    return {a_ + (w.b * to_b_ + w.c * to_c_), w.b_dx * to_b_ + w.c_dx * to_c_, w.b_dy * to_b_ + w.c_dy * to_c_};
  }
  // Of eight pixels, component by component.
  using LaneSlopes = typename TriangleWeights<Real>::template Slopes<Lanes<Real>>;
  void place(const LaneSlopes& w, int axis, Lanes<Real>& out) const {
    out = a_[axis] + (w.b * to_b_[axis] + w.c * to_c_[axis]);
  }
  void slopes(const LaneSlopes& w, int axis, Lanes<Real>& dx, Lanes<Real>& dy) const {
    dx = w.b_dx * to_b_[axis] + w.c_dx * to_c_[axis];
    dy = w.b_dy * to_b_[axis] + w.c_dy * to_c_[axis];
  }

 private:
  Vec2<Real> a_{0}, to_b_{0}, to_c_{0};
};

// The same in all sets, for both ways to interpolate, at one pixel after the other.
template <class Real>
class TriangleTexels {
 public:
  using Slopes = typename TriangleWeights<Real>::template Slopes<Real>;
  using LaneSlopes = typename TriangleWeights<Real>::template Slopes<Lanes<Real>>;

  explicit TriangleTexels(const LayeredTriangle<Real>& t) : t_(t) {
    for (std::size_t s = 0; s < t.object->surface->uv.size(); ++s) planes_[s] = UvPlane<Real>(t, s);
  }
  const UvPlane<Real>& plane(const ShadedLayer<Real>& l) const { return planes_[l.set]; }

  // The pixel; y counted from the bottom.
  void move_to(int x, int y) { x_ = Real(x), y_ = Real(y), lane_ = -1, correct_.known = affine_.known = false; }
  // Eight pixels, and then one of them.
  void move_to_eight(int x, int y) { x_ = Real(x), y_ = Real(y), correct_.known = affine_.known = false; }
  void choose(int lane) { lane_ = lane; }
  void eight(bool perspective, const LaneSlopes*& out) {
    Weights& w = perspective ? correct_ : affine_;
    if (!w.known) t_.weights.at(Lanes<Real>(lane_numbers<Real> + x_), y_, perspective, w.eight), w.known = true;
    out = &w.eight;
  }

  // In the picture's own coordinates.
  Footprint<Real> footprint(const ShadedLayer<Real>& l) {
    return l.transform.footprint(planes_[l.set].at(one(l.layer->perspective)));
  }
  Vec4<Real> texel(const ShadedLayer<Real>& l) {
    return texture_colour(*l.layer->texture, l.layer->sampling, footprint(l));
  }
  Vec3<Real> weights() {
    const Slopes w = one(true);
    return {Real(1) - w.b - w.c, w.b, w.c};
  }

 private:
  struct Weights {
    LaneSlopes eight;
    Slopes one;
    bool known = false;
  };
  Slopes one(bool perspective) {
    Weights& w = perspective ? correct_ : affine_;
    if (lane_ >= 0) {
      const LaneSlopes* e;
      eight(perspective, e);
      const int i = lane_;
      return {e->b[i], e->c[i], e->b_dx[i], e->b_dy[i], e->c_dx[i], e->c_dy[i]};
    }
    if (!w.known) t_.weights.at(x_, y_, perspective, w.one), w.known = true;
    return w.one;
  }

  const LayeredTriangle<Real>& t_;
  std::array<UvPlane<Real>, most_layers> planes_;
  Real x_ = 0, y_ = 0;
  int lane_ = -1;
  Weights correct_, affine_;
};

}  // namespace cg
