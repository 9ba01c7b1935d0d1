// How the two pictures stand to each other on the screen.
#pragma once
#include "params/field.h"

namespace cg {

enum class ViewMode { two, wipe, flip, difference, false_colour };
template <>
inline constexpr std::array<Name, 5> names_of<ViewMode>{{{"two", {"Two", "並べる"}},
                                                         {"wipe", {"Wipe", "ワイプ"}},
                                                         {"flip", {"Flip", "切替"}},
                                                         {"difference", {"Difference", "差"}},
                                                         {"false-colour", {"False colour", "擬似カラー"}}}};

}  // namespace cg
