// Patches made by hand, for tests that know what each of them sees.
#pragma once
#include <algorithm>
#include <cmath>

#include "math/transform.h"
#include "radiosity/patches.h"

namespace cg {

inline Patch make_patch(const std::vector<glm::dvec3>& corners) {
  Patch p;
  p.corners = int(corners.size());
  for (std::size_t i = 0; i < 4; ++i) p.corner[i] = corners[std::min(i, corners.size() - 1)];
  const glm::dvec3 area = 0.5 * glm::cross(p.corner[2] - p.corner[0], p.corner[3] - p.corner[1]);
  p.area = glm::length(area);
  p.normal = unit(area);
  for (const glm::dvec3& c : corners) p.centre += c / double(corners.size());
  return p;
}

// The parallelogram from `at`, counter-clockwise from u to v, in nu x nv parts.
inline void add_rectangle(Patches& out, const glm::dvec3& at, const glm::dvec3& u, const glm::dvec3& v, int nu = 1,
                          int nv = 1) {
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const auto corner = [&](int a, int b) { return at + u * (double(i + a) / nu) + v * (double(j + b) / nv); };
      out.patches.push_back(make_patch({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}));
    }
}

// The unit cube from the inside, n x n patches a wall: floor (z = 0), ceiling, then the four walls.
inline Patches closed_cube(int n) {
  const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  Patches out;
  out.closed = true;
  add_rectangle(out, o, x, y, n, n);
  add_rectangle(out, z, y, x, n, n);
  add_rectangle(out, o, y, z, n, n);
  add_rectangle(out, x, z, y, n, n);
  add_rectangle(out, o, z, x, n, n);
  add_rectangle(out, y, x, z, n, n);
  return out;
}

// The unit sphere from the inside: quads between circles of latitude, triangles at the poles.
inline Patches closed_sphere(int around, int up) {
  Patches out;
  out.closed = true;
  const auto at = [&](int i, int j) {
    if (j == 0 || j == up) return glm::dvec3(0, 0, j == 0 ? -1 : 1);
    const double a = 2 * pi * (i % around) / around, b = pi * j / up;
    return glm::dvec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), -std::cos(b));
  };
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < around; ++i) {
      if (j == 0)
        out.patches.push_back(make_patch({at(i, 0), at(i, 1), at(i + 1, 1)}));
      else if (j == up - 1)
        out.patches.push_back(make_patch({at(i, j), at(i, up), at(i + 1, j)}));
      else
        out.patches.push_back(make_patch({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}));
    }
  return out;
}

}  // namespace cg
