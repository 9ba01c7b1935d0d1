// Perspective-correct interpolation over a visible triangle.
// This work is based on: The OpenGL Graphics System 2.1, section 3.5.1, equation 3.6:
//   f = (a f_a / w_a + b f_b / w_b + c f_c / w_c) / (a / w_a + b / w_b + c / w_c)
#pragma once
#include "raster/drawing.h"
#include "raster/lanes.h"

namespace cg {

// The weights of a triangle's three vertices, at one pixel or at eight (Number: Real or Lanes<Real>); their sum is 1.
template <class Number>
struct Weights {
  Number a, b, c;
};

// The weights of a triangle's vertices at a pixel. As in OpenGL they come from the vertices before snapping, so at a
// pixel whose centre was gained by snapping one of them is a little below 0.
template <class Real>
class TriangleWeights {
 public:
  TriangleWeights() = default;
  explicit TriangleWeights(const std::array<const WindowVertex*, 3>& v) {
    const Real x0 = Real(v[0]->x), y0 = Real(v[0]->y);
    const Real x1 = Real(v[1]->x) - x0, y1 = Real(v[1]->y) - y0;
    const Real x2 = Real(v[2]->x) - x0, y2 = Real(v[2]->y) - y0;
    const Real area = x1 * y2 - x2 * y1;
    const Real s = std::abs(area) > Real(1e-15) ? Real(1) / area : Real(0);  // a line before snapping: the first vertex
    x_ = x0 - Real(0.5), y_ = y0 - Real(0.5);
    b_dx_ = y2 * s, b_dy_ = -x2 * s;
    c_dx_ = -y1 * s, c_dy_ = x1 * s;
    w_a_ = Real(v[0]->w_inverse), w_b_ = Real(v[1]->w_inverse), w_c_ = Real(v[2]->w_inverse);
    // Only their ratio counts: far away they would make a product that float cannot hold.
    if (const Real largest = std::max({w_a_, w_b_, w_c_}); !(largest > Real(1e-15) && largest < Real(1e15))) {
      w_a_ /= largest, w_b_ /= largest, w_c_ /= largest;
    }
  }

  // (x, y): the pixels, y counted from the bottom.
  template <class Number>
  void at(const Number& x, Real y, Weights<Number>& out) const {
    const Number px = x - x_;
    const Real py = y - y_;
    const Number b = px * b_dx_ + py * b_dy_, c = px * c_dx_ + py * c_dy_;
    const Number aw = (Real(1) - b - c) * w_a_, bw = b * w_b_, cw = c * w_c_;
    const Number sum = aw + bw + cw, one = Number{} + Real(1);
    const Number s = Real(1) / (sum != Real(0) ? sum : one);
    out.a = aw * s, out.b = bw * s, out.c = cw * s;
  }
  // The weights of the second and the third vertex, and how they change to the pixel to the right (dx) and above (dy):
  // the derivatives at the pixel. Not `perspective`: linear over the picture.
  template <class Number>
  struct Slopes {
    Number b, c, b_dx, b_dy, c_dx, c_dy;
  };
  template <class Number>
  void at(const Number& x, Real y, bool perspective, Slopes<Number>& out) const {
    const Number px = x - x_;
    const Real py = y - y_;
    const Number zero{}, b = px * b_dx_ + py * b_dy_, c = px * c_dx_ + py * c_dy_;
    out = {b, c, zero + b_dx_, zero + b_dy_, zero + c_dx_, zero + c_dy_};
    if (!perspective) return;
    const Real to_b = w_b_ - w_a_, to_c = w_c_ - w_a_;
    const Number sum = w_a_ + b * to_b + c * to_c, one = zero + Real(1);
    const Number s = Real(1) / (sum != Real(0) ? sum : one);
    out.b = b * w_b_ * s, out.c = c * w_c_ * s;
    const Real sum_dx = b_dx_ * to_b + c_dx_ * to_c, sum_dy = b_dy_ * to_b + c_dy_ * to_c;
    out.b_dx = (b_dx_ * w_b_ - out.b * sum_dx) * s, out.b_dy = (b_dy_ * w_b_ - out.b * sum_dy) * s;
    out.c_dx = (c_dx_ * w_c_ - out.c * sum_dx) * s, out.c_dy = (c_dy_ * w_c_ - out.c * sum_dy) * s;
  }
  Vec3<Real> at(int x, int y) const {
    Weights<Real> w;
    at(Real(x), Real(y), w);
    return {w.a, w.b, w.c};
  }

