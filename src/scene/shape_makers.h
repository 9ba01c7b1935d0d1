// One maker a shape; shape.cpp lists them. Each fits the unit ball as make_shape promises.
#pragma once
#include "scene/mesh.h"

namespace cg {

MeshData make_teapot(int level);      // segments along each side of a patch
MeshData make_uv_sphere(int level);   // slices; half as many stacks
MeshData make_icosphere(int level);   // times an icosahedron's faces are cut in four: 20 * 4^level triangles
MeshData make_torus(int level);       // segments around the ring; half as many around the tube
MeshData make_torus_knot(int level);  // segments around the tube; ten times as many along it
MeshData make_cube(int level);        // segments along each edge
MeshData make_cylinder(int level);    // slices; a quarter as many rows
MeshData make_cone(int level);        // slices; a quarter as many rows
MeshData make_plane(int level);       // segments along each side

}  // namespace cg
