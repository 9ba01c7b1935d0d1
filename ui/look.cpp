#include "ui/look.h"

#include <imgui_internal.h>

#include <string>

namespace cg {
namespace {

constexpr ImU32 rgb(unsigned hex) { return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, 255); }

// The quantities: Masataka Okabe and Kei Ito, Color Universal Design, 2002. On white they are darkened, hue kept,
// so that a letter in them can be read.
const Palette dark = {.window = rgb(0x121418),
                      .panel = rgb(0x1b1e23),
                      .pane = rgb(0x0a0b0d),
                      .raised = rgb(0x2a2e36),
                      .raised_hover = rgb(0x373d47),
                      .line = rgb(0x3a3f49),
                      .text = rgb(0xe4e7ec),
                      .dim = rgb(0x8d949f),
                      .accent = rgb(0xdfe3ea),
                      .on_accent = rgb(0x15171b),
                      .error = rgb(0xff7a66),
                      .knob = rgb(0xdfe3ea),
                      .knob_edge = 0,
                      .quantity = {rgb(0x6f7787), rgb(0x56b4e9), rgb(0xe69f00), rgb(0xf0e442), rgb(0x009e73),
                                   rgb(0xcc79a7), rgb(0xd55e00)}};

const Palette light = {.window = rgb(0xdcdfe4),
                       .panel = rgb(0xf6f7f9),
                       .pane = rgb(0xc9cdd4),
                       .raised = rgb(0xe3e6eb),
                       .raised_hover = rgb(0xd3d8e0),
                       .line = rgb(0xc6cbd4),
                       .text = rgb(0x1b1e24),
                       .dim = rgb(0x626a77),
                       .accent = rgb(0x2b3038),
                       .on_accent = rgb(0xf8f9fb),
                       .error = rgb(0xb3261e),
                       .knob = rgb(0xffffff),
                       .knob_edge = rgb(0x9aa1ad),
                       .quantity = {rgb(0x8b93a1), rgb(0x1f85bd), rgb(0xb87800), rgb(0x8c7f00), rgb(0x008561),
                                    rgb(0xb0568a), rgb(0xc05000)}};

}  // namespace

const Palette& palette_of(Theme theme) { return theme == Theme::dark ? dark : light; }

ImU32 faded(ImU32 colour, float alpha) {
  const ImU32 a = ImU32(float(colour >> IM_COL32_A_SHIFT & 255) * ImSaturate(alpha) + 0.5f);
  return (colour & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

std::string_view Glyphs::note(std::string_view text) {
  const char* end = text.data() + text.size();
  for (const char* p = text.data(); p < end;) {
    if (static_cast<signed char>(*p) >= 0) {  // ASCII is always there
      ++p;
      continue;
    }
    unsigned point = 0;
    p += std::max(1, ImTextCharFromUtf8(&point, p, end));
    if (point != 0 && point <= IM_UNICODE_CODEPOINT_MAX && wanted.insert(ImWchar(point)).second) changed = true;
  }
  return text;
}

void apply_style(const Look& look) {
  ImGuiStyle style;
  const Palette& p = look.palette;
  style.WindowPadding = {14, 12};
  style.FramePadding = {9, 5};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.ScrollbarRounding = 4;
  style.GrabRounding = 4;
  style.ScrollbarSize = 9;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowMinSize = {1, 1};
  style.CircleTessellationMaxError = 0.2f;
  style.ScaleAllSizes(look.scale);
  auto set = [&](ImGuiCol which, ImU32 colour) { style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour); };
  set(ImGuiCol_Text, p.text);
  set(ImGuiCol_TextDisabled, p.dim);
  set(ImGuiCol_WindowBg, p.window);
  set(ImGuiCol_ChildBg, 0);
  set(ImGuiCol_PopupBg, p.panel);
  set(ImGuiCol_Border, p.line);
  set(ImGuiCol_FrameBg, p.raised);
  set(ImGuiCol_FrameBgHovered, p.raised_hover);
  set(ImGuiCol_FrameBgActive, p.raised_hover);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, p.raised);
  set(ImGuiCol_ScrollbarGrabHovered, p.raised_hover);
  set(ImGuiCol_ScrollbarGrabActive, p.raised_hover);
  set(ImGuiCol_Button, p.raised);
  set(ImGuiCol_ButtonHovered, p.raised_hover);
  set(ImGuiCol_ButtonActive, p.raised_hover);
  set(ImGuiCol_Header, p.raised);
  set(ImGuiCol_HeaderHovered, p.raised_hover);
  set(ImGuiCol_HeaderActive, p.raised_hover);
  set(ImGuiCol_CheckMark, p.accent);
  set(ImGuiCol_TextSelectedBg, faded(p.quantity[int(Quantity::ambient)], 0.35f));
  set(ImGuiCol_Separator, p.line);
  set(ImGuiCol_NavHighlight, 0);
  ImGui::GetStyle() = style;
}

}  // namespace cg
