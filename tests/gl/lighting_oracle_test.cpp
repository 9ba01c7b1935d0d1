// The lighting equation alone, in a float picture, against the light model in double: at most 5e-5 off.
// A sample of the states runs by default; all of them by
//   SHADEBENCH_LIGHTING_STATES=1000000 test_gl --gtest_filter='LightingOracle.*'
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "lighting_states.h"

namespace cg {
namespace {

constexpr double tolerance = 5e-5;

std::size_t wanted_states() {
  const char* text = std::getenv("SHADEBENCH_LIGHTING_STATES");
  return text ? std::strtoul(text, nullptr, 10) : 20000;
}

using Draw = std::vector<glm::vec4> (LightingPictures::*)(const Points&, const StateKind&);

void check_all_kinds(const char* technique, Draw draw_points) {
  LightingPictures pictures;
  const std::vector<StateKind> kinds = state_kinds();
  const std::size_t a_kind = wanted_states() / kinds.size();
  StateErrors all;
  for (const StateKind& kind : kinds) {
    Random r(0x5eed);
    StateErrors e;
    while (e.states < a_kind) {
      const Points p = random_points(r, kind);
      compare(p, kind, (pictures.*draw_points)(p, kind), e);
    }
    std::printf("%-9s %-40s %8zu states, largest error %.2e, %zu on an edge, %zu left out\n", technique, kind.name,
                e.states, e.largest, e.left_out, e.faults);
    EXPECT_LT(e.largest, tolerance) << kind.name;
    EXPECT_EQ(e.not_finite, 0u) << kind.name;
    EXPECT_LT(double(e.left_out), 0.001 * double(e.states) + 5) << kind.name;
    all.states += e.states, all.largest = std::max(all.largest, e.largest);
  }
  std::printf("%-9s %-40s %8zu states, largest error %.2e\n", technique, "all", all.states, all.largest);
}

TEST(LightingOracle, FixedFunction) { check_all_kinds("gl-fixed", &LightingPictures::fixed); }
TEST(LightingOracle, Glsl) { check_all_kinds("gl", &LightingPictures::glsl); }

}  // namespace
}  // namespace cg
