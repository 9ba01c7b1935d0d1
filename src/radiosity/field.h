// A solution as the techniques draw it.
#pragma once
#include <span>

#include "radiosity/patches.h"
#include "scene/radiosity_field.h"

namespace cg {

// One mesh an object, of its elements, with the reflected light at their corners. `element_radiosity` is B/pi by
// element; the patches were made of `scene`. `summary` is left empty.
RadiosityField field_of(const Scene& scene, const Patches& patches, std::span<const glm::dvec3> element_radiosity,
                        std::uint64_t geometry);

}  // namespace cg
