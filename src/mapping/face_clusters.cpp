// Clusters by greedy merging: Garland, Willmott and Heckbert, Hierarchical Face Clustering on Polygonal Surfaces, 2001,
// with the spread of normals of Cohen-Steiner, Alliez and Desbrun, Variational Shape Approximation, 2004, as the cost.
#include "mapping/face_clusters.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

#include "math/transform.h"
#include "math/vec.h"
#include "scene/polygon.h"

namespace cg {

namespace {

double edge_length(const UnwrapSurface& s, std::uint32_t c) { return glm::distance(s.point(c), s.point(s.next(c))); }

struct Cluster {
  glm::dvec3 normal{0};  // sum of vector areas
  double area = 0, perimeter = 0;
  std::uint32_t version = 0;
  std::map<std::uint32_t, double> shared;  // length of the border with each neighbour
};

struct Pair {
  double cost;
  std::uint32_t a, b, version_a, version_b;
  bool operator<(const Pair& o) const { return std::tie(o.cost, o.a, o.b) < std::tie(cost, a, b); }  // least on top
};

class Merger {
 public:
  Merger(const UnwrapSurface& s, double bend, const EdgeCuts& cuts)
      : bend_(bend), cluster_(s.face_count()), root_(s.face_count()) {
    std::vector<glm::dvec3> polygon;
    for (std::uint32_t f = 0; f < s.face_count(); ++f) {
      root_[f] = f;
      if (!s.has_area(f)) continue;
      polygon.clear();
      for (std::uint32_t c = s.first(f); c < s.end(f); ++c) {
        polygon.push_back(s.point(c));
        const double length = edge_length(s, c);
        cluster_[f].perimeter += length;
        if (!cuts[c]) cluster_[f].shared[s.face_of(s.across(c))] += length;
      }
      cluster_[f].normal = vector_area(polygon);
      cluster_[f].area = glm::length(cluster_[f].normal);
    }
    for (std::uint32_t f = 0; f < s.face_count(); ++f)
      for (const auto& [g, length] : cluster_[f].shared)
        if (f < g) consider(f, g, length);
  }

  void merge_all() {
    while (!pairs_.empty()) {
      const Pair p = pairs_.top();
      pairs_.pop();
      if (cluster_[p.a].version == p.version_a && cluster_[p.b].version == p.version_b) merge(p.a, p.b);
    }
  }

  std::uint32_t root(std::uint32_t f) {
    while (root_[f] != f) f = root_[f] = root_[root_[f]];
    return f;
  }

 private:
  void consider(std::uint32_t a, std::uint32_t b, double length) {
    const Cluster &x = cluster_[a], &y = cluster_[b];
    const double area = x.area + y.area;
    const double spread = area > 0 ? 1 - glm::length(x.normal + y.normal) / area : 0;
    if (spread > bend_ || glm::dot(unit(x.normal), unit(y.normal)) < 0.3)
      return;  // also what is small beside the other
    const double perimeter = x.perimeter + y.perimeter - 2 * length;
    const double roundness = perimeter / std::sqrt(4 * pi * std::max(area, 1e-300));  // 1 for a circle
    pairs_.push({spread + 0.15 * std::min(roundness, 10.0), std::min(a, b), std::max(a, b),
                 cluster_[std::min(a, b)].version, cluster_[std::max(a, b)].version});
  }

  void merge(std::uint32_t a, std::uint32_t b) {
    if (cluster_[a].shared.size() < cluster_[b].shared.size()) std::swap(a, b);
    Cluster &x = cluster_[a], &y = cluster_[b];
    root_[b] = a;
    x.normal += y.normal, x.area += y.area;
    x.perimeter += y.perimeter - 2 * x.shared[b];
    ++x.version, y.version = no_index;
    x.shared.erase(b);
    for (const auto& [g, length] : y.shared) {
      if (g == a) continue;
      x.shared[g] += length;
      cluster_[g].shared.erase(b);
      cluster_[g].shared[a] = x.shared[g];
    }
    y.shared.clear();
    for (const auto& [g, length] : x.shared) consider(a, g, length);
  }

