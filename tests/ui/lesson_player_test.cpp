// The lesson in the window: entering steps, going on across lessons' ends, files that are edited, tasks; a slider that
// plays; the keys of the presentation.
#include "ui/lesson_player.h"

#include <thread>

#include "params/file.h"
#include "params/slots.h"
#include "raster/software.h"
#include "tests/temporary_folder.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "ui/parameter.h"
#include "workbench/open.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class LessonPlayerTest : public testing::Test {
 protected:
  LessonPlayerTest() {
    write("01-first", 0.25);
    write("02-second", 0.5);
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
    app.lessons = std::make_shared<LessonPlayer>(std::vector<Technique>{software_technique()},
                                                 std::vector<fs::path>{folder.path()}, [] {});
    wait([&] { return player().list().size() == 2; });
  }
  ~LessonPlayerTest() override { app.lessons.reset(); }

  void write(const std::string& id, double k_d) {
    fs::create_directories(folder / id);
    save_file(folder / id / "lesson.json",
              R"({"schema": 1, "steps": [
 {"id": "one", "scene": {"model": "torus", "material": {"k_d": )" +
                  std::to_string(k_d) + R"(}}, "view": {"view": "wipe", "term": "diffuse"}},
 {"id": "two", "scene": {"material": {"n": 20}}, "offer": ["material.n"],
  "tasks": [{"id": "sharp", "measure": "brightest", "term": "ambient", "goal": "0.1", "tolerance": "0.005",
             "solution": {"material": {"k_a": 0.5}}}]}]})");
    save_text(id, "Text.");
    save_file(folder / id / "lesson.ja.md", "# 題\n授業。\n## 一 {#one}\n文。\n## 二 {#two}\n- [ ] 鋭く。{#sharp}\n");
  }
  void save_text(const std::string& id, const std::string& text) {
    save_file(folder / id / "lesson.en.md",
              "# Title\nA lesson.\n## One {#one}\n" + text + "\n## Two {#two}\n- [ ] Sharper. {#sharp}\n");
  }

  LessonPlayer& player() { return *app.lessons; }
  template <class Holds>
  bool wait(Holds holds) {
    for (int i = 0; i < 1000; ++i) {
      app.now += 0.1;
      player().update(app);
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "waited 10 s";
    return false;
  }
  bool wait_place(const std::string& place) {
    return wait([&] { return player().place() == place && player().current() && !player().busy(); });
  }
  Scene scene_of(const std::string& id, std::size_t step) { return scene_of_step(read_lesson(folder / id), step); }

  TemporaryFolder folder;
  App app;
};

TEST_F(LessonPlayerTest, AStepSetsItsSceneAndViewInOneStepOfUndo) {
  const Scene before = app.scene;
  player().go(1);
  ASSERT_TRUE(wait_place("01-first:1"));
  ASSERT_TRUE(wait([&] { return app.scene == scene_of("01-first", 0); }));
  EXPECT_EQ(app.settings.view, ViewMode::wipe);
  EXPECT_EQ(app.isolated.term, Quantity::diffuse);
  EXPECT_EQ(app.history.now(), app.scene);
  app.scene = app.history.undo();
  EXPECT_EQ(app.scene, before);
  EXPECT_FALSE(app.history.can_undo());
}

TEST_F(LessonPlayerTest, ItGoesOnIntoTheNextLessonAndBack) {
  EXPECT_FALSE(player().has_next());
  for (const char* place : {"01-first:1", "01-first:2", "02-second:1", "02-second:2"}) {
    player().go(1);
    ASSERT_TRUE(wait_place(place));
  }
  EXPECT_FALSE(player().has_next());
  player().go(1);  // nothing
  EXPECT_EQ(player().place(), "02-second:2");
  for (const char* place : {"02-second:1", "01-first:2", "01-first:1"}) {
    player().go(-1);
    ASSERT_TRUE(wait_place(place));
  }
  EXPECT_FALSE(player().has_previous());
  ASSERT_TRUE(wait([&] { return app.scene == scene_of("01-first", 0); }));
}

TEST_F(LessonPlayerTest, TheLastSessionsLessonComesBackWithoutItsScene) {
  const Scene before = app.scene;
  player().resume("02-second:2", false);
  ASSERT_TRUE(wait_place("02-second:2"));
  ASSERT_TRUE(wait([&] { return player().task("sharp").result.has_value(); }));
  EXPECT_EQ(app.scene, before);
  player().resume("03-none:1", false);
  EXPECT_EQ(player().place(), "02-second:2");
}

