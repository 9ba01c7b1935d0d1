#include "ui/fill.h"

#include <epoxy/gl.h>

#include <cstdint>

namespace cg {

namespace {

// The command's clip rectangle is the area, its data the colour. ImGui sets the scissor anew for each command.
void clear_area(const ImDrawList*, const ImDrawCmd* command) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 scale = io.DisplayFramebufferScale;
  const ImVec4& r = command->ClipRect;
  const int x = int(r.x * scale.x), y = int((io.DisplaySize.y - r.w) * scale.y);
  const int w = int(r.z * scale.x) - x, h = int((io.DisplaySize.y - r.y) * scale.y) - y;
  if (w <= 0 || h <= 0) return;
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(ImU32(reinterpret_cast<std::uintptr_t>(command->UserCallbackData)));
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, w, h);
  glClearColor(c.x, c.y, c.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void fill(ImDrawList* list, ImVec2 low, ImVec2 high, ImU32 colour) {
  list->PushClipRect(low, high, true);
  list->AddCallback(clear_area, reinterpret_cast<void*>(std::uintptr_t(colour)));
  list->PopClipRect();
}

}  // namespace cg
