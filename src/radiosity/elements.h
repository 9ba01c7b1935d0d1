// Elements of different sizes side by side: where they meet, the light at their corners, and which of them to cut.
// This work is based on: Michael Cohen, Donald Greenberg, David Immel, Philip Brock, An Efficient Radiosity Approach
// for Realistic Image Synthesis, 1986 (cut where the light changes); Brian Von Herzen and Alan Barr, Accurate
// Triangulations of Deformed, Intersecting Surfaces, 1987 (neighbours differ by one level at most); Daniel Baum,
// Stephen Mann, Kevin Smith, James Winget, Making Radiosity Usable, 1991 (T-vertices).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/patches.h"

namespace cg {

// A vertex inside an edge of a larger element: where (1 - t) a + t b is.
struct HangingVertex {
  std::uint32_t vertex, a, b;  // indices into Patches::vertices
  double t;                    // 0 < t < 1
};

// Every element's outline with the vertices that lie inside its edges, so that elements side by side have the same
// points along their border and no crack opens between them.
struct Outlines {
  std::vector<std::uint32_t> first{0};  // the outline of element e is vertex[first[e]] .. vertex[first[e+1]-1]
  std::vector<std::uint32_t> vertex;
  std::vector<HangingVertex> hanging;  // from the longest edge to the shortest
};

Outlines outlines_of(const Patches& patches);

// One value for each vertex from one for each element: the mean of the elements that meet there in one surface,
// weighted by area; a hanging vertex lies on the line between the ends of its edge, so that light is continuous there.
std::vector<glm::dvec3> vertex_values(const Patches& patches, const Outlines& outlines,
                                      std::span<const glm::dvec3> element_values);

// Cuts each element in four, up to options.adaptive_levels, whose corners differ by more than options.gradient of the
// mean of `radiosity` over all area (one value an element, B/pi - E), and as many more as keep neighbours within one
// level. Returns the former index of each element's whole, or nothing where no element was cut; radiosity is then to be
// gathered anew for those whose level changed. Throws Cancelled.
std::vector<std::uint32_t> refine_elements(Patches& patches, std::span<const glm::dvec3> radiosity,
                                           const Radiosity& options, Progress& progress);

// Cuts the elements until they have these levels, in order, as refine_elements() once left them. Returns false, and
// changes nothing, where no cuts of these patches do. Throws Cancelled.
bool cut_to_levels(Patches& patches, std::span<const int> levels, const Progress& progress);

}  // namespace cg