TEST_F(LessonPlayerTest, AnErrorKeepsTheLastGoodVersionAndSaysWhere) {
  player().go(1);
  ASSERT_TRUE(wait_place("01-first:1"));
  const auto good = player().lesson();
  save_text("01-first", "An $open formula.");
  ASSERT_TRUE(wait([&] { return player().error().has_value(); }));
  EXPECT_EQ(player().lesson(), good);
  EXPECT_NE(player().error()->message(Language::english).find("lesson.en.md:4"), std::string::npos)
      << player().error()->message(Language::english);
  save_text("01-first", "Better text, longer.");
  ASSERT_TRUE(wait([&] { return !player().error(); }));
  EXPECT_NE(player().lesson(), good);
  EXPECT_EQ(player().current()->in(Language::english).blocks[0].runs[0].text, "Better text, longer.");
}

TEST_F(LessonPlayerTest, ASceneThatIsEditedIsShown) {
  player().go(1);
  ASSERT_TRUE(wait_place("01-first:1"));
  write("01-first", 0.125);
  ASSERT_TRUE(wait([&] { return app.scene.material.k_d.x == 0.125; }));
}

TEST_F(LessonPlayerTest, ATaskIsCheckedWhileTheStudentTurns) {
  player().open(folder / "01-first", 1);
  ASSERT_TRUE(wait_place("01-first:2"));
  ASSERT_TRUE(wait([&] { return app.scene.material.n == 20 && player().task("sharp").result; }));
  EXPECT_FALSE(player().task("sharp").done);
  app.scene.material.k_a = glm::dvec3(0.5);
  ASSERT_TRUE(wait([&] { return player().task("sharp").done; }));
  app.scene.material.k_a = glm::dvec3(1);  // what was reached stays reached
  ASSERT_TRUE(wait([&] { return player().task("sharp").result && !player().task("sharp").result->done; }));
  EXPECT_TRUE(player().task("sharp").done);
}

TEST_F(ImGuiTest, ASliderThatPlaysGoesFromEndToEndAsOneStepOfUndo) {
  app.scene = open_scene("cube");
  app.history.restart(app.scene);
  app.settings.sweep_seconds = 1;
  const auto step = [&] {
    frame([&] {
      watch_sweep(app);
      const Slots all = slots(app.scene);
      parameter(app, find_slot(all, "material.n"));
    });
    keep_history(app);
  };
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {400, 25};
  step(), step();
  io.MouseDown[0] = true;
  step();
  io.MousePos = {900, 25};
  step();
  io.MouseDown[0] = false;
  step(), step();
  const Scene before = app.scene;
  ASSERT_TRUE(app.history.can_undo());
  toggle_sweep(app);
  double lowest = 1e9, highest = 0;
  for (int i = 0; i < 200; ++i) {  // 3.3 s: there and back, and on
    step();
    lowest = std::min(lowest, app.scene.material.n), highest = std::max(highest, app.scene.material.n);
  }
  EXPECT_EQ(lowest, 1);
  EXPECT_EQ(highest, 1000);
  io.MousePos = {5, 500};
  step();
  io.MouseDown[0] = true;
  step();
  EXPECT_EQ(app.sweep.item, 0u);
  io.MouseDown[0] = false;
  step(), step();
  const Scene after = app.scene;
  step();
  EXPECT_EQ(app.scene, after);
  EXPECT_EQ(app.history.undo(), before);
}

TEST_F(ImGuiTest, TheKeysOfThePresentation) {
  const auto press = [&](int key) {
    const KeyPress one{key, false, false, false, false};
    handle_keys(app, std::span(&one, 1));
  };
  window_frame();
  press(GLFW_KEY_B);
  EXPECT_FALSE(app.presenter.black) << "nothing while not presenting";
  press(GLFW_KEY_F11);
  EXPECT_TRUE(app.presenter.on);
  window_frame();
  press(GLFW_KEY_PERIOD);
  EXPECT_TRUE(app.presenter.black);
  window_frame();
  press(GLFW_KEY_L);  // nothing else happens in the dark
  EXPECT_EQ(app.language(), Language::english);
  press(GLFW_KEY_PAGE_DOWN);
  EXPECT_FALSE(app.presenter.black);
  press(GLFW_KEY_B);
  press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(app.presenter.black);
  EXPECT_TRUE(app.presenter.on);
  press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(app.presenter.on);
}

}  // namespace
}  // namespace cg
