// Without a driver OpenGL is unavailable with a reason; nothing crashes.
#include <gtest/gtest.h>

#include <cstdlib>

#include "gl_scenes.h"

namespace cg {
namespace {

// In a process of its own: 0 where both techniques say why they are unavailable.
int status_without_driver(const char* variable, const char* value) {
  setenv(variable, value, 1);
  std::vector<Technique> all = gl_techniques();
  const Scene scene = scene_with(sphere_mesh());
  for (Technique& t : all) {
    if (t.unavailable || t.unsupported(scene)) return 1;  // not known yet
    try {
      draw(t, scene, view_of(8, 8));
      return 2;
    } catch (const InputError& e) {
      if (e.found.en.empty() || e.found.ja.empty()) return 3;
    }
    if (!t.unsupported(scene)) return 4;
    find_availability(t);
    if (!t.unavailable) return 5;
  }
  return 0;
}

class NoDriver : public testing::Test {
 protected:
  NoDriver() { testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};

TEST_F(NoDriver, NoVendorLibrary) {
  EXPECT_EXIT(std::exit(status_without_driver("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent")),
              testing::ExitedWithCode(0), "");
}

TEST_F(NoDriver, NoDriverFile) {
  EXPECT_EXIT(std::exit(status_without_driver("LIBGL_DRIVERS_PATH", "/nonexistent")), testing::ExitedWithCode(0), "");
}

TEST_F(NoDriver, TooOld) {
  EXPECT_EXIT(std::exit(status_without_driver("MESA_GL_VERSION_OVERRIDE", "2.0")), testing::ExitedWithCode(0), "");
}

TEST(Availability, IsFoundWhereThereIsADriver) {
  for (Technique& t : gl_techniques()) {
    find_availability(t);
    EXPECT_FALSE(t.unavailable);
  }
}

}  // namespace
}  // namespace cg
