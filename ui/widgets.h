// The few kinds of control there are. Each is drawn at ImGui's cursor, as wide as the room it has unless said
// otherwise, and stays whole for any number it is given: ImGui itself aborts on some.
#pragma once
#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "params/field.h"

namespace cg {

struct App;

// A small dim line above a group.
void heading(App& app, std::string_view text);

// A title that folds what is under it away; true while it is open.
bool section(App& app, const char* id, const Words& title, bool open_at_first);

// What a button shows and tells. A shortcut is named in the tooltip.
struct Press {
  std::string_view label;
  Words tip = {};
  std::string_view shortcut = {};
  bool chosen = false;
  bool enabled = true;
  bool quiet = false;  // no background until the mouse is on it
};
bool button(App& app, const char* id, const Press& press);
float button_width(const App& app, std::string_view label);

// A smaller button that shows something else in the same place.
bool tab(App& app, const char* id, std::string_view label, bool chosen);
float tab_width(const App& app, std::string_view label);

// One of a few: buttons beside each other where they fit, else a drop-down list. True when `chosen` changed.
bool choose(App& app, const char* id, std::span<const Name> names, int& chosen);
// A drop-down list that shows `shown` while it is closed; as ImGui::BeginCombo, to be ended with EndCombo.
bool begin_list(App& app, const char* id, const char* shown, float width);
bool toggle(App& app, const char* id, std::string_view label, bool& on);

// A thin line with a round knob at `position` (0..1), `width` wide and `height` high to the mouse. True while a
// drag moves the knob; `position` is then where it was dragged to.
bool slider(App& app, const char* id, double& position, ImU32 colour, bool lit, ImVec2 size);

// How far something is, 0..1, beside a button: as high as one.
void progress_bar(App& app, float fraction, float width);

// The round arrow that sets a value back; an empty place of the same size where `visible` is false.
bool reset_arrow(App& app, const char* id, bool visible, ImVec2 size);

// For the last item: true when the mouse has rested on it long enough for a tooltip; sees to it that there is a
// frame at that time.
bool wants_tooltip(App& app);
// A tooltip of a title, a sentence, and a line in the small fixed font (each may be empty).
void tooltip(App& app, std::string_view title, std::string_view help, std::string_view small_print);

// True for the last item where the mouse wheel turns on it and the panel is not being scrolled; `steps` is how far.
bool wheel(App& app, double& steps);

}  // namespace cg
