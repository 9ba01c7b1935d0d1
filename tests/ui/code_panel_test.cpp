// The listing as a control: numbers dragged, typed and set back in it.
#include <algorithm>

#include "tests/ui/imgui_fixture.h"
#include "workbench/open.h"

namespace cg {
namespace {

class CodePanel : public ImGuiTest {
 protected:
  CodePanel() {
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
    ImGui::GetIO().ConfigInputTextCursorBlink = false;
  }

  // The line with the array `name`, and its number of that index, at (100, 100); nothing where it is not there.
  void number_frame(const std::string& name, std::size_t index) {
    frame([&] {
      CodeView& view = app.code;
      view.make(app.scene, Language::english, false);
      move_held_number(app);
      const auto& lines = view.listing.lines;
      const auto line = std::find_if(lines.begin(), lines.end(),
                                     [&](const ListingLine& l) { return l.text.find(name) != l.text.npos; });
      if (line == lines.end()) return;
      code_number(app, *line, index, view.keys[std::size_t(line - lines.begin())][index], {100, 100}, 20);
    });
    keep_history(app);
  }

  void press(const std::string& name, std::size_t index) {
    ImGui::GetIO().MousePos = {106, 110};
    number_frame(name, index), number_frame(name, index);
    ImGui::GetIO().MouseDown[0] = true;
    number_frame(name, index);
  }
  void release(const std::string& name, std::size_t index) {
    ImGui::GetIO().MouseDown[0] = false;
    number_frame(name, index), number_frame(name, index);
  }
  void key(const std::string& name, std::size_t index, int code) {
    ImGui::GetIO().KeysDown[code] = true;
    number_frame(name, index);
    ImGui::GetIO().KeysDown[code] = false;
    number_frame(name, index);
  }
};

constexpr const char* position = "light0_position[]";

TEST_F(CodePanel, ADragIsOneStepOfUndo) {
  const double before = app.scene.lights[0].position.y;
  press(position, 1);
  for (float x : {120.0f, 140.0f, 160.0f}) ImGui::GetIO().MousePos.x = x, number_frame(position, 1);
  release(position, 1);
  EXPECT_GT(app.scene.lights[0].position.y, before + 1);
  EXPECT_EQ(app.scene.lights[0].position.x, Light{}.position.x);
  app.scene = app.history.undo();
  EXPECT_EQ(app.scene.lights[0].position.y, before);
  EXPECT_FALSE(app.history.can_undo());
}

TEST_F(CodePanel, ADragGoesOnWhereItsLineIsNoLongerThere) {
  constexpr const char* line = "GL_LINEAR_ATTENUATION";
  app.scene.lights[0].k_1 = 0.05;
  app.history.restart(app.scene);
  press(line, 0);
  ImGui::GetIO().MousePos.x = 6;
  number_frame(line, 0), number_frame(line, 0);
  ASSERT_EQ(app.scene.lights[0].k_1, 0);  // where the listing says nothing about it
  ImGui::GetIO().MousePos.x = 66;
  number_frame(line, 0), number_frame(line, 0);
  release(line, 0);
  EXPECT_GT(app.scene.lights[0].k_1, 0.05);
  app.scene = app.history.undo();
  EXPECT_EQ(app.scene.lights[0].k_1, 0.05);
  EXPECT_FALSE(app.history.can_undo());
}

TEST_F(CodePanel, WhatIsTypedIsCheckedAndTabGoesOnToTheNextNumber) {
  press(position, 0), release(position, 0);
  ASSERT_NE(app.editing.item, 0u);
  number_frame(position, 0);
  ImGui::GetIO().AddInputCharactersUTF8("-2.5f");
  number_frame(position, 0);
  key(position, 0, GLFW_KEY_TAB);
  EXPECT_EQ(app.scene.lights[0].position.x, -2.5);
  ASSERT_NE(app.editing.item, 0u);
  number_frame(position, 1), number_frame(position, 1);
  ImGui::GetIO().AddInputCharactersUTF8("abc");
  number_frame(position, 1);
  key(position, 1, GLFW_KEY_ENTER);
  EXPECT_EQ(app.scene.lights[0].position.y, Light{}.position.y);
  EXPECT_EQ(app.editing.item, 0u);
  ASSERT_EQ(app.toasts.size(), 1u);
  EXPECT_TRUE(app.toasts[0].error);
}

TEST_F(CodePanel, ADoubleClickBringsTheDefaultBack) {
  app.scene.lights[0].position.z = -7;
  app.history.restart(app.scene);
  press(position, 2), release(position, 2);
  ImGui::GetIO().MouseDown[0] = true;
  number_frame(position, 2);
  release(position, 2);
  EXPECT_EQ(app.scene.lights[0].position.z, Light{}.position.z);
  EXPECT_EQ(app.editing.item, 0u);
}

TEST_F(CodePanel, TheListingIsMadeAgainOnlyWhereSomethingDiffers) {
  app.code.make(app.scene, Language::english, false);
  const ListingLine* before = app.code.listing.lines.data();
  app.code.make(Scene(app.scene), Language::english, false);
  EXPECT_EQ(app.code.listing.lines.data(), before);
  app.scene.lights[0].position.x += 1;
  const std::string text = app.code.text();
  app.code.make(app.scene, Language::english, false);
  EXPECT_NE(app.code.text(), text);
}

TEST_F(CodePanel, RunsCoverEachLineOnce) {
  app.code.make(app.scene, Language::english, false);
  ASSERT_EQ(app.code.keys.size(), app.code.listing.lines.size());
  for (const ListingLine& line : app.code.listing.lines) {
    std::string text;
    std::size_t numbers = 0;
    for (const ListingRun& run : code_runs(line)) {
      text += line.text.substr(run.begin, run.end - run.begin);
      numbers += run.ink == CodeInk::number;
    }
    EXPECT_EQ(text, line.text);
    EXPECT_EQ(numbers, line.comment ? 0 : line.numbers.size());
  }
}

}  // namespace
}  // namespace cg
