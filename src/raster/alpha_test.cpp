#include "raster/alpha_test.h"

#include "raster/triangle_raster.h"
#include "raster/uv_at_pixel.h"

namespace cg {

namespace {

// The rows of one tile row, in which one thread tests all triangles.
template <class Real>
class TileRow {
 public:
  TileRow(const Drawing& drawing, const DeferredShading<Real>& shading, double threshold, int tile_y,
          VisibilityBuffer& out)
      : drawing_(drawing),
        shading_(shading),
        threshold_(float(threshold)),
        top_(tile_y * VisibilityBuffer::tile_height),
        bottom_(std::min(top_ + VisibilityBuffer::tile_height, out.height)),
        out_(out) {
    triangle_.clear_around_row(out.width, out.height, top_);
  }

  void test(std::size_t object) {
    const DrawnObject& o = drawing_.objects[object];
    for_each_triangle(o, {0, o.surface->triangle_count()},
                      [&](const WindowVertex& v0, const WindowVertex& v1, const WindowVertex& v2, std::uint32_t id) {
                        const PixelBox box = inside(pixel_box(v0, v1, v2));
                        if (box.empty()) return;
                        draw_triangle({&triangle_, top_, bottom_}, v0, v1, v2, id);
                        merge(box, object, id);
                      });
  }

 private:
  PixelBox inside(const PixelBox& box) const {
    return {std::max(box.low_x, 0), std::max(box.low_y, out_.height - bottom_), std::min(box.high_x, out_.width - 1),
            std::min(box.high_y, out_.height - 1 - top_)};
  }

  // What one triangle covers goes to the picture where it is nearer, of equal depth where it was drawn first.
  void merge(const PixelBox& box, std::size_t object, std::uint32_t id) {
    const LayeredTriangle<Real> t(SeenTriangle(drawing_, object, id));
    TriangleTexels<Real> texels(t);
    for (int from_bottom = box.low_y; from_bottom <= box.high_y; ++from_bottom) {
      const int y = out_.height - 1 - from_bottom;
      for (int x = box.low_x / lanes * lanes; x <= box.high_x; x += lanes) {
        PixelGroup& from = triangle_.group(x, y);
        PixelGroup& to = out_.group(x, y);
        for (int i = 0; i < std::min(lanes, out_.width - x); ++i) {
          if (from.triangle[i] != id) continue;
          const bool nearer =
              from.depth[i] < to.depth[i] || (from.depth[i] == to.depth[i] && id < to.triangle[i] && to.depth[i] < 1);
          texels.move_to(x + i, from_bottom);
          if (nearer && float(alpha(shading_.objects[object], texels)) > threshold_)
            to.depth[i] = from.depth[i], to.triangle[i] = id;
        }
        from = PixelGroup{Lanes<float>{} + 1.0f, Lanes<std::uint32_t>{} + no_triangle};
      }
    }
  }

  static Real alpha(const ObjectShading<Real>& object, TriangleTexels<Real>& texels) {
    SurfaceNumbers<Real> s{object.material};
    for (const ShadedLayer<Real>& l : object.opacity) apply(*l.layer, texels.texel(l), s);
    Vec4<Real> C(Real(0), Real(0), Real(0), s.opacity);
    for (const ShadedLayer<Real>& l : object.after_light) C = layered(*l.layer, C, texels.texel(l));
    return C.w;
  }

  const Drawing& drawing_;
  const DeferredShading<Real>& shading_;
  const float threshold_;  // as OpenGL compares: a texel of 8 bits is a float
  const int top_, bottom_;
  VisibilityBuffer& out_;
  VisibilityBuffer triangle_;  // what one triangle covers; empty between two
};

}  // namespace

template <class Real>
void test_alpha(const Drawing& drawing, const DeferredShading<Real>& shading, double threshold, Workers& workers,
                VisibilityBuffer& out) {
  workers.for_each(out.tile_rows(), [&](int tile_y) {
    TileRow<Real> row(drawing, shading, threshold, tile_y, out);
    for (std::size_t o = 0; o < drawing.objects.size(); ++o)
      if (drawing.objects[o].tested) row.test(o);
  });
}

template void test_alpha(const Drawing&, const DeferredShading<float>&, double, Workers&, VisibilityBuffer&);
template void test_alpha(const Drawing&, const DeferredShading<double>&, double, Workers&, VisibilityBuffer&);

}  // namespace cg
