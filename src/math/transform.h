// Matrices of the viewing pipeline: object, world, eye, clip. Column vectors, right-handed, y up, in double:
// they are rounded to float only when a technique takes them, so that far offsets and extreme scales survive.
#pragma once
#include "math/vec.h"

namespace cg {

inline constexpr double pi = 3.14159265358979323846;
constexpr double radians(double degrees) { return degrees * (pi / 180); }
constexpr double degrees(double radians) { return radians * (180 / pi); }

glm::dmat4 translation(const glm::dvec3& t);
glm::dmat4 scaling(const glm::dvec3& s);
// `angle` in radians about `axis` (any length; a zero axis gives the identity), as glRotate.
glm::dmat4 rotation(double angle, const glm::dvec3& axis);

// The camera's frame, as gluLookAt. Where eye == target it looks along -z; where `up` is parallel to the
// view it takes the axis least parallel to it. Always a rigid, finite matrix.
glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

// As gluPerspective: `fov` vertical, radians, limited to 1e-3..pi-1e-3; near > 0; far > near; aspect > 0
// (each limited, so that the matrix is finite and invertible).
glm::dmat4 perspective(double fov, double aspect, double near_plane, double far_plane);
// As glOrtho, centred: `height` of the view volume in world units.
glm::dmat4 orthographic(double height, double aspect, double near_plane, double far_plane);

// M^-T of the upper 3x3: how normals transform. The cofactors where M is singular, so that it stays finite;
// its sign is that of M^-T (a mirror does not flip a normal).
glm::dmat3 normal_matrix(const glm::dmat4& m);

}  // namespace cg
