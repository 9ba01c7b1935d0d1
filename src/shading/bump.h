// Normals from pictures: a height that is not there (bump mapping), or normals stored as colours (normal mapping).
// This work is based on: James Blinn, Simulation of Wrinkled Surfaces, 1978; for the triangle's own derivatives,
// Morten Mikkelsen, Bump Mapping Unparametrized Surfaces on the GPU, 2010; Mark Peercy, John Airey, Brian Cabral,
// Efficient Bump Mapping Hardware, 1997 (tangent space).
#pragma once
#include <optional>

#include "shading/texture_lookup.h"

namespace cg {

// How the point moves as u and as v grow, in eye space.
template <class Real>
struct TangentFrame {
  Vec3<Real> P_u, P_v;
};

// Of a triangle. Nothing where its uv have no area: there is no direction in which u grows.
template <class Real>
std::optional<TangentFrame<Real>> tangent_frame(const std::array<Vec3<Real>, 3>& P,
                                                const std::array<Vec2<Real>, 3>& uv) {
  const Vec3<Real> p1 = P[1] - P[0], p2 = P[2] - P[0];
  const Vec2<Real> a = uv[1] - uv[0], b = uv[2] - uv[0];
  const Real area = a.x * b.y - b.x * a.y;
  const Real scale = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  // Below that, what is left of the digits says nothing.
  const Real least = scale * scale * (sizeof(Real) == 4 ? Real(1e-6) : Real(1e-14));
  if (!(std::abs(area) > least)) return std::nullopt;
  const TangentFrame<Real> frame{(p1 * b.y - p2 * a.y) / area, (p2 * a.x - p1 * b.x) / area};
  if (!is_finite(frame.P_u) || !is_finite(frame.P_v)) return std::nullopt;
  return frame;
}

// How a height picture (its red) rises in u and in v, at level 0: the difference of the two heights a texel beside the
// point, half a texel where `step` is 0.5. A step is a low-pass: a wave of k texels is seen sin(x)/x too flat, with
// x = 2 pi step / k.
template <class Real>
Vec2<Real> height_gradient(const TextureImage& heights, const Sampling& s, const Vec2<Real>& uv, Real step = Real(1)) {
  const Vec2<Real> h(step / Real(heights.width()), step / Real(heights.height()));
  const auto at = [&](Real u, Real v) { return linear_texels<Real>(heights, s, 0, {u, v}).x; };
  return {(at(uv.x + h.x, uv.y) - at(uv.x - h.x, uv.y)) / (Real(2) * h.x),
          (at(uv.x, uv.y + h.y) - at(uv.x, uv.y - h.y)) / (Real(2) * h.y)};
}

// N' of the surface that lies F above this one along N, unit: N + [F_u (N x P_v) - F_v (N x P_u)] / |P_u x P_v|, for a
// unit N. `F`: F_u and F_v, a length over the change of uv. Of first order: what N itself turns over the height F is
// left out. A gradient of 0 gives N back, to the bit.
template <class Real>
Vec3<Real> bumped_normal(const Vec3<Real>& N, const TangentFrame<Real>& frame, const Vec2<Real>& F) {
  if (F.x == Real(0) && F.y == Real(0)) return N;
  // Where N is not the triangle's own, only what of P_u and P_v is square to it counts: the area as N sees it.
  const Real area = glm::dot(glm::cross(frame.P_u, frame.P_v), N);
  if (!(std::abs(area) > Real(0))) return N;
  const Vec3<Real> turned = (F.x * glm::cross(N, frame.P_v) - F.y * glm::cross(N, frame.P_u)) / area;
  const Vec3<Real> bumped = unit(N + turned);
  return bumped == Vec3<Real>(Real(0)) ? N : bumped;
}

// A normal picture's colour 0..1 as a normal in the frame (P_u, P_v, N), brought to unit length; blue is along N.
// `strength` scales what is not along N.
template <class Real>
Vec3<Real> mapped_normal(const Vec3<Real>& N, const TangentFrame<Real>& frame, const Vec3<Real>& colour,
                         Real strength) {
  const Vec3<Real> n = Real(2) * colour - Vec3<Real>(Real(1));
  const Real x = n.x * strength, y = n.y * strength, z = std::max(n.z, Real(1e-3));
  if (x == Real(0) && y == Real(0)) return N;
  // T and B: P_u and P_v made square to N and unit.
  const auto along = [&](const Vec3<Real>& p) { return unit(p - glm::dot(p, N) * N); };
  const Vec3<Real> mapped = unit(x * along(frame.P_u) + y * along(frame.P_v) + z * N);
  return mapped == Vec3<Real>(Real(0)) ? N : mapped;
}

}  // namespace cg
