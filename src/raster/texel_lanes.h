// Eight pixels' texels at once, where a layer is plain: a picture of 8 bits, read linearly without mipmaps or where
// they are not needed. The same numbers, to the bit, as texture_colour() has.
#pragma once
#include "raster/lanes.h"
#include "raster/uv_at_pixel.h"

namespace cg {

template <class Real>
struct TexelLanes {
  LaneVectors<Real> rgb;
  Lanes<Real> alpha;
};

// The picture where it may be read so, or null.
inline const Image<glm::u8vec4>* plain_picture(const TextureLayer& l) {
  const Sampling& s = l.sampling;
  const bool linear = s.mag_filter == MagFilter::linear && s.anisotropy <= 1 && s.bias == 0 &&
                      (s.min_filter == MinFilter::linear || uses_mipmaps(s.min_filter));
  if (!linear || s.wrap_s == Wrap::border || s.wrap_t == Wrap::border) return nullptr;
  if (l.texture->encoding() != Encoding::as_stored) return nullptr;
  return std::get_if<Image<glm::u8vec4>>(&l.texture->texels(0));
}

namespace texels {

// For |v| < 2^30.
template <class Real>
void floor_lanes(const Lanes<Real>& v, Lanes<Real>& out, Lanes<std::int32_t>& whole) {
  const Lanes<std::int32_t> cut = __builtin_convertvector(v, Lanes<std::int32_t>);
  const Lanes<Real> back = __builtin_convertvector(cut, Lanes<Real>);
  out = back > v ? back - Real(1) : back;
  whole = __builtin_convertvector(out, Lanes<std::int32_t>);
}

// The two texels along one axis, and how far the place lies towards the second. |u| < 2^20.
template <class Real>
void neighbours(Wrap wrap, const Lanes<Real>& given, int size, Lanes<std::int32_t>& first, Lanes<std::int32_t>& second,
                Lanes<Real>& part) {
  Lanes<Real> u = given, whole, left;
  Lanes<std::int32_t> number;
  const Lanes<Real> one = Lanes<Real>{} + Real(1);
  if (wrap == Wrap::repeat) {
    floor_lanes<Real>(u, whole, number);
    u = u - whole;
  } else if (wrap == Wrap::mirror) {
    floor_lanes<Real>(u / Real(2), whole, number);
    u = u - Real(2) * whole;
    u = u > one ? Real(2) - u : u;
  } else {
    u = u > -one ? (u < Real(2) * one ? u : Real(2) * one) : -one;
  }
  const Lanes<Real> x = u * Real(size) - Real(0.5);
  floor_lanes<Real>(x, left, first);
  part = x - left;
  second = first + 1;
  const Lanes<std::int32_t> zero{}, last = zero + (size - 1);
  const Lanes<std::int32_t> below = wrap == Wrap::repeat ? last : zero, above = wrap == Wrap::repeat ? zero : last;
  first = first < zero ? below : first > last ? last : first;
  second = second < zero ? zero : second > last ? above : second;
}

template <class Real>
void channel(const Lanes<std::uint32_t>& t, int shift, Lanes<Real>& out) {
  const Lanes<std::int32_t> byte = Lanes<std::int32_t>((t >> shift) & 255u);
  out = __builtin_convertvector(__builtin_convertvector(byte, Lanes<float>) * (1.0f / 255.0f), Lanes<Real>);
}

inline void gather(const Image<glm::u8vec4>& image, const Lanes<std::int32_t>& i, const Lanes<std::int32_t>& row,
                   Lanes<std::uint32_t>& out) {
  const Lanes<std::int32_t> place = row + i;
  const glm::u8vec4* texel = image.pixels().data();
  for (int k = 0; k < lanes; ++k) out[k] = std::bit_cast<std::uint32_t>(texel[place[k]]);
}

}  // namespace texels

// linear_texels() at level 0.
template <class Real>
void linear_lanes(const Image<glm::u8vec4>& image, const Sampling& s, const Lanes<Real>& u, const Lanes<Real>& v,
                  TexelLanes<Real>& out) {
  Lanes<std::int32_t> i0, i1, j0, j1;
  Lanes<Real> a, b;
  texels::neighbours<Real>(s.wrap_s, u, image.width(), i0, i1, a);
  texels::neighbours<Real>(s.wrap_t, v, image.height(), j0, j1, b);
  j0 *= image.width(), j1 *= image.width();
  Lanes<std::uint32_t> t00, t10, t01, t11;
  texels::gather(image, i0, j0, t00), texels::gather(image, i1, j0, t10);
  texels::gather(image, i0, j1, t01), texels::gather(image, i1, j1, t11);
  const auto mixed = [&](int shift, Lanes<Real>& to) {
    Lanes<Real> p, q, r, t;
    texels::channel<Real>(t00, shift, p), texels::channel<Real>(t10, shift, q);
    texels::channel<Real>(t01, shift, r), texels::channel<Real>(t11, shift, t);
    const Lanes<Real> low = p + (q - p) * a, high = r + (t - r) * a;
    to = low + (high - low) * b;
  };
  mixed(0, out.rgb.x), mixed(8, out.rgb.y), mixed(16, out.rgb.z), mixed(24, out.alpha);
}

}  // namespace cg
