// Half a cube around a point of a patch, its pixels, and what each of them counts: the delta form factor.
// This work is based on: Michael Cohen, Donald Greenberg, The Hemi-Cube: A Radiosity Solution for Complex Environments,
// 1985.
#pragma once
#include <array>
#include <vector>

#include "math/vec.h"
#include "scene/item_drawer.h"
#include "scene/radiosity.h"

namespace cg {

// The frame of a position on a surface with that unit normal: z is the normal.
//
// Of samples x samples positions each is turned about the normal by an angle of its own, `number` of so many equal
// steps of a quarter turn (more turns the pixels onto themselves). What one sees too much of for its coarse pixels
// another sees too little of: an edge that runs along a row of pixels is misplaced by up to half a pixel, which is 1/R
// of it, but at any other angle the errors of the pixels that it crosses cancel but for their root, R^(-3/2) (David
// Kendall, On the number of lattice points inside a random oval, 1948), and positions at different angles err
// independently. The first is turned by the slope of the golden section, which is farthest from all slopes of rows of
// pixels: scenes often have edges along the axes. One that is alone is not turned: x is the world's axis that is least
// parallel to the normal, laid into the plane. Its samples stand a little beside the middles of the pixels, as there
// edges run exactly through those: so each of them belongs to one side.
//
// Edges that are parallel to the normal run up the side faces however a hemicube is turned. There the samples of four
// rows stand aside in turn, so that such an edge is seen at four places in its pixels: what is left is an eighth of a
// pixel, not half of one (Peter Shirley, Discrepancy as a Quality Measure for Sample Distributions, 1991: N-rooks). On
// average they do not stand aside, as a pixel's weight is that of its middle: an error of its own, also 1/R.
HemicubeFrame hemicube_frame(const glm::dvec3& position, const glm::dvec3& normal, std::size_t number = 0,
                             int samples = 1);

// The faces of the cube of side 2 around the point. Unfolded they are a cross with the top in the middle, which
// occupies -1..1 in both directions; the sides are half as high.
enum class HemicubeFace { top, right, left, upper, lower };  // z = 1, x = 1, x = -1, y = 1, y = -1
inline constexpr std::array hemicube_faces{HemicubeFace::top, HemicubeFace::right, HemicubeFace::left,
                                           HemicubeFace::upper, HemicubeFace::lower};

// A point of the unfolded face: s to the right and t up, as in the cross, each measured from the middle of the cross
// where it runs along a whole side of the top (-1..1), and from the face's own border where it runs across the face
// (0..1).
template <class Real>
struct FacePoint {
  Real s, t;
};
inline bool crosses_in_s(HemicubeFace f) { return f == HemicubeFace::right || f == HemicubeFace::left; }
inline bool crosses_in_t(HemicubeFace f) { return f == HemicubeFace::upper || f == HemicubeFace::lower; }

// The point of the cube's surface, in the frame's x, y, z.
glm::dvec3 on_cube(HemicubeFace face, const FacePoint<double>& p);
// Where the face, or its plane, is met on the way from the eye to a point before it, given in the frame's x, y, z: by
// Real or by several at once.
template <class Real>
void project_to_face(HemicubeFace face, const Real& x, const Real& y, const Real& z, Real& s, Real& t, Real& w) {
  switch (face) {
    case HemicubeFace::top:
      w = z, s = x / w, t = y / w;
      break;
    case HemicubeFace::right:
      w = x, s = 1.0f - z / w, t = y / w;
      break;
    case HemicubeFace::left:
      w = -x, s = z / w, t = y / w;
      break;
    case HemicubeFace::upper:
      w = y, s = x / w, t = 1.0f - z / w;
      break;
    case HemicubeFace::lower:
      w = -y, s = x / w, t = z / w;
      break;
  }
}
// Where the sample of a pixel of the face stands.
FacePoint<double> sample_point(const HemicubeFrame& frame, HemicubeFace face, int x, int y, int resolution);
// The coefficients of n . d = a s + b t + c for the directions d to the points of a face.
template <class Real>
void on_face(HemicubeFace face, const Real& x, const Real& y, const Real& z, Real& a, Real& b, Real& c) {
  switch (face) {
    case HemicubeFace::top:
      a = x, b = y, c = z;
      break;
    case HemicubeFace::right:
      a = -z, b = y, c = x + z;
      break;
    case HemicubeFace::left:
      a = z, b = y, c = -x;
      break;
    case HemicubeFace::upper:
      a = x, b = -z, c = y + z;
      break;
    case HemicubeFace::lower:
      a = x, b = z, c = -y;
      break;
  }
}

// Pixels of a face at resolution R: R x R on the top, half of it across a side. Pixel (0, 0) is the lowest s and t.
inline int face_width(HemicubeFace f, int resolution) { return crosses_in_s(f) ? resolution / 2 : resolution; }
inline int face_height(HemicubeFace f, int resolution) { return crosses_in_t(f) ? resolution / 2 : resolution; }
// Where pixel i begins.
inline double pixel_low(bool crosses, int i, int resolution) { return (crosses ? 0 : -1) + 2.0 * i / resolution; }
inline FacePoint<double> pixel_centre(HemicubeFace f, int x, int y, int resolution) {
  const double half = 1.0 / resolution;
  return {pixel_low(crosses_in_s(f), x, resolution) + half, pixel_low(crosses_in_t(f), y, resolution) + half};
}

// An even number of pixels in the range of radiosity.resolution.
int hemicube_resolution(int wanted);

// Delta form factors by the lecture's formulas, at a pixel's centre. Top: dA / (pi (x^2 + y^2 + 1)^2). Side, at height
// z and y along it: z dA / (pi (y^2 + z^2 + 1)^2).
double delta_form_factor_top(double x, double y, double area);
double delta_form_factor_side(double y, double z, double area);
// The same integrated over the pixels [x0, x1] x [y0, y1] and [y0, y1] x [z0, z1], z >= 0: differences of the form
// factor of a rectangle with a corner over the point (Howell, A Catalog of Radiation Heat Transfer Configuration
// Factors, B-3 and B-4).
double integrated_form_factor_top(double x0, double x1, double y0, double y1);
double integrated_form_factor_side(double y0, double y1, double z0, double z1);

// What the pixel counts; `resolution` is even. The lecture's delta_form_factor sums to a little more than 1 (1.32e-4 at
// R = 64, falling as 1/R^2): a closed scene's rows are normalised for that. `integrated` sums to 1 at any resolution.
// The wrong weights are scaled to sum to 1, as otherwise the sum would give them away.
class PixelWeights {
 public:
  PixelWeights(int resolution, PixelWeight weight);
  int resolution() const { return resolution_; }
  float operator()(HemicubeFace f, int x, int y) const {
    return (
        f == HemicubeFace::top
            ? top_
            : sides_[std::size_t(f) - 1])[std::size_t(y) * std::size_t(face_width(f, resolution_)) + std::size_t(x)];
  }
  double face_sum(HemicubeFace f) const { return f == HemicubeFace::top ? top_sum_ : side_sum_; }
  double sum() const { return top_sum_ + 4 * side_sum_; }

 private:
  int resolution_;
  std::vector<float> top_;
  std::array<std::vector<float>, 4> sides_;
  double top_sum_ = 0, side_sum_ = 0;
};

}  // namespace cg
