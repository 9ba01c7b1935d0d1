// Automatic mapping: uv by projection from a plane, a cylinder, a sphere, a box or the eye (Bier and Sloan, Two-Part
// Texture Mappings, 1986).
#pragma once
#include "mapping/corner_uv.h"
#include "scene/mapping_parameters.h"

namespace cg {

// A pair per corner of the mesh, finite whatever the mesh. The projector's local coordinates (x, y, z) are the mesh's
// by the inverse of its transform.
//   planar       u = (x + 1)/2, v = (y + 1)/2
//   cylindrical  u = phi/2 pi, v = (y + 1)/2, phi = atan2(-z, x): to the right seen from outside
//   spherical    u = phi/2 pi, v = theta/pi, theta from the lower pole
//   box          from that of the six directions that the face looks in; u to the right and v upwards seen from there
//   view         the camera's picture from (0, 0) at its lower left to (1, 1); behind the eye, the picture's border
// Where phi passes a whole turn inside a face, the corners behind the seam have u beyond 1 (before the repeats). At a
// pole phi has no value: each face takes the mean of its two corners beside the pole.
CornerUv projected_uv(const MeshData& data, const Projector& projector);

// A projector of that shape that fits the mesh's box: the whole texture once around it. Planar looks along the axis in
// which the mesh is thinnest.
Projector fitting_projector(ProjectionShape shape, const Mesh& mesh);

}  // namespace cg
