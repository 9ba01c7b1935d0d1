// The real window, driven as a lecturer would: each lesson step by step, a question about a pixel, numbers dragged in
// the program, a mistake put in, a slider that plays, the presentation, the challenge, a recording. What is asserted is
// the window's own state; screenshots are kept beside it to be looked at.
#include <gtest/gtest.h>

#include <fstream>

#include "params/file.h"
#include "params/input_error.h"
#include "window/window_driver.h"
#include "workbench/lesson.h"
#include "workbench/preset.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class Window : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_drive_windows()) GTEST_SKIP() << "Xvfb or xdotool is missing";
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    home = fs::path(testing::TempDir()) / "shadebench-window" / test->name();
    fs::remove_all(home);
  }
  void open(int width, int height, std::vector<std::string> options = {}) {
    window = std::make_unique<WindowDriver>(width, height, home, std::move(options));
    window->move(0.5 * width, 0.6 * height);  // keys go to the window under the mouse
    window->wait(
        "both pictures", [](const Tree& s) { return at(s, "calm") == Tree(true); }, 30);
  }
  bool wait_place(const std::string& place) {
    return window->wait("the step " + place, [&](const Tree& s) {
      return at(s, "lesson.place") == Tree(place) && at(s, "lesson.ready") == Tree(true);
    });
  }
  bool wait_is(const std::string& path, const Tree& value) {
    return window->wait(path + " = " + to_json(value, 0), [&](const Tree& s) { return at(s, path) == value; });
  }
  // What is seen, when nothing is being drawn any more.
  void screenshot(const std::string& name) {
    window->wait("a calm window", [](const Tree& s) { return at(s, "calm") == Tree(true); });
    window->screenshot(name);
  }
  bool wait_moved_light() {
    return window->wait("a moved light, let go", [](const Tree& s) {
      return at(s, "scene.lights.0.position").list() != nullptr && at(s, "calm") == Tree(true);
    });
  }
  bool wait_scene(const std::string& what, const Tree& scene) {
    return window->wait(what, [&](const Tree& s) { return at(s, "scene") == scene; });
  }

  fs::path home;
  std::unique_ptr<WindowDriver> window;
};

std::vector<Lesson> all_lessons() {
  std::vector<Lesson> out;
  for (const fs::path& folder : lesson_folders(fs::path(SHADEBENCH_SOURCE_DIR) / "lessons"))
    out.push_back(read_lesson(folder));
  return out;
}

std::string name_of(const Lesson& lesson, std::size_t step) { return lesson.id + ":" + std::to_string(step + 1); }

TEST_F(Window, PageDownGoesThroughEveryStepOfEveryLesson) {
  open(1280, 720);
  const std::vector<Lesson> lessons = all_lessons();
  ASSERT_FALSE(lessons.empty());
  for (const Lesson& lesson : lessons)
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      window->key("Page_Down");
      ASSERT_TRUE(wait_place(name_of(lesson, i)));
      ASSERT_TRUE(wait_scene("the scene of " + name_of(lesson, i), preset_of(scene_of_step(lesson, i))));
      EXPECT_EQ(at(window->state(), "settings.left"), Tree(lesson.steps[i].view.left));
      if (i == 0) screenshot(lesson.id + "-en");
    }
  // There is nothing behind the last; back across a lesson's beginning into the one before.
  window->key("Page_Down");
  const Lesson& last = lessons.back();
  for (std::size_t i = last.steps.size() - 1; i-- > 0;) window->key("Page_Up");
  ASSERT_TRUE(wait_place(name_of(last, 0)));
  if (lessons.size() > 1) {
    const Lesson& before = lessons[lessons.size() - 2];
    window->key("Page_Up");
    ASSERT_TRUE(wait_place(name_of(before, before.steps.size() - 1)));
  }
  window->key("l");
  ASSERT_TRUE(wait_is("settings.language", "ja"));
  screenshot("lesson-ja");
}

