#include "raster/layered_pixels.h"

#include "raster/pixel_kinds.h"
#include "raster/texel_lanes.h"
#include "raster/uv_at_pixel.h"
#include "shading/bump.h"

namespace cg {

namespace {

// The light of one triangle's pixels where layers change what the light model is given.
template <class Real>
class LayeredLight {
 public:
  LayeredLight(const DeferredShading<Real>& shading, const LayeredTriangle<Real>& t)
      : shading_(shading), object_(shading.objects[t.index]), t_(t) {
    const ShadedVertices<Real>& v = object_.vertices;
    if (!v.P.empty()) P_ = t.template corners<Vec3<Real>>(v.P);
    if (!v.N.empty()) N_ = t.template corners<Vec3<Real>>(v.N);
    if (object_.light.uses_radiosity()) B_ = t.template corners<Vec3<Real>>(t.object->surface->radiosity);
    if (object_.light.uses_normal())
      for (std::size_t i = 0; i < object_.before_light.size(); ++i)
        if (object_.before_light[i].layer->target == LayerTarget::normal) frames_[i] = frame(object_.before_light[i]);
  }

  Vec3<Real> at(TriangleTexels<Real>& texels) const {
    const Vec3<Real> w = texels.weights();
    SurfaceNumbers<Real> s{object_.material};
    Vec3<Real> N = interpolate(w, N_[0], N_[1], N_[2]);
    const Real length = object_.normals.normalize ? Real(1) : length_and_unit(N).length;
    if (object_.normals.normalize) N = unit(N);
    for (std::size_t i = 0; i < object_.before_light.size(); ++i) {
      const ShadedLayer<Real>& l = object_.before_light[i];
      if (l.layer->target != LayerTarget::normal)
        apply(*l.layer, texels.texel(l), s);
      else if (frames_[i] && length > Real(0))
        N = length * changed(l, *frames_[i], N / length, texels);
    }
    if (object_.light.uses_radiosity()) s.material.emission += interpolate(w, B_[0], B_[1], B_[2]);
    const bool turned = shading_.lighting.two_sided && t_.back;
    return light_point(shading_.lighting, s.material, interpolate(w, P_[0], P_[1], P_[2]), turned ? -N : N);
  }

 private:
  std::optional<TangentFrame<Real>> frame(const ShadedLayer<Real>& l) const {
    auto uv = t_.template source_corners<Vec2<Real>>(t_.object->surface->uv[l.set]);
    for (Vec2<Real>& p : uv) p = l.transform.point(p);
    return tangent_frame(t_.template source_corners<Vec3<Real>>(object_.vertices.P), uv);
  }
  static Vec3<Real> changed(const ShadedLayer<Real>& l, const TangentFrame<Real>& frame, const Vec3<Real>& N,
                            TriangleTexels<Real>& texels) {
    const Real strength = Real(l.layer->scale * l.layer->amount);
    if (l.layer->bump == BumpKind::normal_map) return mapped_normal(N, frame, Vec3<Real>(texels.texel(l)), strength);
    return bumped_normal(N, frame,
                         strength * height_gradient(*l.layer->texture, l.layer->sampling, texels.footprint(l).uv));
  }

  const DeferredShading<Real>& shading_;
  const ObjectShading<Real>& object_;
  const LayeredTriangle<Real>& t_;
  std::array<Vec3<Real>, 3> P_{Vec3<Real>(Real(0)), Vec3<Real>(Real(0)), Vec3<Real>(Real(0))}, N_ = P_, B_ = P_;
  std::array<std::optional<TangentFrame<Real>>, most_layers> frames_;
};

// `Pixels` give the light where layers do not change it.
template <class Real, class Pixels>
class LayeredPixels {
 public:
  LayeredPixels(const Drawing& drawing, const DeferredShading<Real>& shading)
      : drawing_(drawing), shading_(shading), pixels_(drawing, shading) {}

  void shade(const Lanes<std::uint32_t>& ids, const Place& place, LaneVectors<Real>& I) {
    pixels_.shade(ids, place, I);
    for_each_run(ids, place.covered, [&](std::uint32_t id, const Lanes<std::int32_t>& mask) {
      const LayeredTriangle<Real>& t =
          recent_.get(id, [&] { return LayeredTriangle<Real>(SeenTriangle(drawing_, id)); });
      const ObjectShading<Real>& object = shading_.objects[t.index];
      if (object.before_light.empty() && object.after_light.empty()) return;
      change(t, object, place, lane_bytes(mask) & place.covered, I);
    });
  }

 private:
  void change(const LayeredTriangle<Real>& t, const ObjectShading<Real>& object, const Place& place, LaneBytes here,
              LaneVectors<Real>& I) const {
    TriangleTexels<Real> texels(t);
    texels.move_to_eight(place.x, place.y);
    const auto each = [&](const auto& colour) {
      for (int i = 0; i < lanes; ++i) {
        if (!has_lane(here, i)) continue;
        texels.choose(i);
        const Vec3<Real> C = colour(Vec3<Real>(I.x[i], I.y[i], I.z[i]));
        I.x[i] = C.x, I.y[i] = C.y, I.z[i] = C.z;
      }
    };
    if (shading_.mode == ShadingMode::phong && !object.before_light.empty()) {
      const LayeredLight<Real> light(shading_, t);
      each([&](const Vec3<Real>&) { return light.at(texels); });
    }
    for (const ShadedLayer<Real>& l : object.after_light)
      if (!modulate_eight(l, here, texels, I))
        // No blend makes colour of the alpha that was there.
        each([&](const Vec3<Real>& C) {
          return Vec3<Real>(layered(*l.layer, Vec4<Real>(C, Real(1)), texels.texel(l)));
        });
    if (shading_.lighting.clamp) each([](const Vec3<Real>& C) { return saturate(C); });
  }

