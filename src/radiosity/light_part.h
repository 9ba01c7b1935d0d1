// Which part of the light of a radiosity solution.
#pragma once
#include "params/field.h"

namespace cg {

// What of the light is looked at.
enum class LightPart { total, unshot, received, indirect };
template <>
inline constexpr std::array<Name, 4> names_of<LightPart>{{{"total", {"Total", "全体"}},
                                                          {"unshot", {"Not yet shot", "未放出"}},
                                                          {"received", {"Received", "受け取った光"}},
                                                          {"indirect", {"Indirect only", "間接光だけ"}}}};

}  // namespace cg