TEST_F(Window, WhatALecturerDoesToAScene) {
  open(1280, 720, {"torus"});
  const Tree beginning = at(window->state(), "scene");

  // A pixel is asked about.
  const auto [x0, y0, x1, y1] = window->place("picture:right");
  window->click(0.5 * (x0 + x1) + 0.2 * (x1 - x0), 0.5 * (y0 + y1));
  window->wait("the probe", [](const Tree& s) { return at(s, "probe.pixel").list() != nullptr; });
  screenshot("probe-en");

  // A number is dragged in the program.
  const auto number = window->place("code:lights.0.position");
  window->drag(0.5 * (number[0] + number[2]), 0.5 * (number[1] + number[3]), 60, 0);
  wait_moved_light();

  // A mistake is put in, the program is exported, and everything is undone.
  window->key("k");
  window->click("toggle:Light set before the view");
  wait_is("scene.mistakes.light_before_view", true);
  screenshot("mistake-en");
  window->key("ctrl+e");
  window->wait("the dialogue", [](const Tree& s) { return at(s, "dialogue") != Tree(0); });
  screenshot("export-en");
  window->key("Return");
  const fs::path exported = home / "scene.c";
  window->wait("the exported program", [&](const Tree&) { return fs::exists(exported); });
  EXPECT_NE(read_file(exported).find("glLightfv( GL_LIGHT0, GL_POSITION"), std::string::npos);
  window->key("ctrl+z");
  window->wait("no mistake", [](const Tree& s) { return at(s, "scene.mistakes").is_null(); });
  window->key("ctrl+z");
  wait_scene("the scene of the beginning", beginning);
  EXPECT_EQ(at(window->state(), "can_undo"), Tree(false));
  window->key("ctrl+y");
  window->wait("the moved light", [](const Tree& s) { return at(s, "scene.lights.0.position").list() != nullptr; });
}

TEST_F(Window, TheLecturesLogBecomesALesson) {
  open(1280, 720, {"torus"});
  const auto number = window->place("code:lights.0.position");
  window->drag(0.5 * (number[0] + number[2]), 0.5 * (number[1] + number[3]), 60, 0);
  wait_moved_light();
  const Tree moved = at(window->state(), "scene");
  window->key("2");  // the wipe
  wait_is("settings.view", "wipe");
  window->key("s");
  window->click("button:Save as a lesson…");
  screenshot("lessons-en");
  window->click("button:Save");
  const auto own = [&] { return lesson_folders(home / "data/shadebench/lessons"); };
  window->wait("the lesson's folder", [&](const Tree&) { return own().size() == 1; });
  ASSERT_EQ(own().size(), 1u);
  const Lesson lesson = read_lesson(own()[0]);
  ASSERT_EQ(lesson.steps.size(), 3u);
  EXPECT_EQ(preset_of(scene_of_step(lesson, 1)), moved);
  EXPECT_EQ(lesson.steps[1].offered, (std::vector<std::string>{"lights.0.position"}));
  EXPECT_EQ(lesson.steps[2].view.view, ViewMode::wipe);
  window->wait("it in the list", [&](const Tree& s) {
    const Tree::List* list = at(s, "lesson.list").list();
    return list && list->back() == Tree(lesson.id);
  });
}

TEST_F(Window, AChallengeIsWonWithTheTargetsNumbers) {
  open(1280, 720, {"torus"});
  const Tree beginning = at(window->state(), "scene");
  window->key("h");
  window->click("button:Make one up");
  wait_is("challenge.playing", true);
  window->wait("a score", [](const Tree& s) { return at(s, "challenge.score").number() != nullptr; });
  screenshot("challenge-en");
  EXPECT_LT(*at(window->state(), "challenge.score").number(), 99);
  window->click("button:Hint");
  window->click("button:Give up");
  window->wait("what differs", [](const Tree& s) { return at(s, "challenge.given_up") == Tree(true); });
  screenshot("challenge-given-up-en");
  window->key("ctrl+z");
  wait_scene("the scene of the beginning", beginning);
}

TEST_F(Window, ATradeIsMeasuredAndOneOfItsSettingsTaken) {
  open(1280, 720, {"torus", "--set", "knob=near-plane"});
  const Tree beginning = at(window->state(), "scene");
  window->key("r");
  screenshot("trade-before-en");
  window->click("button:Measure");
  wait_is("trade.measuring", true);
  window->wait(
      "the trade", [](const Tree& s) { return at(s, "trade.points").number() != nullptr; }, 60);
  window->click("point:0");
  window->wait("a setting in the scene",
               [&](const Tree& s) { return at(s, "scene") != beginning && at(s, "trade.chosen").number() != nullptr; });
  EXPECT_EQ(at(window->state(), "scene.camera.position"), at(beginning, "camera.position"));
  screenshot("trade-en");
  window->key("ctrl+z");
  wait_scene("the scene of the beginning", beginning);
  EXPECT_EQ(at(window->state(), "can_undo"), Tree(false));
}

TEST_F(Window, AnExtremeIsAppliedAndChecked) {
  open(1280, 720, {"torus"});
  const Tree beginning = at(window->state(), "scene");
  window->key("e");
  screenshot("extremes-before-en");
  window->click("extreme:light-grazing-0");
  window->wait("the extreme scene", [&](const Tree& s) { return at(s, "scene") != beginning; });
  window->wait(
      "what came out", [](const Tree& s) { return at(s, "extremes.verdict") == Tree("right"); }, 60);
  screenshot("extremes-en");
  window->key("ctrl+z");
  wait_scene("the scene of the beginning", beginning);
}