  // All lanes of one triangle at once, where the layer is plain; false where it is not.
  static bool modulate_eight(const ShadedLayer<Real>& l, LaneBytes here, TriangleTexels<Real>& texels,
                             LaneVectors<Real>& I) {
    const TextureLayer& layer = *l.layer;
    if (!l.plain || layer.blend != LayerBlend::modulate || layer.amount != 1) return false;
    const typename TriangleTexels<Real>::LaneSlopes* w;
    texels.eight(layer.perspective, w);
    const UvPlane<Real>& plane = texels.plane(l);
    const Vec2<Real> column_u = l.transform.difference({Real(1), Real(0)}),
                     column_v = l.transform.difference({Real(0), Real(1)}),
                     offset = l.transform.point({Real(0), Real(0)});
    Lanes<Real> mesh_u, mesh_v;
    plane.place(*w, 0, mesh_u), plane.place(*w, 1, mesh_v);
    Lanes<Real> u = (column_u.x * mesh_u + column_v.x * mesh_v) + offset.x;
    Lanes<Real> v = (column_u.y * mesh_u + column_v.y * mesh_v) + offset.y;
    const LaneMask<Real> mask = __builtin_convertvector(lane_mask(here), LaneMask<Real>);
    const Lanes<Real> zero{}, most = zero + Real(1 << 20);
    u = mask ? u : zero, v = mask ? v : zero;
    if (any(!((u < most) & (u > -most) & (v < most) & (v > -most)))) return false;
    if (uses_mipmaps(layer.sampling.min_filter)) {
      Lanes<Real> u_dx, u_dy, v_dx, v_dy;
      plane.slopes(*w, 0, u_dx, u_dy), plane.slopes(*w, 1, v_dx, v_dy);
      const auto square = [&](const Lanes<Real>& du, const Lanes<Real>& dv, Lanes<Real>& out) {
        const Lanes<Real> x = (column_u.x * du + column_v.x * dv) * Real(l.plain->width());
        const Lanes<Real> y = (column_u.y * du + column_v.y * dv) * Real(l.plain->height());
        out = x * x + y * y;
      };
      Lanes<Real> along_x, along_y;
      square(u_dx, v_dx, along_x), square(u_dy, v_dy, along_y);
      const Lanes<Real> one = zero + Real(1);
      if (any(mask & ((along_x > one) | (along_y > one)))) return false;  // a smaller level
    }
    TexelLanes<Real> T;
    linear_lanes<Real>(*l.plain, layer.sampling, u, v, T);
    const Real scale = Real(layer.scale);
    I.x = mask ? I.x * (T.rgb.x * scale) : I.x;
    I.y = mask ? I.y * (T.rgb.y * scale) : I.y;
    I.z = mask ? I.z * (T.rgb.z * scale) : I.z;
    return true;
  }

  template <class Mask>
  static bool any(const Mask& m) {
    return lane_bytes(__builtin_convertvector(m, Lanes<std::int32_t>)) != 0;
  }
  static Lanes<std::int32_t> lane_mask(LaneBytes here) {
    return __builtin_convertvector(std::bit_cast<Lanes<std::int8_t>>(here), Lanes<std::int32_t>);
  }

  const Drawing& drawing_;
  const DeferredShading<Real>& shading_;
  Pixels pixels_;
  RecentTriangles<LayeredTriangle<Real>> recent_;
};

template <class Real, bool with_B, class Shade>
void shade_layered_phong(const DeferredShading<Real>& shading, const Shade& shade) {
  if (shading.uses_position)
    return shading.uses_normal ? shade(shade_rows<Real, LayeredPixels<Real, PhongPixels<Real, true, true, with_B>>>)
                               : shade(shade_rows<Real, LayeredPixels<Real, PhongPixels<Real, true, false, with_B>>>);
  return shading.uses_normal ? shade(shade_rows<Real, LayeredPixels<Real, PhongPixels<Real, false, true, with_B>>>)
                             : shade(shade_rows<Real, LayeredPixels<Real, PhongPixels<Real, false, false, with_B>>>);
}

}  // namespace

template <class Real>
void shade_layered_pixels(const Drawing& drawing, const VisibilityBuffer& visibility,
                          const DeferredShading<Real>& shading, const glm::vec3& background, Workers& workers,
                          Frame& frame) {
  const auto shade = [&](const auto& rows) { rows(drawing, visibility, shading, background, workers, frame); };
  switch (shading.mode) {
    case ShadingMode::flat:
      return shade(shade_rows<Real, LayeredPixels<Real, ColourPixels<Real, FlatTriangle<Real>>>>);
    case ShadingMode::gouraud:
      return shade(shade_rows<Real, LayeredPixels<Real, ColourPixels<Real, GouraudTriangle<Real>>>>);
    case ShadingMode::phong:
      break;
  }
  return shading.uses_radiosity ? shade_layered_phong<Real, true>(shading, shade)
                                : shade_layered_phong<Real, false>(shading, shade);
}

template void shade_layered_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<float>&,
                                   const glm::vec3&, Workers&, Frame&);
template void shade_layered_pixels(const Drawing&, const VisibilityBuffer&, const DeferredShading<double>&,
                                   const glm::vec3&, Workers&, Frame&);

}  // namespace cg
