// Where a direction looks in a picture of all around: six faces of a cube, a mirrored ball, latitude and longitude.
// This work is based on: The OpenGL Graphics System 3.3, section 3.8.10, table 3.17 (cube map), and 2.1, section 2.11.4
// (sphere map); Ned Greene, Environment Mapping and Other Applications of World Projections, 1986.
#pragma once
#include <algorithm>
#include <array>
#include <numbers>
#include <string_view>

#include "math/vec.h"

namespace cg {

// In OpenGL's order.
enum class CubeFace { right, left, top, bottom, near, far };  // +x -x +y -y +z -z
inline constexpr int cube_faces = 6;
inline constexpr std::array<std::string_view, cube_faces> cube_face_signs{"+x", "-x", "+y", "-y", "+z", "-z"};

// A face's picture is seen from the cube's centre, its row t = 0 at the top.
template <class Real>
struct CubePlace {
  CubeFace face;
  Vec2<Real> st;  // 0..1
};

// `r`: any length. Where two components are alike z goes before y before x, as Mesa has it; (0, 0, 0) and what is no
// number give the middle of +z.
template <class Real>
CubePlace<Real> cube_place(const Vec3<Real>& r) {
  const Vec3<Real> a(std::abs(r.x), std::abs(r.y), std::abs(r.z));
  const auto place = [](CubeFace face, Real sc, Real tc, Real ma) {
    const auto half = [&](Real c) { return std::clamp((c / ma + Real(1)) / Real(2), Real(0), Real(1)); };
    return CubePlace<Real>{face, {half(sc), half(tc)}};
  };
  const Real most = std::max({a.x, a.y, a.z});
  if (!is_finite(r) || !(most > Real(0))) return {CubeFace::near, {Real(0.5), Real(0.5)}};
  if (a.z >= a.x && a.z >= a.y)
    return r.z > Real(0) ? place(CubeFace::near, r.x, -r.y, a.z) : place(CubeFace::far, -r.x, -r.y, a.z);
  if (a.y >= a.x) return r.y > Real(0) ? place(CubeFace::top, r.x, r.z, a.y) : place(CubeFace::bottom, r.x, -r.z, a.y);
  return r.x > Real(0) ? place(CubeFace::right, -r.z, -r.y, a.x) : place(CubeFace::left, r.z, -r.y, a.x);
}

// The other way round; not unit.
template <class Real>
Vec3<Real> cube_direction(const CubePlace<Real>& p) {
  const Real sc = Real(2) * p.st.x - Real(1), tc = Real(2) * p.st.y - Real(1), one(1);
  switch (p.face) {
    case CubeFace::right:
      return {one, -tc, -sc};
    case CubeFace::left:
      return {-one, -tc, sc};
    case CubeFace::top:
      return {sc, one, tc};
    case CubeFace::bottom:
      return {sc, -one, -tc};
    case CubeFace::near:
      return {sc, -tc, one};
    case CubeFace::far:
      return {-sc, -tc, -one};
  }
  return {Real(0), Real(0), one};
}

// The direction in which one who looks along `view` (towards the surface) sees the mirrored world: view - 2 N (N.view).
template <class Real>
Vec3<Real> mirrored(const Vec3<Real>& view, const Vec3<Real>& N) {
  return view - Real(2) * glm::dot(N, view) * N;
}

// GL_SPHERE_MAP: where the unit direction r of eye space stands in a photograph of a mirrored ball. Straight away from
// the viewer, r = (0, 0, -1), is the whole rim: there (1/2, 1/2) + what is left of 1, to the right.
template <class Real>
Vec2<Real> sphere_map_place(const Vec3<Real>& r) {
  const Real z = r.z + Real(1), square = r.x * r.x + r.y * r.y + z * z;
  if (!(square > Real(1e-12))) return {Real(1), Real(0.5)};
  const Real m = Real(2) * std::sqrt(square);
  return {r.x / m + Real(0.5), r.y / m + Real(0.5)};
}

// Longitude and latitude, 0..1: u = 1/2 looks along -z and grows to the right, v = 1 is +y.
template <class Real>
Vec2<Real> latitude_longitude_place(const Vec3<Real>& r) {
  const auto [length, d] = length_and_unit(r);
  if (length == Real(0)) return {Real(0.5), Real(0.5)};
  const Real u = std::atan2(d.x, -d.z) / (Real(2) * std::numbers::pi_v<Real>)+Real(0.5);
  const Real v = std::asin(std::clamp(d.y, Real(-1), Real(1))) / std::numbers::pi_v<Real> + Real(0.5);
  return {u, v};
}

// The share of light that a smooth surface mirrors. This work is based on: Christophe Schlick, An Inexpensive BRDF
// Model for Physically-based Rendering, 1994. `at_normal`: the share at normal incidence; `cosine`: N.V.
template <class Real>
Vec3<Real> fresnel_share(const Vec3<Real>& at_normal, Real cosine) {
  const Real m = Real(1) - saturate(cosine), m2 = m * m;
  return at_normal + (Vec3<Real>(Real(1)) - at_normal) * (m2 * m2 * m);
}

}  // namespace cg