TEST_F(Window, TheRadiositySolverIsSteppedAndPlayed) {
  open(1280, 720, {"models/cornell-box.json", "--set", "radiosity.patch_size=0.24", "--set", "solver_speed=200"});
  const Tree beginning = at(window->state(), "scene");
  EXPECT_EQ(at(beginning, "radiosity.patch_size"), Tree(0.24));
  window->key("g");
  wait_is("solver.step", 0);
  window->click("button:solver step");
  window->click("button:solver step");
  wait_is("solver.step", 2);
  window->click("button:solver back");
  wait_is("solver.step", 1);
  window->click("button:solver sweep");
  const double patches = *at(window->state(), "solver.patches").number();
  wait_is("solver.step", patches);
  screenshot("solver-sweep-en");
  window->click("button:solver play");
  wait_is("solver.playing", true);
  window->wait("some steps", [&](const Tree& s) { return *at(s, "solver.step").number() > patches + 10; });
  window->click("button:solver play");
  wait_is("solver.playing", false);
  const Tree there = at(window->state(), "solver.step");
  window->click("button:solver end");
  window->wait("its end", [](const Tree& s) { return at(s, "solver.ended") == Tree(true); });
  EXPECT_NE(at(window->state(), "solver.step"), there);
  window->click("button:Matrix");
  const auto matrix = window->place("matrix");
  window->move(0.3 * matrix[0] + 0.7 * matrix[2], 0.6 * matrix[1] + 0.4 * matrix[3]);
  window->key("l");
  wait_is("settings.language", "ja");
  screenshot("solver-matrix-ja");
  window->click("button:solver reset");
  wait_is("solver.step", 0);
  // What was seen of it is no part of the scene.
  wait_scene("the scene of the beginning", beginning);
  EXPECT_EQ(at(window->state(), "can_undo"), Tree(false));
}

TEST_F(Window, AHemicubeIsLookedAtPatchByPatch) {
  open(1280, 1000, {"models/closed-cube.json", "--set", "hemicube=items"});  // the weights lie below the cross
  window->key("u");
  wait_is("hemicube.busy", false);
  window->wait("a patch", [](const Tree& s) { return at(s, "hemicube.exact").number() != nullptr; });
  screenshot("hemicube-en");
  // Another patch, by a click in the left picture.
  const Tree first = at(window->state(), "hemicube.shown");
  const auto [x0, y0, x1, y1] = window->place("picture:left");
  window->click(x0 + 0.25 * (x1 - x0), y0 + 0.6 * (y1 - y0));
  window->wait("another patch", [&](const Tree& s) {
    return at(s, "hemicube.shown").number() && at(s, "hemicube.shown") != first && at(s, "calm") == Tree(true);
  });
  EXPECT_TRUE(at(window->state(), "probe.pixel").is_null());
  // Pixels of the cross: the patch that they see, and its factor.
  const auto cross = window->place("hemicube:cross");
  const auto point = [&](double u, double v) {
    window->move(cross[0] + u * (cross[2] - cross[0]), cross[1] + v * (cross[3] - cross[1]));
  };
  point(0.5, 0.5);
  wait_is("hemicube.busy", false);
  screenshot("hemicube-pixel-en");
  const Tree above = at(window->state(), "hemicube.other");
  point(0.95, 0.5);
  window->wait("the patch aside",
               [&](const Tree& s) { return at(s, "hemicube.other").number() && at(s, "hemicube.other") != above; });
  // A wrong weight: the sum stays, the factor goes.
  const double right = *at(window->state(), "hemicube.sum").number();
  EXPECT_NEAR(right, 1, 1e-3);
  window->click("weight:unweighted");
  wait_is("scene.radiosity.weight", "unweighted");
  window->wait("its row", [](const Tree& s) {
    return at(s, "calm") == Tree(true) && at(s, "hemicube.factor").number() != nullptr;
  });
  EXPECT_NEAR(*at(window->state(), "hemicube.sum").number(), 1, 1e-3);
  screenshot("hemicube-unweighted-en");
  window->key("ctrl+z");
  window->wait("the right weight", [](const Tree& s) { return at(s, "scene.radiosity.weight").is_null(); });
  window->key("l");
  window->click("button:ヌッセルト");
  wait_is("settings.hemicube", "nusselt");
  window->wait("the hemisphere", [](const Tree& s) { return at(s, "calm") == Tree(true); });
  screenshot("hemicube-nusselt-ja");
}