  double bend_;
  std::vector<Cluster> cluster_;
  std::vector<std::uint32_t> root_;
  std::priority_queue<Pair> pairs_;
};

// Gives a face to the neighbouring cluster with which it has more of its border in common than with its own, unless it
// looks another way.
void smooth_borders(const UnwrapSurface& s, const EdgeCuts& cuts, std::vector<std::uint32_t>& label) {
  std::vector<glm::dvec3> normal(s.face_count(), glm::dvec3(0)), sum(s.face_count(), glm::dvec3(0));
  std::vector<glm::dvec3> polygon;
  for (std::uint32_t f = 0; f < s.face_count(); ++f) {
    polygon.clear();
    for (std::uint32_t c = s.first(f); c < s.end(f); ++c) polygon.push_back(s.point(c));
    normal[f] = vector_area(polygon);
    sum[label[f]] += normal[f];
  }
  std::map<std::uint32_t, double> shared;
  for (int pass = 0; pass < 8; ++pass)
    for (std::uint32_t f = 0; f < s.face_count(); ++f) {
      shared.clear();
      for (std::uint32_t c = s.first(f); c < s.end(f); ++c)
        if (!cuts[c]) shared[label[s.face_of(s.across(c))]] += edge_length(s, c);
      std::uint32_t best = label[f];
      for (const auto& [other, length] : shared)
        if (length > 1.001 * shared[best]) best = other;
      if (best == label[f]) continue;
      const glm::dvec3 n = unit(normal[f]);
      if (glm::dot(n, unit(sum[best])) < glm::dot(n, unit(sum[label[f]])) - 0.2) continue;
      sum[label[f]] -= normal[f], sum[best] += normal[f];
      label[f] = best;
    }
}

struct Reach {
  double distance;
  std::uint32_t face, source;
  bool operator<(const Reach& o) const { return std::tie(o.distance, o.face) < std::tie(distance, face); }
};

// The nearest of the sources for each of the faces, by the way between face centres, and the farthest face.
std::uint32_t spread_from(const UnwrapSurface& s, const EdgeCuts& cuts, const std::vector<std::uint32_t>& sources,
                          std::map<std::uint32_t, std::uint32_t>& source_of) {
  const auto centre = [&](std::uint32_t f) {
    glm::dvec3 sum(0);
    for (std::uint32_t c = s.first(f); c < s.end(f); ++c) sum += s.point(c);
    return sum / double(s.end(f) - s.first(f));
  };
  std::priority_queue<Reach> front;
  for (std::uint32_t i = 0; i < sources.size(); ++i) front.push({0, sources[i], i});
  std::uint32_t farthest = sources.front();
  source_of.clear();
  while (!front.empty()) {
    const Reach r = front.top();
    front.pop();
    if (!source_of.emplace(r.face, r.source).second) continue;
    farthest = r.face;
    const glm::dvec3 here = centre(r.face);
    for (std::uint32_t c = s.first(r.face); c < s.end(r.face); ++c) {
      if (cuts[c]) continue;
      const std::uint32_t other = s.face_of(s.across(c));
      if (!source_of.contains(other)) front.push({r.distance + glm::distance(here, centre(other)), other, r.source});
    }
  }
  return farthest;
}

}  // namespace

void cut_into_clusters(const UnwrapSurface& s, double bend, EdgeCuts& cuts) {
  Merger merger(s, bend, cuts);
  merger.merge_all();
  std::vector<std::uint32_t> label(s.face_count());
  for (std::uint32_t f = 0; f < label.size(); ++f) label[f] = merger.root(f);
  smooth_borders(s, cuts, label);
  for (std::uint32_t c = 0; c < cuts.size(); ++c)
    if (!cuts[c] && label[s.face_of(c)] != label[s.face_of(s.across(c))]) cuts[c] = 1;
}

bool cut_in_two(const UnwrapSurface& s, const std::vector<std::uint32_t>& faces, EdgeCuts& cuts) {
  if (faces.size() < 2) return false;
  std::map<std::uint32_t, std::uint32_t> source_of;
  const std::uint32_t a = spread_from(s, cuts, {faces.front()}, source_of);
  const std::uint32_t b = spread_from(s, cuts, {a}, source_of);
  spread_from(s, cuts, {a, b}, source_of);
  for (const std::uint32_t f : faces)
    for (std::uint32_t c = s.first(f); c < s.end(f); ++c)
      if (!cuts[c] && source_of[f] != source_of[s.face_of(s.across(c))]) cuts[c] = 1;
  return true;
}

}  // namespace cg
