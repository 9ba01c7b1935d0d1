// A row with one number: what the rows of numbers, coordinates and colours have in common.
#pragma once
#include <imgui.h>

#include <optional>
#include <string>

#include "params/field.h"

namespace cg {

struct App;

struct Row {
  const char* id;
  std::string_view symbol;  // markup of formula.h; empty: the slider begins at the left edge
  const About* about;
  double value;
  bool whole = false;                 // moves by whole numbers
  bool differs = false;               // from the default: shows the arrow
  std::optional<ImVec4> swatch = {};  // of a colour
  std::string exact = {};             // what is typed over when the value is edited; empty: the number
};

struct RowChange {
  std::optional<double> moved;       // by slider, drag or wheel
  std::optional<std::string> typed;  // not yet checked
  bool reset = false, swatch = false;
};

RowChange number_row(App& app, const Row& row);

// The field in which app.editing is typed, instead of what was `shown`. Enter and leaving it give the text where it
// differs, Escape does not; app.editing.item is 0 when it is over.
std::optional<std::string> type_value(App& app, ImFont* font, const std::string& shown, ImVec2 at, float width);

// The tooltip of a parameter: label, help, accepted range, unit, OpenGL's name.
void describe(App& app, const About& about, std::string_view exact);

}  // namespace cg
