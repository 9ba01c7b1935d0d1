// What a texture has at a point, as OpenGL reads it, in float or double: wrap, level of detail, filters.
// This work is based on: The OpenGL Graphics System 3.3, sections 3.8.4, 3.8.11 and 3.8.12; Lance Williams, Pyramidal
// Parametrics, 1983; EXT_texture_filter_anisotropic, 1999 (its example). In GLSL the driver does it.
#pragma once
#include <algorithm>

#include "math/vec.h"
#include "scene/texture.h"
#include "scene/texture_image.h"

namespace cg {

// A pixel in a texture: uv at its centre, and how far uv goes to the next pixel to the right and above.
template <class Real>
struct Footprint {
  Vec2<Real> uv, dx{Real(0)}, dy{Real(0)};
};

// What wraps as a number, brought to where its texels can be counted: 0..1 (repeat, mirror) or -1..2. NaN is 0. Exact
// wherever the texel is.
template <class Real>
Real wrapped(Wrap wrap, Real u) {
  if (wrap == Wrap::repeat) {
    u -= std::floor(u);
  } else if (wrap == Wrap::mirror) {
    u -= Real(2) * std::floor(u / Real(2));
    if (u > Real(1)) u = Real(2) - u;
  } else {
    u = u > Real(-1) ? (u < Real(2) ? u : Real(2)) : (u <= Real(-1) ? Real(-1) : u);
  }
  return u == u ? u : Real(0);  // an infinity minus itself, or NaN
}

// The texel of the number i of a line of texels that goes on to both sides; -1: the border.
inline int wrapped_texel(Wrap wrap, int i, int size) {
  switch (wrap) {
    case Wrap::repeat:
      return (i % size + size) % size;
    case Wrap::mirror:  // the number is mirrored already
    case Wrap::clamp:
      return std::clamp(i, 0, size - 1);
    case Wrap::border:
      return i >= 0 && i < size ? i : -1;
  }
  return 0;
}

template <class Real>
Vec4<Real> texel_or_border(const TextureImage& image, const Sampling& s, int level, int i, int j) {
  if (i >= 0 && j >= 0) return Vec4<Real>(image.texel(level, i, j));
  return Vec4<Real>(Vec3<Real>(s.border), Real(s.border_alpha));
}

template <class Real>
Vec4<Real> nearest_texel(const TextureImage& image, const Sampling& s, int level, const Vec2<Real>& uv) {
  const int w = image.width(level), h = image.height(level);
  const int i = int(std::floor(wrapped(s.wrap_s, uv.x) * Real(w))),
            j = int(std::floor(wrapped(s.wrap_t, uv.y) * Real(h)));
  return texel_or_border<Real>(image, s, level, wrapped_texel(s.wrap_s, i, w), wrapped_texel(s.wrap_t, j, h));
}

// Between the four texels whose centres lie around the point.
template <class Real>
Vec4<Real> linear_texels(const TextureImage& image, const Sampling& s, int level, const Vec2<Real>& uv) {
  const int w = image.width(level), h = image.height(level);
  const Real x = wrapped(s.wrap_s, uv.x) * Real(w) - Real(0.5), y = wrapped(s.wrap_t, uv.y) * Real(h) - Real(0.5);
  const Real left = std::floor(x), low = std::floor(y), a = x - left, b = y - low;
  const int i0 = wrapped_texel(s.wrap_s, int(left), w), i1 = wrapped_texel(s.wrap_s, int(left) + 1, w);
  const int j0 = wrapped_texel(s.wrap_t, int(low), h), j1 = wrapped_texel(s.wrap_t, int(low) + 1, h);
  const auto at = [&](int i, int j) { return texel_or_border<Real>(image, s, level, i, j); };
  const auto mix = [](const Vec4<Real>& p, const Vec4<Real>& q, Real t) { return p + (q - p) * t; };
  return mix(mix(at(i0, j0), at(i1, j0), a), mix(at(i0, j1), at(i1, j1), a), b);
}

// log2 of the longer extent of the pixel in texels of level 0 (equation 3.21); -infinity where it has none.
template <class Real>
Real level_of_detail(const TextureImage& image, const Vec2<Real>& dx, const Vec2<Real>& dy) {
  const Vec2<Real> size(Real(image.width()), Real(image.height()));
  const Vec2<Real> x = dx * size, y = dy * size;
  const Real square = std::max(glm::dot(x, x), glm::dot(y, y));
  return square == square ? std::log2(square) / Real(2) : -std::numeric_limits<Real>::infinity();
}

// One read of the texture: by the level of detail, bias included, minified or magnified.
template <class Real>
Vec4<Real> texture_at_level(const TextureImage& image, const Sampling& s, const Vec2<Real>& uv, Real lambda) {
  const int last = image.levels() - 1;
  // The switch lies at 0 for all filters, as an implementation may choose and drivers do; the other choice is half a
  // level where a linear magnification meets a nearest minification.
  if (!(lambda > Real(0)))
    return s.mag_filter == MagFilter::linear ? linear_texels(image, s, 0, uv) : nearest_texel(image, s, 0, uv);
  const auto read = [&](int level) {
    return is_linear_within(s.min_filter) ? linear_texels(image, s, level, uv) : nearest_texel(image, s, level, uv);
  };
  if (!uses_mipmaps(s.min_filter)) return read(0);
  const Real clamped = std::min(lambda, Real(last));
  if (!is_linear_between(s.min_filter)) return read(std::clamp(int(std::ceil(clamped + Real(0.5))) - 1, 0, last));
  const int lower = std::min(int(clamped), last);
  const Real part = clamped - Real(lower);
  if (!(part > Real(0))) return read(lower);
  const Vec4<Real> below = read(lower);
  return below + (read(lower + 1) - below) * part;
}

// The texture as a pixel sees it.
template <class Real>
Vec4<Real> texture_colour(const TextureImage& image, const Sampling& s, const Footprint<Real>& f) {
  if (s.anisotropy <= 1) return texture_at_level(image, s, f.uv, level_of_detail(image, f.dx, f.dy) + Real(s.bias));
  const Vec2<Real> size(Real(image.width()), Real(image.height()));
  const Real px = glm::length(f.dx * size), py = glm::length(f.dy * size);
  const Real longer = std::max(px, py), shorter = std::min(px, py);
  const Real wanted = shorter > Real(0) ? std::ceil(longer / shorter) : Real(s.anisotropy);
  const int samples = wanted < Real(s.anisotropy) ? std::max(int(wanted), 1) : s.anisotropy;
  const Real lambda = std::log2(longer / Real(samples)) + Real(s.bias);
  const Vec2<Real> along = px > py ? f.dx : f.dy;
  Vec4<Real> sum(Real(0));
  for (int i = 1; i <= samples; ++i)
    sum += texture_at_level(image, s, f.uv + along * (Real(i) / Real(samples + 1) - Real(0.5)), lambda);
  return sum / Real(samples);
}

}  // namespace cg
