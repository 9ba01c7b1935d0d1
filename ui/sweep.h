// A slider that moves by itself from one of its ends to the other and back: what a parameter does is seen with the
// hands free.
#pragma once
#include <imgui.h>

#include <optional>

namespace cg {

struct App;

struct Sweep {
  ImGuiID item = 0;      // the row that moves; 0: none
  ImGuiID chosen = 0;    // the row that was touched last: the key plays it
  double position = 0;   // 0..1 of the slider
  int direction = 1;     // or -1
  double seen = 0;       // when its row was drawn last: one that is gone stops
  ImGuiID released = 0;  // the row whose press has stopped it: its release does not start it again
  bool start = false;    // the key was pressed: the chosen row starts when it is drawn
};

// The play button of the row whose ID is on ImGui's stack, `size` pixels at `at`, seen while the mouse is on the row or
// the row was touched last. Returns where the slider is now (0..1) while it moves. `position`: where it stands.
std::optional<double> sweep_row(App& app, double position, bool hovered, ImVec2 at, ImVec2 size);

// The row was touched by hand.
void choose_for_sweep(App& app);

// Starts the row that was touched last, or stops what moves.
void toggle_sweep(App& app);
void stop_sweep(App& app);

// Before a frame's widgets: a click anywhere stops it, and so does a row that is no longer drawn.
void watch_sweep(App& app);

}  // namespace cg
