// What the panel of the hemicube shows of what a patch sees.
#pragma once
#include "params/field.h"

namespace cg {

enum class HemicubeShow { items, seen, weights, nusselt };
template <>
inline constexpr std::array<Name, 4> names_of<HemicubeShow>{{{"items", {"Patches", "パッチ"}},
                                                             {"seen", {"Seen", "見え方"}},
                                                             {"weights", {"ΔF", "ΔF"}},
                                                             {"nusselt", {"Nusselt", "ヌッセルト"}}}};

}  // namespace cg
