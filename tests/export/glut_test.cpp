// The exported GLUT program is compiled as strictly as a student may, runs on a display of its own, and draws what the
// technique gl-fixed draws.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

#include "gl/fixed_renderer.h"
#include "gl/gl_plan.h"
#include "gl/gl_thread.h"
#include "gl/techniques.h"
#include "params/file.h"
#include "tests/export/display.h"
#include "tests/workbench/temporary_folder.h"
#include "workbench/export.h"
#include "workbench/open.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

// A scene, and what is set in it before it is exported.
struct GlutCase {
  std::string scene;
  std::vector<std::string> set;
};

Scene scene_of(const GlutCase& c) {
  Scene scene = open_scene(c.scene);
  for (const std::string& set : c.set) set_parameter(scene, set);
  load_meshes(scene);
  return scene;
}

// The picture of a PPM as the program writes it; empty where it is none, or not whole yet.
Picture read_ppm(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  int width = 0, height = 0, most = 0, head = 0;
  if (std::sscanf(bytes.c_str(), "P6 %d %d %d%n", &width, &height, &most, &head) != 3 || most != 255) return {};
  if (bytes.size() != std::size_t(head) + 1 + 3 * std::size_t(width) * std::size_t(height)) return {};
  Picture picture(width, height);
  const auto* byte = reinterpret_cast<const std::uint8_t*>(bytes.data()) + head + 1;
  for (glm::u8vec4& pixel : picture.pixels()) pixel = {byte[0], byte[1], byte[2], 255}, byte += 3;
  return picture;
}

struct Differences {
  int pixels = 0, largest = 0;  // of 255
};
Differences compare(const Picture& a, const Picture& b) {
  Differences d;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.at(x, y)[c] - b.at(x, y)[c]));
      d.pixels += most > 0;
      d.largest = std::max(d.largest, most);
    }
  return d;
}

Frame gl_fixed(const Scene& scene, bool like_a_window) {
  Frame frame;
  Progress progress;
  const View view;
  GlThread gl(GlProfile::legacy);
  FixedRenderer renderer(like_a_window);
  gl.run([&] {
    frame = renderer.render(scene, gl_fixed_plan(scene, view), view, progress);
    renderer.release();
  });
  return frame;
}

class GlutProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"cc", "Xvfb", "xdotool"})
      if (!is_installed(program)) return skip(program);
    if (!fs::exists("/usr/include/GL/glut.h")) return skip("GL/glut.h");
  }
  // Where tests must run, what they need is installed.
  static void skip(const std::string& missing) {
    if (std::getenv("CI")) FAIL() << missing << " is missing";
    GTEST_SKIP() << missing << " is missing";
  }

  int shell(const std::string& line) { return Process(folder.path(), {"sh", "-c", line}).wait(); }
  std::string log() { return fs::exists(folder / "log") ? read_file(folder / "log") : ""; }

  void compile(const std::string& compiler) {
    ASSERT_EQ(shell(compiler + " -std=c89 -Wall -Wextra -pedantic -Werror -o program program.c -lglut -lGLU -lGL -lm"),
              0)
        << log();
  }

  // The window's picture as the program saves it when `s` is pressed.
  Picture run(const XServer& display) {
    const fs::path saved = folder / "program.ppm";
    fs::remove(saved);
    Process program(folder.path(), {"./program"}, {{"DISPLAY", display.name()}});
    const std::string press = "DISPLAY=" + display.name() + " xdotool search --name '^./program$' key s";
    for (int i = 0; i < 200; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (Picture picture = read_ppm(saved); picture.width() > 0) return picture;
      EXPECT_TRUE(program.running()) << log();
      if (!program.running()) return {};
      if (i % 5 == 2) shell(press);
    }
    return {};
  }

  void draws_as_gl_fixed(const GlutCase& c, const XServer& display) {
    const Scene scene = scene_of(c);
    save_export(scene, ExportFormat::glut, folder / "program.c");
    compile("cc");
    const Picture window = run(display);
    ASSERT_EQ(window.width(), 512) << log();
    const Differences same = compare(window, picture(scene.display, gl_fixed(scene, true).colour)),
                      floats = compare(window, picture(scene.display, gl_fixed(scene, false).colour));
    // Into the same kind of framebuffer: the same picture. gl-fixed itself draws into one of floats whose first row is
    // the bottom one: what is interpolated is rounded otherwise there, by up to 0.0002.
    EXPECT_EQ(same.pixels, 0) << same.largest << "/255";
    EXPECT_LE(floats.pixels, 512 * 512 / 5000) << floats.largest << "/255";
    std::printf("%-16s%s: %d pixels differ from gl-fixed in a window's framebuffer, %d (by %d/255) in its own\n",
                c.scene.c_str(), c.set.empty() ? "" : " *", same.pixels, floats.pixels, floats.largest);
  }

  const TemporaryFolder folder;
};

TEST_F(GlutProgramTest, DrawsEveryBundledModelAsGlFixed) {
  const XServer display(folder.path());
  ASSERT_NE(display.name(), "") << log();
  for (const std::string& model : bundled_models()) {
    SCOPED_TRACE(model);
    draws_as_gl_fixed({model, {}}, display);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace cg
