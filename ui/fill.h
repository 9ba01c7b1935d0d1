// Large areas of one colour, by clearing instead of drawing: OpenGL in software needs 7 ms of a processor for a
// quad as large as a window, and next to nothing to clear one.
#pragma once
#include <imgui.h>

namespace cg {

// Fills from `low` to `high` (screen pixels) with an opaque colour, in the order of the list's other commands.
void fill(ImDrawList* list, ImVec2 low, ImVec2 high, ImU32 colour);

}  // namespace cg
