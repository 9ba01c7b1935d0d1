#include "raster/layered_pixels.h"

#include "raster/pixel_kinds.h"
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
    const bool lit_here = shading_.mode == ShadingMode::phong && !object.before_light.empty();
    std::optional<LayeredLight<Real>> light;
    if (lit_here) light.emplace(shading_, t);
    for (int i = 0; i < lanes; ++i) {
      if (!has_lane(here, i)) continue;
      texels.move_to(place.x + i, place.y);
      Vec4<Real> C(lit_here ? light->at(texels) : Vec3<Real>(I.x[i], I.y[i], I.z[i]), Real(1));
      for (const ShadedLayer<Real>& l : object.after_light) C = layered(*l.layer, C, texels.texel(l));
      if (shading_.lighting.clamp) C = Vec4<Real>(saturate(Vec3<Real>(C)), C.w);
      I.x[i] = C.x, I.y[i] = C.y, I.z[i] = C.z;
    }
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
