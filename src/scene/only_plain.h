// SHADEBENCH_ONLY_PLAIN builds without anything that the plainest scene (one mesh, one directional light that is
// diffuse) goes without, so that tests/bench/plain_main.cpp can measure what it costs that all the rest is there.
#pragma once

namespace cg {

#ifdef SHADEBENCH_ONLY_PLAIN
inline constexpr bool only_plain = true;
#else
inline constexpr bool only_plain = false;
#endif

// Whether something is used that the plain scene goes without.
constexpr bool optional(bool used) { return !only_plain && used; }

}  // namespace cg
