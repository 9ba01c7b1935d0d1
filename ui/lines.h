// Lines of text in a panel.
#pragma once
#include <imgui.h>

#include <string_view>

namespace cg {

struct App;

// A text to the left and a figure to the right.
void pair_line(App& app, std::string_view left, std::string_view right, ImU32 colour);

// The same in the small faces; a figure too long for the line is cut at its right end.
void small_pair_line(App& app, std::string_view left, std::string_view right, ImU32 colour);

// A paragraph in the small face, wrapped at the panel's edge, its formulas typeset.
void small_text(App& app, std::string_view text, ImU32 colour);

}  // namespace cg
