// Where two surfaces meet at an edge that each cuts in its own way: the points of both go into both, so that no pixel
// falls between them.
#pragma once
#include <cstdint>
#include <vector>

#include "radiosity/elements.h"

namespace cg {

// The outlines with, inside their edges, the points of other surfaces that lie there. `vertex` beyond the vertices of
// the patches is a seam, in order: it lies (1 - t) a + t b, and its light is that of its own surface there.
struct SeamedOutlines {
  std::vector<std::uint32_t> first{0}, vertex;
  std::vector<HangingVertex> seams;
};

SeamedOutlines with_seams(const Patches& patches, const Outlines& outlines);

}  // namespace cg