TEST_F(Window, ASliderPlaysAndIsOneStepOfUndo) {
  open(1280, 720, {"torus", "--set", "sweep_seconds=0.5"});
  const Tree beginning = at(window->state(), "scene");
  const auto row = window->place("slider:n");
  window->move(0.5 * (row[0] + row[2]), 0.5 * (row[1] + row[3]));
  window->click("button:sweep");
  wait_is("sweeping", true);
  window->wait("an end", [](const Tree& s) { return at(s, "scene.material.n") == Tree(1000); });
  window->wait("the other end", [](const Tree& s) { return at(s, "scene.material.n") == Tree(1); });
  window->key("Escape");
  wait_is("sweeping", false);
  window->key("ctrl+z");
  wait_scene("the scene of the beginning", beginning);
  window->key("space");  // the slider that was touched last
  wait_is("sweeping", true);
  window->click(0.5 * 1280, 0.3 * 720);
  wait_is("sweeping", false);
}

TEST_F(Window, ThePresentationIsDrivenByAClicker) {
  open(1280, 720, {"--set", "language=ja"});
  window->key("Page_Down");
  window->wait("a step", [](const Tree& s) { return at(s, "lesson.ready") == Tree(true); });
  const std::string first = *at(window->state(), "lesson.place").string();
  window->key("F5");
  wait_is("presenting", true);
  wait_is("full_screen", true);
  screenshot("presentation-ja");
  window->key("b");
  wait_is("black", true);
  window->key("Page_Down");
  wait_is("black", false);
  for (int pages = 0; pages < 5 && at(window->state(), "lesson.place") == Tree(first); ++pages) {  // of the text
    window->key("Page_Down");
    window->wait("the page", [](const Tree& s) { return at(s, "calm") == Tree(true); });
  }
  window->wait("the next step", [&](const Tree& s) { return at(s, "lesson.place") != Tree(first); });
  window->key("Escape");
  wait_is("full_screen", false);
  screenshot("after-presentation-ja");
}

TEST_F(Window, ARecordingAppearsWhenItIsWhole) {
  open(1280, 720, {"torus", "--set", "picture=both", "--set", "sweep_seconds=1"});
  window->key("ctrl+r");
  wait_is("recording", true);
  const auto row = window->place("slider:n");
  window->drag(row[0] + 0.3 * (row[2] - row[0]), 0.5 * (row[1] + row[3]), 60, 0);
  EXPECT_FALSE(fs::exists(home / "recording-1.gif"));
  window->key("ctrl+r");
  window->wait("the recording's file", [&](const Tree&) { return fs::exists(home / "recording-1.gif"); });
  const std::string bytes = read_file(home / "recording-1.gif");
  EXPECT_EQ(bytes.substr(0, 6), "GIF89a");
  EXPECT_EQ(bytes.back(), ';');
}

TEST_F(Window, ALessonThatIsEditedIsReadAgainAndAnErrorKeepsTheLastGoodOne) {
  fs::create_directories(home / "data/shadebench/lessons");
  const fs::path own = home / "data/shadebench/lessons/99-own";
  fs::create_directories(own);
  const auto write = [&](const char* name, const std::string& text) { save_file(own / name, text); };
  write("lesson.json", R"({"schema": 1, "steps": [{"id": "one", "scene": {"model": "torus"}, "offer": ["material.n"],
    "tasks": [{"id": "red", "measure": "brightest", "term": "ambient", "goal": "0.1", "tolerance": "0.005",
               "solution": {"material": {"k_a": 0.5}}}]}]})");
  write("lesson.en.md", "# Own\nA lesson.\n## One {#one}\nText.\n- [ ] Brighter. {#red}\n");
  write("lesson.ja.md", "# 自作\n授業。\n## 一 {#one}\n文。\n- [ ] 明るく。{#red}\n");
  open(1280, 720, {"--set", "lesson=99-own:1", "--set", "side=lesson"});
  ASSERT_TRUE(wait_place("99-own:1"));
  write("lesson.en.md", "# Own\nA lesson.\n## One {#one}\nText with $an open formula.\n- [ ] Brighter. {#red}\n");
  window->wait("the error with its line", [](const Tree& s) {
    const std::string* error = at(s, "lesson.error").string();
    return error && error->find("lesson.en.md:4") != std::string::npos;
  });
  EXPECT_EQ(at(window->state(), "lesson.place"), Tree("99-own:1"));
  screenshot("lesson-error");
  write("lesson.en.md", "# Own\nA lesson.\n## One {#one}\nText again.\n- [ ] Brighter. {#red}\n");
  wait_is("lesson.error", "");
}

}  // namespace
}  // namespace cg
