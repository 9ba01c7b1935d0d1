#include "workbench/probe_lines.h"

#include "math/vec.h"

namespace cg {

std::vector<ProbedVector> probed_vectors(const LitPoint& point, int light, double length) {
  std::vector<ProbedVector> out;
  const auto add = [&](std::string_view letter, Mark mark, const glm::dvec3& direction) {
    if (direction != glm::dvec3(0)) out.push_back({letter, mark, point.P, point.P + length * direction});
  };
  add("N", Mark::vector_N, point.N);
  add("V", Mark::vector_V, point.V);
  for (const ProbedLight& l : point.lights) {
    if (l.light != light) continue;
    add("L", Mark::vector_L, l.L);
    if (!(l.cosine > 0)) continue;
    add("R", Mark::vector_R, l.R);
    add("H", Mark::vector_H, l.H);
  }
  return out;
}

std::vector<Lines> vector_lines(const std::vector<ProbedVector>& vectors) {
  std::vector<Lines> out;
  const auto line = [](const ProbedVector& v, Mark mark) {
    return Lines{mark, v.foot, {glm::vec3(0), glm::vec3(v.tip - v.foot)}};
  };
  for (const ProbedVector& v : vectors) out.push_back(line(v, Mark::vector_edge));
  for (const ProbedVector& v : vectors) out.push_back(line(v, v.mark));
  return out;
}

Lines triangle_lines(const Probe& probe) {
  Lines out{Mark::probed_face, {}, {}};
  if (probe.vertices.size() != 3) return out;
  out.origin = probe.vertices[0].P;
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t end : {k, (k + 1) % 3}) out.points.push_back(glm::vec3(probe.vertices[end].P - out.origin));
  return out;
}

const LitPoint& shown_point(const Probe& probe, int vertex) {
  if (probe.mode == ShadingMode::flat && !probe.vertices.empty()) return probe.vertices[0];
  if (vertex >= 0 && vertex < int(probe.vertices.size())) return probe.vertices[std::size_t(vertex)];
  return probe.here;
}

}  // namespace cg
