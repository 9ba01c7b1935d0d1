// Contexts come and go, live side by side on threads, and their absence is a reason, not a crash.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "gl/gl_thread.h"

namespace cg {
namespace {

std::string version_on(GlThread& gl) {
  std::string version;
  gl.run([&] { version = reinterpret_cast<const char*>(glGetString(GL_VERSION)); });
  return version;
}

TEST(GlThread, ContextsComeAndGo) {
  for (int i = 0; i < 50; ++i) {
    GlThread legacy(GlProfile::legacy), core(GlProfile::core);
    EXPECT_FALSE(version_on(legacy).empty());
    EXPECT_FALSE(version_on(core).empty());
    EXPECT_FALSE(legacy.failure());
  }
}

TEST(GlThread, AnUnusedOneCostsNothing) {
  for (int i = 0; i < 10000; ++i) GlThread unused(GlProfile::legacy);
}

TEST(GlThread, LegacyHasFixedFunctionAndCoreHasNot) {
  GlThread legacy(GlProfile::legacy), core(GlProfile::core);
  GLenum on_legacy = 1, on_core = 1;
  legacy.run([&] { glEnable(GL_LIGHTING), on_legacy = glGetError(); });
  core.run([&] { glEnable(GL_LIGHTING), on_core = glGetError(); });
  EXPECT_EQ(on_legacy, GLenum(GL_NO_ERROR));
  EXPECT_EQ(on_core, GLenum(GL_INVALID_ENUM));
}

TEST(GlThread, WorkComesFromAnyThreadAndRunsOnOne) {
  GlThread gl(GlProfile::core);
  std::thread::id first{};
  gl.run([&] { first = std::this_thread::get_id(); });
  std::vector<std::thread> callers;
  std::atomic<int> same{0};
  for (int i = 0; i < 8; ++i)
    callers.emplace_back([&] {
      for (int k = 0; k < 50; ++k) gl.run([&] { same += std::this_thread::get_id() == first; });
    });
  for (std::thread& t : callers) t.join();
  EXPECT_EQ(same, 400);
}

TEST(GlThread, WhatWorkThrowsReachesTheCaller) {
  GlThread gl(GlProfile::core);
  EXPECT_THROW(gl.run([] { throw std::out_of_range("x"); }), std::out_of_range);
  EXPECT_FALSE(version_on(gl).empty());
}

TEST(GlThread, WhatLivesInTheContextIsFreedThere) {
  bool freed = false;
  {
    GlThread gl(GlProfile::core);
    gl.at_exit([&] { freed = glGetString(GL_VERSION) != nullptr; });
    version_on(gl);
  }
  EXPECT_TRUE(freed);
}

}  // namespace
}  // namespace cg
