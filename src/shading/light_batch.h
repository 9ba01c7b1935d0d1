// light_point for eight points at once: the same light model, written so that a compiler does all eight with one
// instruction. Where a point, a normal or a parameter is out of the ordinary, light_point itself is called, so that
// every extreme is treated in one place.
#pragma once
#include "math/power.h"
#include "scene/only_plain.h"
#include "shading/light_parts.h"

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

namespace batch {

// One light on one material: its colours times the material's, and which of add_light's loops it needs.
template <class Real>
struct LightOnMaterial {
  EyeLight<Real> light;
  Vec3<Real> ambient, diffuse, specular;
  LightParts parts;
  bool scaled() const { return parts.attenuation || parts.spot; }
};

// Range in which a square may be divided by its root.
template <class Real>
bool is_odd(Real square) {
  constexpr Real tiny = sizeof(Real) == 4 ? Real(1e-30) : Real(1e-280);
  constexpr Real huge = sizeof(Real) == 4 ? Real(1e30) : Real(1e280);
  return !(square > tiny && square < huge);
}

// The unit vectors towards a point light, and 1/(k_0 + k_1 r + k_2 r^2). Returns how many squares left the range.
template <class Real>
inline int towards_light(const LightOnMaterial<Real>& on, const EightVectors<Real>& P, EightVectors<Real>& L,
                         Eight<Real>& factor) {
  const EyeLight<Real>& light = on.light;
  int odd = 0;
  Eight<Real> r;
  for (int i = 0; i < batch_size; ++i) {
    const Real x = light.position.x - P.x[i], y = light.position.y - P.y[i], z = light.position.z - P.z[i];
    const Real square = x * x + y * y + z * z;
    odd += is_odd(square);
    r[i] = std::sqrt(square);
    const Real inverse = Real(1) / r[i];
    L.x[i] = x * inverse, L.y[i] = y * inverse, L.z[i] = z * inverse;
  }
  if (on.parts.attenuation)
    for (int i = 0; i < batch_size; ++i) {
      const Real d = light.k_0 + r[i] * (light.k_1 + r[i] * light.k_2);
      factor[i] = d > Real(0) ? Real(1) / d : Real(1);
    }
  return odd;
}

template <class Real>
inline void add_cone(const EyeLight<Real>& light, const EightVectors<Real>& L, Eight<Real>& factor) {
  for (int i = 0; i < batch_size; ++i) {
    const Real c =
        -(L.x[i] * light.spot_direction.x + L.y[i] * light.spot_direction.y + L.z[i] * light.spot_direction.z);
    const bool inside = c >= light.spot_cosine && c > Real(0);
    const Real spot = power(c < Real(1) ? c : Real(1), light.spot_exponent);
    factor[i] = inside ? factor[i] * spot : Real(0);
  }
}

// The highlight's f_i cos^n. Returns how many numbers left the range.
template <class Real>
inline int find_lobe(Reflection reflection, Real n, const EightVectors<Real>& N, const EightVectors<Real>& L,
                     const EightVectors<Real>& V, const Eight<Real>& n_dot_l, Eight<Real>& lobe) {
  int odd = 0;
  if (reflection == Reflection::half_vector) {
    for (int i = 0; i < batch_size; ++i) {
      const Real x = L.x[i] + V.x[i], y = L.y[i] + V.y[i], z = L.z[i] + V.z[i];
      const Real square = x * x + y * y + z * z;
      odd += is_odd(square);
      lobe[i] = (N.x[i] * x + N.y[i] * y + N.z[i] * z) / std::sqrt(square);
    }
  } else {
    for (int i = 0; i < batch_size; ++i) {
      const Real twice = Real(2) * n_dot_l[i];
      lobe[i] =
          (twice * N.x[i] - L.x[i]) * V.x[i] + (twice * N.y[i] - L.y[i]) * V.y[i] + (twice * N.z[i] - L.z[i]) * V.z[i];
    }
  }
  for (int i = 0; i < batch_size; ++i) {
    odd += !(lobe[i] < Real(2));
    const Real p = power(lobe[i], n);
    const bool lit = n_dot_l[i] > Real(0) && (lobe[i] > Real(0) || n == Real(0));
    lobe[i] = lit ? p : Real(0);
  }
  return odd;
}

// Adds the terms that there are; the others are not in the loop. Returns how many colours left the range.
template <bool with_lobe, bool scaled, class Real>
inline int add_terms(const LightOnMaterial<Real>& on, const Eight<Real>& n_dot_l, const Eight<Real>& lobe,
                     const Eight<Real>& factor, EightVectors<Real>& I) {
  const Vec3<Real>&a = on.ambient, &d = on.diffuse, &s = on.specular;
  const auto term = [&](int i, Real ambient, Real diffuse, [[maybe_unused]] Real specular) {
    Real C = ambient + diffuse * n_dot_l[i];
    if constexpr (with_lobe) C += specular * lobe[i];
    if constexpr (scaled) C *= factor[i];
    return C;
  };
  int odd = 0;
  for (int i = 0; i < batch_size; ++i) {
    I.x[i] += term(i, a.x, d.x, s.x), I.y[i] += term(i, a.y, d.y, s.y), I.z[i] += term(i, a.z, d.z, s.z);
    odd += !(std::abs(I.x[i]) + std::abs(I.y[i]) + std::abs(I.z[i]) < Real(1e29));
  }
  return odd;
}

// One light's contribution to eight points, added to I. Returns how often a number left the range.
template <class Real>
inline int add_light(const LightOnMaterial<Real>& on, Reflection reflection, Real n, const EightVectors<Real>& P,
                     const EightVectors<Real>& N, const EightVectors<Real>& V, EightVectors<Real>& I) {
  const EyeLight<Real>& light = on.light;
  EightVectors<Real> L;
  Eight<Real> factor, n_dot_l, lobe;
  int odd = 0;
  if (optional(on.scaled()))
    for (int i = 0; i < batch_size; ++i) factor[i] = Real(1);
  if (optional(on.parts.point))
    odd += towards_light(on, P, L, factor);
  else
    for (int i = 0; i < batch_size; ++i)
      L.x[i] = light.position.x, L.y[i] = light.position.y, L.z[i] = light.position.z;
  if (optional(on.parts.spot)) add_cone(light, L, factor);
  if (only_plain || on.parts.normal())
    for (int i = 0; i < batch_size; ++i) {
      const Real cosine = N.x[i] * L.x[i] + N.y[i] * L.y[i] + N.z[i] * L.z[i];
      n_dot_l[i] = cosine > Real(0) ? cosine : Real(0);
    }
  else
    for (int i = 0; i < batch_size; ++i) n_dot_l[i] = Real(0);
  if (optional(on.parts.specular)) {
    odd += find_lobe(reflection, n, N, L, V, n_dot_l, lobe);
    return odd + (on.scaled() ? add_terms<true, true>(on, n_dot_l, lobe, factor, I)
                              : add_terms<true, false>(on, n_dot_l, lobe, factor, I));
  }
  return odd + (optional(on.scaled()) ? add_terms<false, true>(on, n_dot_l, lobe, factor, I)
                                      : add_terms<false, false>(on, n_dot_l, lobe, factor, I));
}

}  // namespace batch