 private:
  Real x_ = 0, y_ = 0, b_dx_ = 0, b_dy_ = 0, c_dx_ = 0, c_dy_ = 0, w_a_ = 1, w_b_ = 1, w_c_ = 1;
};

template <class Real>
Vec3<Real> interpolate(const Vec3<Real>& weights, const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) {
  // The differences, so that a constant stays exactly itself.
  return a + (weights.y * (b - a) + weights.z * (c - a));
}

// A vector at a triangle's three vertices, to be interpolated at many pixels.
template <class Real>
class CornerVectors {
 public:
  CornerVectors() = default;
  CornerVectors(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) : a_(a), to_b_(b - a), to_c_(c - a) {}

  // As interpolate() does it.
  void at(const Weights<Lanes<Real>>& w, LaneVectors<Real>& out) const {
    out.x = a_.x + (w.b * to_b_.x + w.c * to_c_.x);
    out.y = a_.y + (w.b * to_b_.y + w.c * to_c_.y);
    out.z = a_.z + (w.b * to_b_.z + w.c * to_c_.z);
  }
  Vec3<Real> at(const glm::vec3& weights) const { return a_ + (Real(weights.y) * to_b_ + Real(weights.z) * to_c_); }

 private:
  Vec3<Real> a_{0}, to_b_{0}, to_c_{0};
};

// The weights of the source triangle's own vertices, where the visible one was cut from it.
template <class Real>
Vec3<Real> of_source(const std::array<glm::vec3, 3>& weights, const Vec3<Real>& w) {
  return w.x * Vec3<Real>(weights[0]) + w.y * Vec3<Real>(weights[1]) + w.z * Vec3<Real>(weights[2]);
}

// Is the front face seen: counter-clockwise in the window (glFrontFace( GL_CCW )).
inline bool is_front_face(const std::array<const WindowVertex*, 3>& v) {
  const std::int64_t x1 = v[1]->snapped_x - v[0]->snapped_x, y1 = v[1]->snapped_y - v[0]->snapped_y;
  const std::int64_t x2 = v[2]->snapped_x - v[0]->snapped_x, y2 = v[2]->snapped_y - v[0]->snapped_y;
  return x1 * y2 - x2 * y1 > 0;
}

// A visible triangle and the surface's triangle that it is, or was cut from.
struct SeenTriangle {
  std::size_t index;  // of the object in Drawing::objects
  const DrawnObject& object;
  std::uint32_t source;
  const std::uint32_t* vertices;  // three
  std::array<const WindowVertex*, 3> window;
  const std::array<glm::vec3, 3>* cut;  // the weights of its vertices where it was cut, or null

  SeenTriangle(const Drawing& drawing, std::size_t object_index, std::uint32_t id)
      : index(object_index),
        object(drawing.objects[object_index]),
        source(object.source(id)),
        vertices(&object.surface->indices[3 * std::size_t(source)]),
        window(object.window(id)),
        cut(object.is_clipped(id) ? &object.clipped_triangle(id).weights : nullptr) {}
  SeenTriangle(const Drawing& drawing, std::uint32_t id) : SeenTriangle(drawing, drawing.object_of(id), id) {}

  // What stands in a list for its three vertices; those that clipping made have theirs interpolated.
  template <class Real, class Vector>
  CornerVectors<Real> corners(const std::vector<Vector>& list, Real factor = Real(1)) const {
    const CornerVectors<Real> whole(factor * Vec3<Real>(list[vertices[0]]), factor * Vec3<Real>(list[vertices[1]]),
                                    factor * Vec3<Real>(list[vertices[2]]));
    return cut ? CornerVectors<Real>(whole.at((*cut)[0]), whole.at((*cut)[1]), whole.at((*cut)[2])) : whole;
  }
};

}  // namespace cg
