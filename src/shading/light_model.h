// The lecture's light model and OpenGL's, at one point, in eye space, in float or double:
//
//   I = E + I_a k_a + sum_i att_i spot_i [ I_ai k_a + I_di k_d (N.L_i) + f_i I_si k_s (R_i.V)^n  or  (N.H_i)^n ]
//
// This work is based on: Bui Tuong Phong, Illumination for Computer Generated Pictures, 1975 (R.V);
// James Blinn, Models of Light Reflection, 1977 (N.H); The OpenGL Graphics System 2.1, section 2.14.
// shading/glsl/light_model.glsl is the twin of this file.
#pragma once
#include <vector>

#include "math/vec.h"
#include "scene/scene.h"

namespace cg {

// A light as it stands in eye space.
template <class Real>
struct EyeLight {
  Vec3<Real> ambient, diffuse, specular;  // I_ai, I_di, I_si
  Vec3<Real> position;                    // of a directional light: the unit direction towards it
  Vec3<Real> spot_direction;              // unit
  Real spot_cosine;                       // of the cut-off; -2: no cone
  Real spot_exponent;
  Real k_0, k_1, k_2;  // attenuation; a directional light has none
  bool directional;
  int index;  // in Scene::lights
};

// What is the same for all points of a picture.
template <class Real>
struct EyeLighting {
  Vec3<Real> ambient;                  // I_a, global
  std::vector<EyeLight<Real>> lights;  // those that are on and can contribute
  Reflection reflection;
  bool local_viewer, two_sided, clamp;
};

// The k of one surface, colour material applied.
template <class Real>
struct EyeMaterial {
  Vec3<Real> k_a, k_d, k_s, emission;
  Real n;
};

// The factors of one light at one point, as the probe shows them.
template <class Real>
struct LightFactors {
  Vec3<Real> L;      // unit, towards the light; 0 where the light is at the point
  Real n_dot_l;      // max(N.L, 0)
  Real lobe_cosine;  // max(R.V, 0) or max(N.H, 0)
  Real lobe;         // f_i * lobe_cosine^n
  Real attenuation;
  Real spot;
};

// The scene's lights in eye space. `view` is world to eye. Lights that are off, that have a zero position with
// w = 0, or that are not finite are left out. |w| < 1e-6 counts as directional.
template <class Real>
EyeLighting<Real> lighting_in_eye_space(const Scene& scene, const glm::dmat4& view);

template <class Real>
EyeMaterial<Real> eye_material(const Material& material, ColorMaterial tracked);

// max(a.b, 0)^n. From the sine where a and b are unit, the angle is small and n is large: there 1 ulp of the cosine
// would grow to n ulp of the power. 0^0 = 1. Normals that are not unit may give more than 1, as in OpenGL, but
// nothing infinite.
template <class Real>
Real lobe_power(const Vec3<Real>& a, const Vec3<Real>& b, Real cosine, Real n) {
  if (n == Real(0)) return Real(1);
  if (!(cosine > Real(0))) return Real(0);
  if (n > Real(128) && cosine > Real(0.5) && std::abs(glm::dot(a, a) * glm::dot(b, b) - Real(1)) < Real(1e-4)) {
    const Vec3<Real> s = glm::cross(a, b);
    return std::exp(Real(0.5) * n * std::log1p(-std::min(glm::dot(s, s), Real(1))));
  }
  return std::min(std::pow(cosine, n), Real(1e30));
}

// H and R of the two highlights. `n_dot_l` is N.L.
template <class Real>
Vec3<Real> half_vector(const Vec3<Real>& L, const Vec3<Real>& V) {
  return unit(L + V);
}
template <class Real>
Vec3<Real> reflection_vector(const Vec3<Real>& N, const Vec3<Real>& L, Real n_dot_l) {
  return Real(2) * n_dot_l * N - L;
}

// `P` the point, `N` its normal (unit where the scene normalises), `V` the unit vector towards the viewer; all
// in eye space.
template <class Real>
LightFactors<Real> light_factors(const EyeLight<Real>& light, Reflection reflection, Real n, const Vec3<Real>& P,
                                 const Vec3<Real>& N, const Vec3<Real>& V) {
  LightFactors<Real> f{light.position, Real(0), Real(0), Real(0), Real(1), Real(1)};
  if (!light.directional) {
    const auto [r, L] = length_and_unit(light.position - P);
    f.L = L;
    // Horner's form: no r^2 that could overflow where k_2 is 0.
    const Real d = light.k_0 + r * (light.k_1 + r * light.k_2);
    f.attenuation = d > Real(0) ? Real(1) / d : Real(1);
  }
  if (light.spot_cosine > Real(-2)) {
    const Real c = -glm::dot(f.L, light.spot_direction);
    f.spot = c >= light.spot_cosine && c > Real(0)
                 ? (light.spot_exponent == Real(0) ? Real(1) : std::pow(std::min(c, Real(1)), light.spot_exponent))
                 : Real(0);
  }
  const Real cosine = glm::dot(N, f.L);
  if (!(cosine > Real(0))) return f;  // behind the surface, or NaN: no diffuse and, as OpenGL, no specular term
  f.n_dot_l = cosine;
  if (reflection == Reflection::half_vector) {
    const Vec3<Real> H = half_vector(f.L, V);
    f.lobe_cosine = positive(glm::dot(N, H));
    f.lobe = lobe_power(N, H, f.lobe_cosine, n);
  } else {
    const Vec3<Real> R = reflection_vector(N, f.L, cosine);
    f.lobe_cosine = positive(glm::dot(R, V));
    f.lobe = lobe_power(R, V, f.lobe_cosine, n);
  }
  return f;
}

// The vector towards the viewer at P (eye space): (0,0,1), or unit(-P) for a local viewer.
template <class Real>
Vec3<Real> towards_viewer(bool local_viewer, const Vec3<Real>& P) {
  return local_viewer ? unit(-P) : Vec3<Real>(Real(0), Real(0), Real(1));
}

// x limited to what sums of 64 lights keep finite; NaN (an infinite light at no share) becomes 0.
template <class Real>
Real limited(Real x) {
  constexpr Real most = Real(1e30);
  return x < most ? (x > -most ? x : -most) : (x >= most ? most : Real(0));
}

// The sum of the terms, clamped to 0..1 where the scene says so. Always finite.
template <class Real>
Vec3<Real> light_point(const EyeLighting<Real>& lighting, const EyeMaterial<Real>& m, const Vec3<Real>& P,
                       const Vec3<Real>& N) {
  const Vec3<Real> V = towards_viewer(lighting.local_viewer, P);
  Vec3<Real> I = m.emission + lighting.ambient * m.k_a;
  for (const EyeLight<Real>& light : lighting.lights) {
    const LightFactors<Real> f = light_factors(light, lighting.reflection, m.n, P, N, V);
    const Vec3<Real> C = f.attenuation * f.spot *
                         (light.ambient * m.k_a + light.diffuse * m.k_d * f.n_dot_l + light.specular * m.k_s * f.lobe);
    I += Vec3<Real>(limited(C.x), limited(C.y), limited(C.z));
  }
  return lighting.clamp ? saturate(I) : I;
}

}  // namespace cg