// Lights points of one material, eight at a time. What of the light model they need is chosen once, here: lights that
// add nothing are gone, and of the others only the loops that they use are run.
template <class Real>
class LightBatch {
 public:
  LightBatch() = default;
  // `lighting` must stay where it is. `radiosity`: each point brings light of a solution, and the material no k_a.
  LightBatch(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& material, bool radiosity = false)
      : lighting_(&lighting), material_(material), parts_(light_parts(lighting, material)) {
    for (const EyeLight<Real>& light : lighting.lights) {
      const LightParts parts = light_parts(light, material);
      if (parts.lit())
        lights_.push_back(
            {light, light.ambient * material.k_a, light.diffuse * material.k_d, light.specular * material.k_s, parts});
    }
    parts_.radiosity = radiosity;
    base_ = Vec3<Real>(Real(0));
    if (parts_.emission) base_ += material.emission;
    if (parts_.ambient) base_ += lighting.ambient * material.k_a;
    // Large exponents need light_point's care (lobe_power).
    ordinary_ = !parts_.specular || material.n <= Real(128);
  }

  const LightParts& parts() const { return parts_; }
  bool local_viewer() const { return parts_.specular && lighting_->local_viewer; }
  bool uses_position() const { return parts_.position(lighting_->local_viewer); }
  bool uses_normal() const { return parts_.normal(); }
  bool uses_radiosity() const { return parts_.radiosity; }

  // light_point of eight points. Equal to it but for rounding (about 1e-6 in float). P and N may be anything where they
  // are not used. `radiosity` of the points: null where it is not used.
  void light(const EightVectors<Real>& P, const EightVectors<Real>& N, EightVectors<Real>& I,
             const EightVectors<Real>* radiosity = nullptr) const {
    int odd = !ordinary_;
    if (odd == 0) {
      EightVectors<Real> V;
      if (optional(local_viewer()))
        for (int i = 0; i < batch_size; ++i) V.set(i, unit(-P.get(i)));
      else
        for (int i = 0; i < batch_size; ++i) V.x[i] = V.y[i] = Real(0), V.z[i] = Real(1);
      for (int i = 0; i < batch_size; ++i) I.x[i] = base_.x, I.y[i] = base_.y, I.z[i] = base_.z;
      if (optional(radiosity != nullptr))
        for (int i = 0; i < batch_size; ++i)
          I.x[i] += radiosity->x[i], I.y[i] += radiosity->y[i], I.z[i] += radiosity->z[i];
      for (const batch::LightOnMaterial<Real>& on : lights_)
        odd += batch::add_light(on, lighting_->reflection, material_.n, P, N, V, I);
      if (optional(lighting_->clamp))
        for (int i = 0; i < batch_size; ++i)
          I.x[i] = saturate(I.x[i]), I.y[i] = saturate(I.y[i]), I.z[i] = saturate(I.z[i]);
    }
    if (odd == 0) return;
    EyeMaterial<Real> m = material_;
    for (int i = 0; i < batch_size; ++i) {
      if (optional(radiosity != nullptr)) m.emission = material_.emission + radiosity->get(i);
      I.set(i, light_point(*lighting_, m, P.get(i), N.get(i)));
    }
  }

 private:
  const EyeLighting<Real>* lighting_ = nullptr;
  EyeMaterial<Real> material_;
  LightParts parts_;
  std::vector<batch::LightOnMaterial<Real>> lights_;
  Vec3<Real> base_;
  bool ordinary_ = true;
};

// Once, where there is no second batch of that material.
template <class Real>
void light_points(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& m, const EightVectors<Real>& P,
                  const EightVectors<Real>& N, EightVectors<Real>& I) {
  LightBatch<Real>(lighting, m).light(P, N, I);
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
