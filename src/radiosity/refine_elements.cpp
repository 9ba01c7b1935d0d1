#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <optional>

#include "radiosity/channels.h"
#include "radiosity/elements.h"
#include "radiosity/vertex_numbers.h"
#include "scene/polygon.h"

namespace cg {

namespace {

using Index = std::uint32_t;

// Elements whose corners differ by more than the share that is allowed.
std::vector<bool> steep_elements(const Patches& patches, std::span<const glm::dvec3> radiosity,
                                 const Radiosity& options) {
  glm::dvec3 light(0);
  double area = 0;
  for (Index e = 0; e < patches.elements.size(); ++e) {
    light += patches.elements[e].area * radiosity[e];
    area += patches.elements[e].area;
  }
  const double allowed = area > 0 ? options.gradient * largest(light) / area : 0;
  const std::vector<glm::dvec3> values = vertex_values(patches, outlines_of(patches), radiosity);
  std::vector<bool> cut(patches.elements.size());
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element& element = patches.elements[e];
    glm::dvec3 low = values[element.vertex[0]], high = low;
    for (int i = 1; i < element.corners; ++i) {
      low = glm::min(low, values[element.vertex[std::size_t(i)]]);
      high = glm::max(high, values[element.vertex[std::size_t(i)]]);
    }
    cut[e] = element.level < options.adaptive_levels && largest(high - low) > allowed;
  }
  return cut;
}

// Elements beside one that is two levels finer or more.
std::vector<bool> unbalanced_elements(const Patches& patches) {
  std::vector<int> finest(patches.vertices.size(), 0);
  for (const Element& e : patches.elements)
    for (int i = 0; i < e.corners; ++i) {
      int& level = finest[e.vertex[std::size_t(i)]];
      level = std::max(level, e.level);
    }
  const Outlines outlines = outlines_of(patches);
  std::vector<bool> cut(patches.elements.size());
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element& element = patches.elements[e];
    const auto corners_end = element.vertex.begin() + element.corners;
    for (Index i = outlines.first[e]; i < outlines.first[e + 1]; ++i) {
      const Index v = outlines.vertex[i];
      if (std::find(element.vertex.begin(), corners_end, v) == corners_end && finest[v] > element.level + 1)
        cut[e] = true;
    }
  }
  return cut;
}

double area_of(const Patches& patches, const Element& e) {
  std::array<glm::dvec3, 4> p{};
  for (std::size_t i = 0; i < std::size_t(e.corners); ++i) p[i] = patches.vertices[e.vertex[i]].position;
  return glm::length(vector_area(std::span(p).first(std::size_t(e.corners))));
}

// Cuts the marked elements; `whole` has for each element the index of what it was before all cuts.
void cut_elements(Patches& patches, std::vector<Index>& whole, const std::vector<bool>& cut) {
  VertexNumbers number(patches.vertices);
  std::vector<Element> elements;
  std::vector<Index> wholes;
  const auto middle = [&](Index a, Index b) { return number(between(patches.vertices[a], patches.vertices[b], 1, 2)); };
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const Element old = patches.elements[e];
    const auto add = [&](std::array<Index, 4> vertex) {
      elements.push_back({vertex, old.corners, old.patch, old.level + 1, 0});
      elements.back().area = area_of(patches, elements.back());
      wholes.push_back(whole[e]);
    };
    if (!cut[e]) {
      elements.push_back(old);
      wholes.push_back(whole[e]);
      continue;
    }
    const auto& v = old.vertex;
    if (old.corners == 3) {
      const Index a = middle(v[0], v[1]), b = middle(v[1], v[2]), c = middle(v[2], v[0]);
      add({v[0], a, c, 0}), add({a, v[1], b, 0}), add({c, b, v[2], 0}), add({a, b, c, 0});
    } else {
      const Index a = middle(v[0], v[1]), b = middle(v[1], v[2]), c = middle(v[2], v[3]), d = middle(v[3], v[0]);
      const Index m = middle(a, c);
      add({v[0], a, m, d}), add({a, v[1], b, m}), add({m, b, v[2], c}), add({d, m, c, v[3]});
    }
  }
  patches.elements = std::move(elements);
  whole = std::move(wholes);
  patches.first_element.assign(1, 0);
  for (Index e = 0; e < patches.elements.size(); ++e)
    if (e + 1 == patches.elements.size() || patches.elements[e + 1].patch != patches.elements[e].patch)
      patches.first_element.push_back(e + 1);
}

// Numbers the vertices in the order in which the elements use them, whatever order of cuts made them.
void number_by_use(Patches& patches) {
  std::vector<Index> number(patches.vertices.size(), no_index);
  std::vector<ElementVertex> used;
  used.reserve(patches.vertices.size());
  for (Element& e : patches.elements)
    for (int i = 0; i < e.corners; ++i) {
      Index& v = e.vertex[std::size_t(i)];
      if (number[v] == no_index) {
        number[v] = Index(used.size());
        used.push_back(patches.vertices[v]);
      }
      v = number[v];
    }
  patches.vertices = std::move(used);
}

}  // namespace

std::vector<std::uint32_t> refine_elements(Patches& patches, std::span<const glm::dvec3> radiosity,
                                           const Radiosity& options, Progress& progress) {
  std::vector<bool> cut = steep_elements(patches, radiosity, options);
  if (std::find(cut.begin(), cut.end(), true) == cut.end()) return {};
  Patches finer = patches;
  std::vector<Index> whole(patches.elements.size());
  std::iota(whole.begin(), whole.end(), 0u);
  while (std::find(cut.begin(), cut.end(), true) != cut.end()) {
    if (progress.cancelled) throw Cancelled{};
    cut_elements(finer, whole, cut);
    cut = unbalanced_elements(finer);
  }
  number_by_use(finer);
  patches = std::move(finer);
  return whole;
}

namespace {

constexpr int most_levels = 20;

// Which elements must be cut to come nearer to the levels; nothing where they cannot be reached. A cut element's
// descendants stand together: what they take of it, 4^-(levels below it) each, sums to 1.
std::optional<std::vector<bool>> cuts_towards(const Patches& patches, std::span<const int> levels) {
  std::vector<bool> cut(patches.elements.size());
  std::size_t next = 0;
  for (Index e = 0; e < patches.elements.size(); ++e) {
    const int level = patches.elements[e].level;
    double taken = 0;
    while (taken < 1) {
      if (next == levels.size() || levels[next] < level || levels[next] > most_levels) return std::nullopt;
      cut[e] = cut[e] || levels[next] > level;
      taken += std::ldexp(1.0, -2 * (levels[next++] - level));
    }
    if (taken > 1) return std::nullopt;
  }
  if (next != levels.size()) return std::nullopt;
  return cut;
}

}  // namespace

bool cut_to_levels(Patches& patches, std::span<const int> levels, const Progress& progress) {
  Patches finer = patches;
  std::vector<Index> whole(finer.elements.size());
  for (int round = 0; round <= most_levels; ++round) {
    if (progress.cancelled) throw Cancelled{};
    const auto cut = cuts_towards(finer, levels);
    if (!cut) return false;
    if (std::find(cut->begin(), cut->end(), true) == cut->end()) {
      if (round > 0) number_by_use(finer);
      patches = std::move(finer);
      return true;
    }
    cut_elements(finer, whole, *cut);
  }
  return false;
}

}  // namespace cg
