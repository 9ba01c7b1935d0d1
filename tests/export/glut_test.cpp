// The exported GLUT program is compiled as strictly as a student may, runs on a display of its own, and draws what the
// technique gl-fixed draws.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <thread>

#include "gl/fixed_renderer.h"
#include "gl/gl_plan.h"
#include "gl/gl_thread.h"
#include "gl/techniques.h"
#include "params/file.h"
#include "params/slots.h"
#include "tests/export/display.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/random_scene.h"
#include "workbench/data_folder.h"
#include "workbench/export.h"
#include "workbench/lesson.h"
#include "workbench/open.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

Scene scene_with(const std::string& name, const std::vector<std::string>& settings) {
  Scene scene = open_scene(name);
  for (const std::string& set : settings) set_parameter(scene, set);
  load_meshes(scene);
  return scene;
}

// What a program can draw of it: the comments of the export say what OpenGL has not.
Scene as_opengl_can(Scene scene) {
  if (scene.shading.mode == ShadingMode::phong) scene.shading.mode = ShadingMode::gouraud;
  scene.shading.reflection = Reflection::half_vector;
  scene.display.transform = DisplayTransform::lecture;
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
  int pixels = 0, over_1 = 0, largest = 0;  // over 1/255; of 255
};
Differences compare(const Picture& a, const Picture& b) {
  Differences d;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.at(x, y)[c] - b.at(x, y)[c]));
      d.pixels += most > 0;
      d.over_1 += most > 1;
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

// Where a step of the window's 24 bits of depth is more than a ten-thousandth of the distance, surfaces fight for their
// pixels in it, and otherwise in floats: near the eye's distance d a step is d^2 / (near 2^24) (Akeley and Su, Minimum
// Triangle Separation for Correct z-Buffer Occlusion, 2006).
bool depths_run_out(const Scene& scene) {
  const Camera& c = scene.camera;
  const double d = glm::distance(c.position, c.target);
  return c.projection == Projection::perspective && d / (c.near_plane * 0x1p24) > 1e-4;
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

  // Both exports in both languages, by both compilers.
  void compiles_silently(const Scene& scene) {
    for (const Language language : {Language::english, Language::japanese}) {
      save_file(folder / "part.c", export_c(scene, language));
      save_file(folder / "whole.c", export_glut(scene, obj_name, language));
      for (const std::string compiler : {"cc", "clang-14"}) {
        if (!is_installed(compiler)) continue;
        ASSERT_EQ(shell(compiler + " -std=c89 -Wall -Wextra -pedantic -Werror -fsyntax-only part.c whole.c"), 0)
            << log();
      }
    }
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

  void draws_as_gl_fixed(const std::string& label, const Scene& scene, const XServer& display) {
    SCOPED_TRACE(label);
    save_export(scene, ExportFormat::glut, folder / "program.c");
    compile("cc");
    const Picture window = run(display);
    ASSERT_EQ(window.width(), 512) << log();
    const Scene drawn = as_opengl_can(scene);
    const Differences same = compare(window, picture(drawn.display, gl_fixed(drawn, true).colour)),
                      floats = compare(window, picture(drawn.display, gl_fixed(drawn, false).colour));
    // Into the same kind of framebuffer: the same picture. gl-fixed itself draws into one of floats whose first row is
    // the bottom one: what is interpolated is rounded otherwise there, by up to 0.0002, and so are halves of 1/255; an
    // edge that goes through a pixel's centre can fall to its other side.
    EXPECT_EQ(same.pixels, 0) << same.largest << "/255";
    if (!depths_run_out(scene)) {
      EXPECT_LE(floats.over_1, 5) << floats.largest << "/255";
    }
    std::printf("%-40s %d pixels differ from gl-fixed in a window's framebuffer, %d (by %d/255) in its own\n",
                label.c_str(), same.pixels, floats.pixels, floats.largest);
  }

  const TemporaryFolder folder;
  std::string obj_name = "scene.obj";
};

TEST_F(GlutProgramTest, ExportsCompileSilently) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    Scene scene = random_scene(random);
    load_meshes(scene);
    compiles_silently(scene);
    if (HasFatalFailure()) return;
  }
  // Names that would end a comment or a string.
  Scene scene = open_scene("cornell-box.obj");
  for (const char* name : {"a*/b", "/*", "\"\\", "\n#error", "?\?/", "名 前", "%s%n"}) {
    SCOPED_TRACE(name);
    obj_name = std::string(name) + ".obj";
    for (Object& object : scene.objects) object.name = name;
    compiles_silently(scene);
  }
}

