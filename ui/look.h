// How the window looks: colours of the two themes, one colour for each quantity, and the fonts.
#pragma once
#include <imgui.h>

#include <string_view>
#include <unordered_set>

#include "params/field.h"
#include "ui/settings.h"

namespace cg {

struct Palette {
  ImU32 window;        // behind everything, and between the panels
  ImU32 panel;         // of parameters, bars and strips
  ImU32 pane;          // around the pictures
  ImU32 raised;        // buttons and fields
  ImU32 raised_hover;  // the same under the mouse
  ImU32 line;          // the few lines there are, and the tracks of sliders
  ImU32 text, dim;     // what is read first, and what is read second
  ImU32 accent;        // the one colour of what is chosen or in hand,
  ImU32 on_accent;     // and of the letters on it
  ImU32 error;
  ImU32 knob, knob_edge;  // of sliders; an edge of 0 is none
  ImU32 quantity[7];      // by Quantity; Okabe and Ito's colour-blind-safe set, none is the knob's neutral
};
const Palette& palette_of(Theme theme);

// Unicode points to be rasterised. Grows with the texts that are shown; the atlas is built again when it has.
struct Glyphs {
  std::unordered_set<ImWchar> wanted;
  bool changed = false;
  // Notes the points of a UTF-8 text and returns it. Cheap for texts seen before.
  std::string_view note(std::string_view text);
};

// Never null after the fonts are loaded. Sizes in em at scale 1: text 18, small 14, title 22, math 22, math_sub 15.
struct Fonts {
  ImFont *text = nullptr, *small = nullptr, *bold = nullptr;
  ImFont *mono = nullptr, *small_mono = nullptr;
  ImFont *math = nullptr, *math_sub = nullptr;        // italic letters of a formula, and their indices
  ImFont *formula = nullptr, *formula_sub = nullptr;  // the same, larger, for the equation in the strip
};

struct Look {
  Palette palette;
  float stroke = 1;  // lines and markers are thicker by this, on top of the scale
  float scale = 1;   // pixels for one unit of the design: the monitor's scale times the user's zoom
  Fonts fonts;
  Glyphs glyphs;

  ImU32 of(Quantity q) const { return palette.quantity[int(q)]; }
  float px(float units) const { return float(int(units * scale + 0.5f)); }
};

// ImGui's own style from the palette and the scale.
void apply_style(const Look& look);

// `colour` with its alpha multiplied by `alpha` (0..1).
ImU32 faded(ImU32 colour, float alpha);

}  // namespace cg
