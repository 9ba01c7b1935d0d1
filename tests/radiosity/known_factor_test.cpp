// What stands between two patches is found, and what only touches them is not.
#include "radiosity/known_factor.h"

#include <gtest/gtest.h>

#include "patch_rooms.h"

namespace cg {
namespace {

const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

// Unit squares opposite each other at distance 1: 0 looks up, 1 looks down.
Patches two_squares() {
  Patches out;
  add_rectangle(out, o, x, y);
  add_rectangle(out, z, y, x);
  return out;
}

TEST(KnownFactor, OfOppositeSquaresAndOfThePointInTheMiddle) {
  const Patches squares = two_squares();
  const KnownFactor whole = known_factor(squares, 0, 1), point = known_factor(squares, 0, {0.5, 0.5, 0}, 1);
  EXPECT_TRUE(whole.exact());
  EXPECT_TRUE(point.exact());
  EXPECT_NEAR(whole.value, 0.199824895698, 1e-11);
  EXPECT_NEAR(point.value, 0.239456470461, 1e-11);
}

TEST(KnownFactor, APatchBetweenIsNamed) {
  Patches squares = two_squares();
  const auto blocker = [&](const glm::dvec3& at, double side) {
    Patches out = squares;
    add_rectangle(out, {5, 5, 5}, x, y);  // far away
    add_rectangle(out, at, side * x, side * y);
    return out;
  };
  EXPECT_EQ(known_factor(blocker({0.4, 0.4, 0.5}, 0.2), 0, 1).between, 3u);
  EXPECT_EQ(known_factor(blocker({0.99, 0.99, 0.99}, 0.2), 0, 1).between, 3u);  // a corner of it
  EXPECT_TRUE(known_factor(blocker({1, 0.4, 0.5}, 0.2), 0, 1).exact());         // it touches the hull from outside
  EXPECT_TRUE(known_factor(blocker({0.4, 0.4, 1.001}, 0.2), 0, 1).exact());     // above
  // Seen from a corner of the lower square that one is aside.
  EXPECT_EQ(known_factor(blocker({0, 0.8, 0.5}, 0.1), 0, 1).between, 3u);
  EXPECT_TRUE(known_factor(blocker({0, 0.8, 0.5}, 0.1), 0, {1, 0, 0}, 1).exact());
}

// Edge on from everywhere but inside: it takes light all the same.
TEST(KnownFactor, AThinWallBetweenIsFound) {
  Patches squares = two_squares();
  add_rectangle(squares, {0.5, 0, 0.2}, y, 0.1 * z);
  EXPECT_EQ(known_factor(squares, 0, 1).between, 2u);
}

// In a convex room nothing stands between, however patches touch.
TEST(KnownFactor, InAClosedCubeAllAreExactAndSumToOne) {
  const Patches cube = closed_cube(3);
  const auto count = std::uint32_t(cube.patches.size());
  for (const std::uint32_t i : {0u, 4u, 17u, 53u}) {
    double sum = 0;
    for (std::uint32_t j = 0; j < count; ++j) {
      if (j == i) continue;
      const KnownFactor f = known_factor(cube, i, j);
      EXPECT_TRUE(f.exact()) << i << " to " << j << " by " << f.between;
      sum += f.value;
    }
    EXPECT_NEAR(sum, 1, 1e-9) << i;
  }
}

// What is partly behind the other's plane: only the part in front can be hidden.
TEST(KnownFactor, WhatStandsBeforeAPartThatIsBehindHidesNothing) {
  Patches p;
  add_rectangle(p, o, x, y);                 // in the plane z = 0, looks up
  add_rectangle(p, {2, 0, -1}, 2.0 * z, y);  // upright at x = 2, half of it below; looks to -x
  if (p.patches[1].normal.x > 0) p.patches[1] = make_patch({{2, 0, -1}, {2, 0, 1}, {2, 1, 1}, {2, 1, -1}});
  const KnownFactor free = known_factor(p, 0, 1);
  EXPECT_GT(free.value, 0.01);
  EXPECT_TRUE(free.exact());
  add_rectangle(p, {1.5, 0.2, -0.8}, 0.6 * z, 0.6 * y);  // before its lower half
  EXPECT_TRUE(known_factor(p, 0, 1).exact());
  add_rectangle(p, {1.5, 0.2, 0.1}, 0.3 * z, 0.6 * y);  // before its upper half
  EXPECT_EQ(known_factor(p, 0, 1).between, 3u);
}

}  // namespace
}  // namespace cg
