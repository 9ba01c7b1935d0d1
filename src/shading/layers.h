// What layers of textures make of a surface's numbers at one point, in float or double.
// This work is based on: The OpenGL Graphics System 2.1, section 3.8.13, tables 3.22 and 3.23 (texture environment).
#pragma once
#include <vector>

#include "math/transform.h"
#include "scene/texture_layer.h"
#include "shading/light_model.h"
#include "shading/texture_lookup.h"

namespace cg {

// GL_TEXTURE_ENV_MODE of colour and alpha: C what was there, T the texture, `C_c` GL_TEXTURE_ENV_COLOR.
template <class Real>
Vec4<Real> blended(LayerBlend how, const Vec4<Real>& C, const Vec4<Real>& T, const Vec3<Real>& C_c) {
  const Vec3<Real> c(C), t(T);
  switch (how) {
    case LayerBlend::replace:
      return T;
    case LayerBlend::modulate:
      return C * T;
    case LayerBlend::decal:
      return {c * (Real(1) - T.w) + t * T.w, C.w};
    case LayerBlend::blend:
      return {c * (Vec3<Real>(Real(1)) - t) + C_c * t, C.w * T.w};
    case LayerBlend::add:
      return {c + t, C.w * T.w};
  }
  return C;
}

// C, the picture's numbers `texel` and the layer's own: what is there after the layer.
template <class Real>
Vec4<Real> layered(const TextureLayer& layer, const Vec4<Real>& C, const Vec4<Real>& texel) {
  const Vec4<Real> T(Vec3<Real>(texel) * Real(layer.scale), texel.w);
  const Vec4<Real> all = blended(layer.blend, C, T, Vec3<Real>(layer.blend_colour));
  return layer.amount == 1 ? all : C + (all - C) * Real(layer.amount);
}

// The numbers of a surface that a layer can change before light is computed.
template <class Real>
struct SurfaceNumbers {
  EyeMaterial<Real> material;
  Vec3<Real> k_r{Real(0)}, k_t{Real(0)};
  Real opacity = Real(1);
};

// Changes what the layer's target names; `colour` and `normal` are not among these numbers. Of n and opacity, which are
// one number, the picture's red counts; opacity takes its alpha where the picture has one (is not 1 everywhere).
template <class Real>
void apply(const TextureLayer& layer, const Vec4<Real>& texel, SurfaceNumbers<Real>& s) {
  const auto colour = [&](Vec3<Real>& c) { c = Vec3<Real>(layered(layer, Vec4<Real>(c, Real(1)), texel)); };
  const auto number = [&](Real& x, Real t) { x = layered(layer, Vec4<Real>(x), Vec4<Real>(t, t, t, texel.w)).x; };
  switch (layer.target) {
    case LayerTarget::k_a:
      return colour(s.material.k_a);
    case LayerTarget::k_d:
      return colour(s.material.k_d);
    case LayerTarget::k_s:
      return colour(s.material.k_s);
    case LayerTarget::k_r:
      return colour(s.k_r);
    case LayerTarget::k_t:
      return colour(s.k_t);
    case LayerTarget::emission:
      return colour(s.material.emission);
    case LayerTarget::n:
      number(s.material.n, texel.x);
      s.material.n = std::clamp(s.material.n, Real(0), Real(1e6));
      return;
    case LayerTarget::opacity:
      number(s.opacity, texel.w);
      s.opacity = saturate(s.opacity);
      return;
    case LayerTarget::colour:
    case LayerTarget::normal:
      return;
  }
}

// Those that count, in order: visible, with a picture, and where some are solo only these.
inline std::vector<const TextureLayer*> counting(const std::vector<TextureLayer>& layers) {
  const auto there = [](const TextureLayer& l) { return l.visible && l.texture && l.amount > 0; };
  bool solo = false;
  for (const TextureLayer& l : layers) solo = solo || (there(l) && l.solo);
  std::vector<const TextureLayer*> out;
  for (const TextureLayer& l : layers)
    if (there(l) && (l.solo || !solo)) out.push_back(&l);
  return out;
}

// TextureMatrix: (u, v) -> R (u repeat_u, v repeat_v) + offset, and the same of differences without the offset.
template <class Real>
class TextureTransform {
 public:
  explicit TextureTransform(const TextureMatrix& m) {
    const double c = std::cos(radians(m.turn)), s = std::sin(radians(m.turn));
    x_ = Vec2<Real>(Real(c * m.repeat_u), Real(-s * m.repeat_v));
    y_ = Vec2<Real>(Real(s * m.repeat_u), Real(c * m.repeat_v));
    offset_ = Vec2<Real>(Real(m.offset_u), Real(m.offset_v));
  }
  Vec2<Real> point(const Vec2<Real>& uv) const { return difference(uv) + offset_; }
  Vec2<Real> difference(const Vec2<Real>& d) const { return {glm::dot(x_, d), glm::dot(y_, d)}; }
  Footprint<Real> footprint(const Footprint<Real>& f) const {
    return {point(f.uv), difference(f.dx), difference(f.dy)};
  }

 private:
  Vec2<Real> x_, y_, offset_;
};

}  // namespace cg
