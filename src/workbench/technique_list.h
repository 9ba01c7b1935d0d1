// Techniques by name.
#pragma once
#include <span>
#include <string_view>

#include "scene/technique.h"

namespace cg {

// The technique with that id. Throws InputError that lists those there are.
const Technique& find_technique(std::span<const Technique> all, std::string_view id);

// Throws InputError with the reason where the technique cannot work here or cannot draw the scene.
void require(const Technique& technique, const Scene& scene);

// The first of these ids that is there and can draw the scene; null where none can.
const Technique* first_able(std::span<const Technique> all, const Scene& scene,
                            std::initializer_list<std::string_view> ids);

}  // namespace cg
