// The form factor as the closed form has it, and whether anything stands between, which the closed form does not see.
#pragma once
#include "params/words.h"
#include "radiosity/patches.h"
#include "scene/item_drawer.h"

namespace cg {

struct KnownFactor {
  double value = 0;                 // as if nothing stood between
  std::uint32_t between = no_item;  // a patch that does; no_item: the value is exact
  bool exact() const { return between == no_item; }
};

// F_ij of two patches with area, and of a point of patch i (in its plane, seen to the side of its normal) and patch j.
KnownFactor known_factor(const Patches& patches, std::uint32_t i, std::uint32_t j);
KnownFactor known_factor(const Patches& patches, std::uint32_t i, const glm::dvec3& point, std::uint32_t j);

}  // namespace cg
