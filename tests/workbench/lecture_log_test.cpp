#include "workbench/lecture_log.h"

#include <gtest/gtest.h>

#include "params/file.h"
#include "params/input_error.h"
#include "workbench/open.h"
#include "workbench/preset.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class LectureLogTest : public testing::Test {
 protected:
  LectureLogTest() : folder(fs::path(testing::TempDir()) / "lecture-log-test") { fs::remove_all(folder); }
  ~LectureLogTest() override { fs::remove_all(folder); }

  void note(double seconds, bool held = false) { log.note(scene, view, seconds, held); }

  fs::path folder;
  Scene scene = open_scene("torus");
  LessonView view;
  LectureLog log;
};

TEST_F(LectureLogTest, ADragIsOneEntry) {
  note(0);
  for (int i = 1; i <= 50; ++i) {
    scene.material.n = 10 + i;
    note(0.02 * i, true);
  }
  note(1.1);
  ASSERT_EQ(log.entries().size(), 2u);
  EXPECT_EQ(log.entries()[1].scene.material.n, 60);
  note(2);
  EXPECT_EQ(log.entries().size(), 2u) << "nothing changed";
}

TEST_F(LectureLogTest, WhatFollowsInTheSameParameterIsOneStep) {
  note(0);
  for (int i = 1; i <= 4; ++i) {
    scene.material.n = 10 + i;
    note(10 + i);
  }
  scene.material.k_d = glm::dvec3(0.25);
  note(15);
  scene.material.n = 99;
  note(60);
  const std::vector<LectureEntry> steps = coalesced(log.entries());
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[1].scene.material.n, 14);
  EXPECT_EQ(steps[2].scene.material.k_d, glm::dvec3(0.25));
  EXPECT_EQ(steps[3].scene.material.n, 99);
}

TEST_F(LectureLogTest, ChangedAndChangedBackIsNoStep) {
  note(0);
  const double before = scene.material.n;
  scene.material.n = 77;
  note(10);
  scene.material.n = before;
  note(11);
  EXPECT_EQ(coalesced(log.entries()).size(), 1u);
  EXPECT_THROW(save_lecture(log.entries(), folder, {"Nothing", "なし"}), InputError);
}

TEST_F(LectureLogTest, NoMoreStepsThanALessonMayHave) {
  note(0);
  for (int i = 1; i <= 150; ++i) {
    (i % 2 ? scene.material.n : scene.camera.fov) = 20 + 0.1 * i;
    note(100 * i + (i == 70 ? -99 : 0));
  }
  const std::vector<LectureEntry> steps = coalesced(log.entries());
  EXPECT_EQ(steps.size(), 100u);
  EXPECT_EQ(steps.back().scene, scene);
}

TEST_F(LectureLogTest, APatchTurnsOneTreeIntoTheOther) {
  const Tree a = parse_json(R"({"a": 1, "b": {"c": [1, 2], "d": {}}, "e": {"f": 1}})", "a");
  const Tree b = parse_json(R"({"a": 2, "b": {"c": [1, 3], "d": {}}, "g": {"h": {}}})", "b");
  EXPECT_EQ(to_json(patch_between(a, b), 0), R"({"e":null,"a":2,"b":{"c":[1,3]},"g":{"h":{}}})");
  const Tree back = merge_patch(b, patch_between(b, a));
  for (const char* key : {"a", "b", "e"}) EXPECT_EQ(*back.find(key), *a.find(key)) << key;
  EXPECT_EQ(back.find("g"), nullptr);
}

