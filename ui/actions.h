// What a person can ask of the window, by button or by key: one list, which the buttons, the keys, the tooltips and
// the page of help all read.
#pragma once
#include <span>
#include <string_view>

#include "params/words.h"

namespace cg {

struct App;

enum class Do {
  open,
  save,
  picture,
  export_scene,
  undo,
  redo,
  fit,
  swap,
  view_two,
  view_wipe,
  view_flip,
  view_difference,
  view_false_colour,
  larger,
  smaller,
  usual_size,
  language,
  theme,
  lesson,
  world,
  mistakes,
  presets,
  challenge,
  plan,
  mesh,
  trade,
  extremes,
  solver,
  hemicube,
  code,
  flip_presets,
  turntable,
  next_step,
  previous_step,
  play,
  present,
  record,
  help
};

struct Action {
  Do what;
  Words label;
  std::string_view keys;  // as the help shows them
  int key = 0;            // of GLFW; 0: no key
  bool ctrl = false;
  bool shift = false;
};

std::span<const Action> actions();
const Action& action(Do what);

void perform(App& app, Do what);

// A key that went down. Kept as an event: ImGui 1.86 misses a key that is up again before the next frame.
struct KeyPress {
  int key = 0;                                      // of GLFW
  bool ctrl = false, shift = false, other = false;  // other: Alt or Super
  bool repeat = false;
};

// Performs what the keys ask for, unless a text is being typed.
void handle_keys(App& app, std::span<const KeyPress> pressed);

}  // namespace cg
