// The presentation: the lesson, the pictures and the equation alone, on the whole screen, in type that the last row
// reads. Driven by a clicker: Page Down, Page Up, B or the full stop for a black screen.
#pragma once
#include <imgui.h>

struct GLFWwindow;

namespace cg {

struct App;
struct KeyPress;

struct Presenter {
  bool on = false, black = false;
  bool full = false;                        // the window covers its monitor
  int x = 0, y = 0, width = 0, height = 0;  // its place before
  double scale = 1;                         // of type and lines, in place of the monitor's
};

// Takes the keys that mean something else, or something at all, while presenting.
bool presenter_takes(App& app, const KeyPress& key);

// Brings the window to the size that app.presenter asks for. Once a frame, outside of ImGui's frame.
void fit_presenter(App& app, GLFWwindow* window);

// All of the window while presenting.
void draw_presentation(App& app, ImVec2 size, void (*middle)(App&, ImVec2));

}  // namespace cg
