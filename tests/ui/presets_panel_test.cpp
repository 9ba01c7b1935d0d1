// Presets A and B, and what goes out of the window and comes into it as a file or through the clipboard.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "params/file.h"
#include "tests/temporary_folder.h"
#include "tests/ui/imgui_fixture.h"
#include "ui/actions.h"
#include "ui/presets.h"
#include "workbench/export.h"
#include "workbench/open.h"

namespace cg {
namespace {

namespace fs = std::filesystem;

class Presets : public ImGuiTest {
 protected:
  Presets() {
    app.settings.side = Side::presets;
    app.scene = open_scene("cube");
    app.history.restart(app.scene);
  }

  void finish_errands() {
    while (app.errands->busy()) std::this_thread::yield();
    app.errands->finish(app);
  }
  void press(int key, bool ctrl = false) {
    const KeyPress press{key, ctrl};
    handle_keys(app, {&press, 1});
    window_frame();
  }

  const TemporaryFolder folder;
};

TEST_F(Presets, OneKeyShowsThemInTurnAndUndoGoesBack) {
  store_preset(app, 0);
  app.scene.material.n = 64;
  window_frame();
  press(GLFW_KEY_X);
  EXPECT_EQ(app.scene.material.n, 32);  // A alone: what was changed since is one step back
  press(GLFW_KEY_Z, true);
  EXPECT_EQ(app.scene.material.n, 64);
  store_preset(app, 1);
  press(GLFW_KEY_X);
  EXPECT_EQ(app.scene, *app.presets.kept[0]);
  press(GLFW_KEY_X);
  EXPECT_EQ(app.scene, *app.presets.kept[1]);
}

TEST_F(Presets, WhatDiffersIsListedAndTakenOver) {
  store_preset(app, 0);
  app.scene.material.n = 64;
  app.scene.lights.push_back(app.scene.lights[0]);
  app.scene.lights[1].position.x = -3;
  store_preset(app, 1);
  const Scene b = app.scene;
  std::vector<std::string> paths;
  for (const ParameterDifference& d : app.presets.differences(app.scene)) paths.push_back(d.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"material.n", "lights.1"}));
  window_frame(), window_frame();
  show_preset(app, 0);
  for (const std::string& path : paths) take_over(app, path, 1);
  EXPECT_EQ(app.scene, b);
  for (const std::string& path : paths) take_over(app, path, 0);
  EXPECT_EQ(app.scene, *app.presets.kept[0]);
}

TEST_F(Presets, AStudentsProgramOpensWithItsComplaints) {
  const fs::path file = folder / "main.c";
  save_file(file,
            "GLfloat diffuse[] = { 0.25, 0.5, 0.75, 1.0 };\n"
            "void init( void )\n{\n"
            "    glEnable( GL_LIGHTING );\n    glEnable( GL_LIGHT0 );\n"
            "    glLightfv( GL_LIGHT0, GL_DIFFUSE, diffuse );\n"
            "    glFoo( 3 );\n}\n");
  open_in_window(app, file.string());
  finish_errands();
  ASSERT_EQ(app.scene.lights.size(), 1u);
  EXPECT_EQ(app.scene.lights[0].diffuse, glm::dvec3(0.25, 0.5, 0.75));
  EXPECT_EQ(app.presets.imported, "main.c");
  const auto& complaints = app.presets.complaints;
  EXPECT_TRUE(std::any_of(complaints.begin(), complaints.end(), [](const Complaint& c) { return c.line == 7; }));
  EXPECT_EQ(app.settings.side, Side::presets);
  window_frame(), window_frame();
}

TEST_F(Presets, TheDialogueExportsToAFileAndToTheClipboard) {
  static std::string clipboard;
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { clipboard = text; };
  ImGui::GetIO().GetClipboardTextFn = [](void*) { return clipboard.c_str(); };
  press(GLFW_KEY_E, true);
  EXPECT_EQ(app.dialogue.kind, Dialogue::export_scene);
  EXPECT_EQ(app.dialogue.text, "scene.c");
  app.dialogue.text = (folder / "mine.c").string();  // before the field has the keyboard
  window_frame(), window_frame();
  ImGui::GetIO().KeysDown[GLFW_KEY_ENTER] = true;
  window_frame();
  ImGui::GetIO().KeysDown[GLFW_KEY_ENTER] = false;
  window_frame();
  EXPECT_EQ(app.dialogue.kind, Dialogue::none);
  finish_errands();
  ASSERT_EQ(app.toasts.size(), 1u);
  EXPECT_FALSE(app.toasts[0].error) << app.toasts[0].text.en;
  EXPECT_NE(app.toasts[0].text.en.find("-lglut"), std::string::npos);
  EXPECT_EQ(read_file(folder / "mine.c"), export_glut(app.scene, "mine.obj"));
  EXPECT_EQ(read_file(folder / "mine.obj"), export_obj(app.scene));
}

}  // namespace
}  // namespace cg