TEST_F(GlutProgramTest, DrawsEveryBundledModelAsGlFixed) {
  const XServer display(folder.path());
  ASSERT_NE(display.name(), "") << log();
  for (const std::string& model : bundled_models()) draws_as_gl_fixed(model, scene_with(model, {}), display);
}

TEST_F(GlutProgramTest, DrawsEveryLessonsStepAsGlFixed) {
  const XServer display(folder.path());
  ASSERT_NE(display.name(), "") << log();
  const std::vector<fs::path> lessons = lesson_folders(data_folder() / "lessons");
  ASSERT_FALSE(lessons.empty());
  for (const fs::path& lesson_folder : lessons) {
    const Lesson lesson = read_lesson(lesson_folder);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      draws_as_gl_fixed(lesson.id + ":" + std::to_string(i + 1), scene_of_step(lesson, i), display);
  }
}

// What a scene can say: each of OpenGL's ways to shade, place, light and limit, and each mistake.
TEST_F(GlutProgramTest, DrawsEveryStateAsGlFixed) {
  const XServer display(folder.path());
  ASSERT_NE(display.name(), "") << log();
  const std::vector<std::vector<std::string>> states{
      {"shading.mode=flat", "lights.0.w=0", "shading.normal_length=rescale"},
      {"shading.two_sided=true", "shading.local_viewer=true", "camera.projection=orthographic", "material.n=300"},
      {"lights.1.kind=spot", "lights.1.position=1,2,2", "lights.1.exponent=3", "lights.1.k_1=0.5", "lights.1.k_2=0.1"},
      {"lights.1.kind=directional", "lights.1.diffuse=1,0.5,0", "lights.0.enabled=false", "shading.clamp=false",
       "lights.2.position=3,-1,2", "lights.2.diffuse=4,4,4"},
      {"objects.0.transform.rotate=10,20,30", "objects.0.transform.scale=1,-0.5,1.2",
       "objects.0.transform.translate=0.1,0.2,-0.3", "shading.normals=area", "shading.crease_angle=30"},
      {"objects.1.model=cube", "objects.1.own_material=true", "objects.1.material.k_d=1,0,0",
       "objects.1.transform.translate=0.5,0.4,0.3", "objects.2.model=cone", "objects.0.visible=false"},
      {"shading.color_material=ambient-and-diffuse", "material.color=0.2,0.8,0.4", "material.emission=0.1,0,0"},
      {"camera.up=0,0,1", "camera.position=1,3,0.2", "camera.fov=75", "display.background=0.2,0.3,0.4"},
      {"shading.mode=phong", "shading.reflection=reflection-vector", "material.k_r=0.5"}};
  for (const auto& state : states) draws_as_gl_fixed("teapot " + state[0], scene_with("teapot", state), display);
  std::vector<std::string> lights;
  for (int i = 1; i < 10; ++i)
    lights.push_back("lights." + std::to_string(i) + ".position=" + std::to_string(i - 5) + ",3,4"),
        lights.push_back("lights." + std::to_string(i) + ".diffuse=0.1,0.1,0.2");
  draws_as_gl_fixed("teapot, ten lights", scene_with("teapot", lights), display);
}

TEST_F(GlutProgramTest, DrawsEveryMistakeAsGlFixed) {
  const XServer display(folder.path());
  ASSERT_NE(display.name(), "") << log();
  Mistakes none;
  for (const Slot& mistake : slots(none))
    draws_as_gl_fixed(mistake.path,
                      scene_with("teapot", {"objects.0.transform.scale=0.8,0.8,0.8",
                                            "objects.0.transform.rotate=0,40,0", "shading.color_material=diffuse",
                                            "material.color=0.2,0.8,0.4", "mistakes." + mistake.path + "=true"}),
                      display);
}

}  // namespace
}  // namespace cg
