// The vectors of a probed point as lines in the world.
#pragma once
#include "workbench/overlay.h"
#include "workbench/probe.h"

namespace cg {

// A vector of the light model from the point where it was computed.
struct ProbedVector {
  std::string_view letter;  // "N", "L", "R", "V", "H"
  Mark mark = Mark::vector_N;
  glm::dvec3 foot{0}, tip{0};  // world
};

// N and V of the point, and L, R and H of the light with that index (into Scene::lights), where it is on; each
// `length` metres long. Vectors without a direction are left out, R and H also where the light is behind.
std::vector<ProbedVector> probed_vectors(const LitPoint& point, int light, double length);

// The same as lines, each with a dark edge so that it is seen on white too.
std::vector<Lines> vector_lines(const std::vector<ProbedVector>& vectors);

// The edges of the triangle whose vertices were lit; empty where fewer than three were.
Lines triangle_lines(const Probe& probe);

// The point whose factors are shown: the vertex that was lit with flat shading; with Gouraud shading the vertex of
// that index, or the pixel where it is negative; the pixel with Phong shading.
const LitPoint& shown_point(const Probe& probe, int vertex);

}  // namespace cg
