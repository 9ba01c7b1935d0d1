// light_point for eight points at once: the same light model, written so that a compiler does all eight with one
// instruction. Where a point, a normal or a parameter is out of the ordinary, light_point itself is called, so that
// every extreme is treated in one place.
#pragma once
#include "math/power.h"
#include "shading/light_model.h"

namespace cg {

inline constexpr int batch_size = 8;

// Eight numbers, and eight vectors by component.
template <class Real>
struct alignas(batch_size * sizeof(Real)) Eight {
  Real v[batch_size];
  Real& operator[](int i) { return v[i]; }
  Real operator[](int i) const { return v[i]; }
};
template <class Real>
struct EightVectors {
  Eight<Real> x, y, z;
  Vec3<Real> get(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3<Real>& a) { x[i] = a.x, y[i] = a.y, z[i] = a.z; }
};

// Can the eight-fold way be used? Large exponents need light_point's care (lobe_power).
template <class Real>
bool is_ordinary(const EyeLighting<Real>&, const EyeMaterial<Real>& m) {
  return m.n <= Real(128);
}

namespace batch {

// One light's contribution to eight points, added to I. `ordinary` becomes false where a square left the range.
template <class Real>
inline void add_light(const EyeLight<Real>& light, Reflection reflection, const EyeMaterial<Real>& m,
                      const EightVectors<Real>& P, const EightVectors<Real>& N, const EightVectors<Real>& V,
                      EightVectors<Real>& I, bool& ordinary) {
  constexpr Real tiny = sizeof(Real) == 4 ? Real(1e-30) : Real(1e-280);
  constexpr Real huge = sizeof(Real) == 4 ? Real(1e30) : Real(1e280);
  Eight<Real> Lx, Ly, Lz, factor;
  int odd = 0;
  if (light.directional) {
    for (int i = 0; i < batch_size; ++i)
      Lx[i] = light.position.x, Ly[i] = light.position.y, Lz[i] = light.position.z, factor[i] = Real(1);
  } else {
    for (int i = 0; i < batch_size; ++i) {
      const Real x = light.position.x - P.x[i], y = light.position.y - P.y[i], z = light.position.z - P.z[i];
      const Real square = x * x + y * y + z * z;
      odd += !(square > tiny && square < huge);
      const Real r = std::sqrt(square), inverse = Real(1) / r;
      Lx[i] = x * inverse, Ly[i] = y * inverse, Lz[i] = z * inverse;
      const Real d = light.k_0 + r * (light.k_1 + r * light.k_2);
      factor[i] = d > Real(0) ? Real(1) / d : Real(1);
    }
  }
  if (light.spot_cosine > Real(-2)) {
    for (int i = 0; i < batch_size; ++i) {
      const Real c =
          -(Lx[i] * light.spot_direction.x + Ly[i] * light.spot_direction.y + Lz[i] * light.spot_direction.z);
      const bool inside = c >= light.spot_cosine && c > Real(0);
      const Real spot = power(c < Real(1) ? c : Real(1), light.spot_exponent);
      factor[i] = inside ? factor[i] * spot : Real(0);
    }
  }
  Eight<Real> n_dot_l, lobe;
  const bool half_vector = reflection == Reflection::half_vector;
  for (int i = 0; i < batch_size; ++i) {
    const Real cosine = N.x[i] * Lx[i] + N.y[i] * Ly[i] + N.z[i] * Lz[i];
    n_dot_l[i] = cosine > Real(0) ? cosine : Real(0);
  }
  if (half_vector) {
    for (int i = 0; i < batch_size; ++i) {
      const Real x = Lx[i] + V.x[i], y = Ly[i] + V.y[i], z = Lz[i] + V.z[i];
      const Real square = x * x + y * y + z * z;
      odd += !(square > tiny && square < huge);
      lobe[i] = (N.x[i] * x + N.y[i] * y + N.z[i] * z) / std::sqrt(square);
    }
  } else {
    for (int i = 0; i < batch_size; ++i) {
      const Real twice = Real(2) * n_dot_l[i];
      lobe[i] =
          (twice * N.x[i] - Lx[i]) * V.x[i] + (twice * N.y[i] - Ly[i]) * V.y[i] + (twice * N.z[i] - Lz[i]) * V.z[i];
    }
  }
  for (int i = 0; i < batch_size; ++i) {
    odd += !(lobe[i] < Real(2));
    const Real p = power(lobe[i], m.n);
    const bool lit = n_dot_l[i] > Real(0) && (lobe[i] > Real(0) || m.n == Real(0));
    lobe[i] = lit ? p : Real(0);
  }
  const Vec3<Real> a = light.ambient * m.k_a, d = light.diffuse * m.k_d, s = light.specular * m.k_s;
  for (int i = 0; i < batch_size; ++i) {
    I.x[i] += factor[i] * (a.x + d.x * n_dot_l[i] + s.x * lobe[i]);
    I.y[i] += factor[i] * (a.y + d.y * n_dot_l[i] + s.y * lobe[i]);
    I.z[i] += factor[i] * (a.z + d.z * n_dot_l[i] + s.z * lobe[i]);
    odd += !(std::abs(I.x[i]) + std::abs(I.y[i]) + std::abs(I.z[i]) < Real(1e29));
  }
  ordinary = ordinary && odd == 0;
}

}  // namespace batch

// light_point of eight points. Equal to it but for rounding (about 1e-6 in float).
template <class Real>
void light_points(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& m, const EightVectors<Real>& P,
                  const EightVectors<Real>& N, EightVectors<Real>& I) {
  bool ordinary = is_ordinary(lighting, m);
  if (ordinary) {
    EightVectors<Real> V;
    for (int i = 0; i < batch_size; ++i) V.x[i] = V.y[i] = Real(0), V.z[i] = Real(1);
    if (lighting.local_viewer)
      for (int i = 0; i < batch_size; ++i) V.set(i, unit(-P.get(i)));
    const Vec3<Real> base = m.emission + lighting.ambient * m.k_a;
    for (int i = 0; i < batch_size; ++i) I.x[i] = base.x, I.y[i] = base.y, I.z[i] = base.z;
    for (const EyeLight<Real>& light : lighting.lights)
      batch::add_light(light, lighting.reflection, m, P, N, V, I, ordinary);
    if (lighting.clamp)
      for (int i = 0; i < batch_size; ++i)
        I.x[i] = saturate(I.x[i]), I.y[i] = saturate(I.y[i]), I.z[i] = saturate(I.z[i]);
  }
  if (ordinary) return;
  for (int i = 0; i < batch_size; ++i) I.set(i, light_point(lighting, m, P.get(i), N.get(i)));
}

// v / |v| of eight vectors.
template <class Real>
void units(EightVectors<Real>& a) {
  int odd = 0;
  EightVectors<Real> out;
  for (int i = 0; i < batch_size; ++i) {
    const Real square = a.x[i] * a.x[i] + a.y[i] * a.y[i] + a.z[i] * a.z[i];
    odd += !(square > Real(1e-30) && square < Real(1e30));
    const Real inverse = Real(1) / std::sqrt(square);
    out.x[i] = a.x[i] * inverse, out.y[i] = a.y[i] * inverse, out.z[i] = a.z[i] * inverse;
  }
  if (odd != 0)
    for (int i = 0; i < batch_size; ++i) out.set(i, unit(a.get(i)));
  a = out;
}

}  // namespace cg
