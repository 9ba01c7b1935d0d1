// Undo and redo: every step comes back, a drag is one, the oldest are forgotten.
#include "workbench/history.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace cg {
namespace {

TEST(History, GoesBackAndForth) {
  History<int> h(0);
  EXPECT_FALSE(h.can_undo());
  EXPECT_EQ(h.undo(), 0);
  h.change(1);
  h.change(2);
  EXPECT_EQ(h.undo(), 1);
  EXPECT_EQ(h.undo(), 0);
  EXPECT_FALSE(h.can_undo());
  EXPECT_EQ(h.redo(), 1);
  h.change(5);
  EXPECT_FALSE(h.can_redo());
  EXPECT_EQ(h.undo(), 1);
  EXPECT_EQ(h.redo(), 5);
}

TEST(History, SameValueIsNoStep) {
  History<int> h(0);
  h.change(0);
  EXPECT_FALSE(h.can_undo());
}

TEST(History, ADragIsOneStep) {
  History<int> h(0);
  for (int i = 1; i <= 50; ++i) h.change(i, "material.n");
  h.end_gesture();
  for (int i = 51; i <= 60; ++i) h.change(i, "material.n");
  h.change(100, "material.k_d");
  EXPECT_EQ(h.undo(), 60);
  EXPECT_EQ(h.undo(), 50);
  EXPECT_EQ(h.undo(), 0);
  EXPECT_FALSE(h.can_undo());
}

TEST(History, ADragThatCameBackIsNoStep) {
  History<int> h(7);
  h.change(8, "w");
  h.change(7, "w");
  EXPECT_FALSE(h.can_undo());
  h.change(8);
  h.change(7);
  EXPECT_EQ(h.undo(), 8);
}

TEST(History, IsBounded) {
  History<int> h(0, 10);
  for (int i = 1; i <= 100; ++i) h.change(i);
  int steps = 0;
  for (; h.can_undo(); ++steps) h.undo();
  EXPECT_EQ(steps, 10);
  EXPECT_EQ(h.now(), 90);
}

// Against a plain list of all values.
TEST(History, RandomWalk) {
  std::mt19937 random(3);
  History<int> h(0, 1000000);
  std::vector<int> values{0};
  std::size_t at = 0;
  for (int i = 0; i < 20000; ++i) {
    if (const auto what = random() % 3; what == 0) {
      const int v = int(random() % 1000);
      if (v == values[at]) continue;
      values.resize(at + 1);
      values.push_back(v);
      ++at;
      h.change(v);
    } else if (what == 1) {
      if (at > 0) --at;
      h.undo();
    } else {
      if (at + 1 < values.size()) ++at;
      h.redo();
    }
    ASSERT_EQ(h.now(), values[at]);
  }
}

}  // namespace
}  // namespace cg