// Everything that a lecture can do to a scene, saved, read as a lesson, and opened step by step.
TEST_F(LectureLogTest, TheLessonHasTheScenesOfTheLecture) {
  note(0);
  scene.material.n = 10;
  note(5);
  scene.lights.push_back({});
  scene.lights[1].kind = LightKind::spot;
  scene.lights[1].position = {1, 2, 3};
  note(20);
  scene.lights.erase(scene.lights.begin());
  note(40);
  view.view = ViewMode::wipe;
  note(60);
  scene.camera.position = {0.1, 0.2, 5};
  note(80);
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].transform.translate = {1, 0, 0};
  note(100);
  scene = open_scene("teapot");
  note(120);
  scene.lights.clear();
  note(140);
  save_lecture(log.entries(), folder, {"A *lecture*", "講義の記録"});
  const Lesson lesson = read_lesson(folder);
  const std::vector<LectureEntry> entries = coalesced(log.entries());
  ASSERT_EQ(lesson.steps.size(), entries.size());
  EXPECT_EQ(lesson.in(Language::english).title, "A *lecture*");
  for (std::size_t i = 0; i + 1 < entries.size(); ++i) {
    EXPECT_EQ(scene_of_step(lesson, i), entries[i].scene) << "step " << i + 1;
    EXPECT_EQ(lesson.steps[i].view, entries[i].view) << "step " << i + 1;
  }
  // A preset that a merge patch cannot say: the light stays, switched off.
  const Scene last = scene_of_step(lesson, entries.size() - 1);
  ASSERT_EQ(last.lights.size(), 1u);
  EXPECT_FALSE(last.lights[0].enabled);
  EXPECT_EQ(lesson.steps[1].offered, (std::vector<std::string>{"material.n"}));
}

TEST_F(LectureLogTest, AStepShowsTheLinesThatChanged) {
  note(0);
  scene.material.n = 10;
  note(65);
  const std::vector<std::string> lines = changed_lines(log.entries()[0].scene, scene, Language::english);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].starts_with("- ") && lines[0].find("32") != std::string::npos) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("+ ") && lines[1].find("10") != std::string::npos) << lines[1];
  save_lecture(log.entries(), folder, {"Lecture", "講義"});
  const Lesson lesson = read_lesson(folder);
  for (const Language l : {Language::english, Language::japanese}) {
    const TextSection& text = lesson.steps[1].in(l);
    EXPECT_TRUE(text.title.starts_with("1:05 ")) << text.title;
    ASSERT_FALSE(text.blocks.empty());
    EXPECT_EQ(text.blocks.back().kind, TextBlock::code);
    EXPECT_EQ(text.blocks.back().lines, lines);
  }
}

TEST_F(LectureLogTest, AStepSaysWhatChangedInWords) {
  note(0);
  view.view = ViewMode::wipe;
  note(10);
  scene.lights.push_back({});
  note(20);
  scene.material.k_d = {1, 0.5, 0};
  note(30);
  scene.camera.position.x = 1;
  note(40);
  save_lecture(log.entries(), folder, {"Lecture", "講義"});
  const Lesson lesson = read_lesson(folder);
  const auto line = [&](std::size_t step, Language l) { return lesson.steps[step].in(l).blocks[0].runs[0].text; };
  EXPECT_EQ(line(1, Language::english), "View: Two → Wipe");
  EXPECT_EQ(line(1, Language::japanese), "見方：並べる → ワイプ");
  EXPECT_EQ(line(2, Language::english), "LIGHT1 added");
  EXPECT_EQ(line(3, Language::english), "Diffuse reflectance: 0.8, 0.8, 0.8 → 1, 0.5, 0");
  EXPECT_EQ(line(4, Language::english), "The camera moves");
  EXPECT_EQ(lesson.steps[3].in(Language::japanese).title, "0:30 拡散反射率");
}

TEST_F(LectureLogTest, AFolderWithSomethingElseIsLeftAlone) {
  note(0);
  scene.material.n = 10;
  note(5);
  fs::create_directories(folder);
  save_file(folder / "thesis.tex", "years of work");
  EXPECT_THROW(save_lecture(log.entries(), folder, {"Lecture", "講義"}), InputError);
  EXPECT_EQ(read_file(folder / "thesis.tex"), "years of work");
  EXPECT_FALSE(fs::exists(folder / "lesson.json"));
}

}  // namespace
}  // namespace cg
