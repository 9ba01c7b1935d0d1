// The triangle that one pixel shows, found by the same steps as a whole picture's, with what is interpolated over it.
#pragma once
#include <optional>

#include "raster/interpolation.h"

namespace cg {

struct PixelTriangle {
  DrawnObject object;
  std::uint32_t id = 0;  // one of the object's numbers
  int x = 0, y = 0;      // the pixel, y counted from the bottom

  bool is_front() const { return is_front_face(object.window(id)); }
  // The triangle in the surface's list.
  std::uint32_t source() const { return object.source(id); }
  // Of the surface's three vertices of that triangle, as colours, points and normals are interpolated.
  template <class Real>
  Vec3<Real> weights() const {
    const Vec3<Real> w = TriangleWeights<Real>(object.window(id)).at(x, y);
    return object.is_clipped(id) ? of_source(object.clipped_triangle(id).weights, w) : w;
  }
};

// What pixel (x, y) of the picture shows, row 0 at the top; nothing where it shows the background. Meshes are loaded,
// the pixel is inside the picture. Throws Cancelled.
std::optional<PixelTriangle> triangle_at(const Scene& scene, const View& view, int x, int y, Progress& progress);

// The same where it is known what is there: `object` and `triangle` as in Frame. Where clipping cut the triangle, the
// piece that the pixel lies in or nearest to.
std::optional<PixelTriangle> triangle_at(const Scene& scene, const View& view, int x, int y, int object, int triangle,
                                         Progress& progress);

}  // namespace cg
