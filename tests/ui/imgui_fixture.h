// ImGui without a back-end: a context, the fonts, a mouse and keys that a test moves. Nothing is drawn.
#pragma once
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/app.h"
#include "ui/fonts.h"
#include "ui/layout.h"
#include "ui/texts.h"

namespace cg {

class ImGuiTest : public testing::Test {
 protected:
  ImGuiTest() {
    note_all_texts(app.look.glyphs, Language::english);
    fonts = build_fonts(1, app.look.glyphs.wanted, *find_fonts());
    ImGui::CreateContext(fonts->atlas.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280, 720};
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    const std::pair<ImGuiKey, int> keys[] = {
        {ImGuiKey_Tab, GLFW_KEY_TAB},       {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},      {ImGuiKey_Enter, GLFW_KEY_ENTER},
        {ImGuiKey_Escape, GLFW_KEY_ESCAPE}, {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE}, {ImGuiKey_A, GLFW_KEY_A}};
    for (const auto& [key, code] : keys) io.KeyMap[key] = code;
    app.look.fonts = fonts->fonts;
    app.look.palette = palette_of(app.settings.theme);
    apply_style(app.look);
  }
  ~ImGuiTest() override { ImGui::DestroyContext(); }

  // One frame with whatever `draw` draws in the one window there is.
  template <class Draw>
  void frame(Draw draw) {
    begin();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
    draw();
    ImGui::End();
    ImGui::Render();
  }
  // One frame of the whole window, without pictures.
  void window_frame() {
    begin();
    draw_window(app, ImGui::GetIO().DisplaySize, [](App&, ImVec2) {});
    keep_history(app);
    ImGui::Render();
  }

  App app;
  std::unique_ptr<BuiltFonts> fonts;

 private:
  void begin() {
    app.now += 1.0 / 60;
    app.next_frame = app.now + 2;
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
  }
};

}  // namespace cg
