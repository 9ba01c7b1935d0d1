// The scene as OpenGL calls: the listing, each number dragged or typed in it.
#include <algorithm>
#include <cmath>

#include "params/slots.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/layout.h"
#include "ui/quiz.h"
#include "ui/radiosity_desk.h"
#include "ui/widgets.h"

namespace cg {
namespace {

// A small word that is pressed, and its width.
bool link(App& app, const char* id, std::string_view label, const Words& tip, bool chosen, float& x, float y) {
  Look& look = app.look;
  const float w = text_width(look.fonts.small, noted(app, label)) + look.px(12), h = look.px(22);
  ImGui::SetCursorScreenPos({x, y});
  const bool pressed = ImGui::InvisibleButton(id, {w, h});
  if (ImGui::IsItemHovered())
    ImGui::GetWindowDrawList()->AddRectFilled({x, y}, {x + w, y + h}, look.palette.raised, look.px(4));
  set_text(ImGui::GetWindowDrawList(), look.fonts.small, {x + look.px(6), y + look.px(16)},
           chosen || ImGui::IsItemHovered() ? look.palette.text : look.palette.dim, label);
  if (!tip.en.empty() && wants_tooltip(app)) tooltip(app, {}, tip.in(app.language()), {});
  x += w;
  return pressed;
}

// The title, the sections to jump to as far as there is room, and the button that copies.
void draw_heading(App& app) {
  Look& look = app.look;
  CodeView& view = app.code;
  const Language l = app.language();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  const std::string_view title = noted(app, Words{"Program", "プログラム"});
  heading(app, title);
  float x = at.x + text_width(look.fonts.small, title) + look.px(18);
  const Words copy{"Copy", "コピー"};
  const float copy_w = text_width(look.fonts.small, noted(app, copy)) + look.px(12);
  for (std::size_t i = 0; i < view.sections.size(); ++i) {
    const CodeView::Section& section = view.sections[i];
    if (x + text_width(look.fonts.small, section.label.in(l)) + look.px(20) + copy_w > right) break;
    ImGui::PushID(int(i));
    if (link(app, "section", section.label.in(l), {}, section.light >= 0 && section.light == app.light, x, at.y)) {
      view.jump = section.line;
      if (section.light >= 0) app.light = view.light = section.light;
    }
    ImGui::PopID();
  }
  x = right - copy_w;
  if (link(app, "copy", copy.in(l), {"Copies the listing to the clipboard", "プログラムをクリップボードにコピーする"},
           false, x, at.y)) {
    ImGui::SetClipboardText(view.text().c_str());
    say(app, Text(Words{"The listing is in the clipboard", "プログラムをクリップボードにコピーしました"}));
  }
  ImGui::SetCursorScreenPos({at.x, at.y + look.px(25)});
}

ImU32 ink_of(const Look& look, CodeInk ink) {
  switch (ink) {
    case CodeInk::comment:
      return faded(look.palette.dim, 0.85f);
    case CodeInk::quiet:
      return look.palette.dim;
    default:
      return look.palette.text;
  }
}

// Not by colour alone: a triangle with an exclamation mark.
void draw_guilt(const Look& look, ImVec2 at, float height) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float x = at.x + look.px(1), w = look.px(13), top = at.y + look.px(3), bottom = at.y + height - look.px(3);
  const float c = x + 0.5f * w, dot = std::max(1.0f, look.px(1));
  draw->AddTriangleFilled({c, top}, {x + w, bottom}, {x, bottom}, look.palette.error);
  const ImU32 ink = look.palette.panel;
  draw->AddRectFilled({c - dot, top + look.px(5)}, {c + dot, bottom - look.px(4)}, ink);
  draw->AddRectFilled({c - dot, bottom - look.px(3)}, {c + dot, bottom - look.px(1.5f)}, ink);
}

// The line that was clicked in the quiz and is not the guilty one.
void draw_cross(const Look& look, ImVec2 at, float height) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = look.px(4), w = look.px(2);
  const ImVec2 c{at.x + look.px(7.5f), at.y + 0.5f * height};
  draw->AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, look.palette.text, w);
  draw->AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, look.palette.text, w);
}

void explain_guilt(App& app, const ListingLine& line, ImVec2 at) {
  Mistakes names;
  for (const Slot& slot : slots(names)) {
    if (slot.path != line.mistake) continue;
    ImGui::SetNextWindowPos({at.x, at.y - app.look.px(4)}, 0, {0, 1});
    tooltip(app, slot.about->label.in(app.language()), slot.about->help.in(app.language()), {});
  }
}

struct LinePlace {
  ImVec2 at;  // of the gutter
  float width, height, gutter;
};

// What lies behind the letters; true while the mouse is on the line.
bool draw_line_back(App& app, const ListingLine& line, const LinePlace& p) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{p.at.x + p.width, p.at.y + p.height};
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       ImGui::IsMouseHoveringRect(p.at, end) && !line.text.empty();
  const bool term = line.quantity != Quantity::none, guilty = line.guilty && !quiz_asks(app);
  if (hovered && term) app.lit_next = line.quantity;
  if (guilty) draw->AddRectFilled(p.at, end, faded(look.palette.error, 0.16f), look.px(3));
  if (term && app.lit == line.quantity)
    draw->AddRectFilled(p.at, end, faded(look.of(line.quantity), 0.16f), look.px(3));
  else if (hovered)
    draw->AddRectFilled(p.at, end, faded(look.palette.raised, 0.6f), look.px(3));
  if (guilty) {
    draw_guilt(look, p.at, p.height);
    ImGui::SetCursorScreenPos(p.at);
    ImGui::InvisibleButton(line.text.c_str(), {p.gutter, p.height});
    if (wants_tooltip(app)) explain_guilt(app, line, p.at);
  } else if (app.quiz && app.quiz->quiz.answered() && line.text == app.quiz->chosen) {
    draw_cross(look, p.at, p.height);
  }
  return hovered;
}

void draw_line(App& app, std::size_t index, const LinePlace& p) {
  Look& look = app.look;
  const CodeView& view = app.code;
  const ListingLine& line = view.listing.lines[index];
  ImFont* font = look.fonts.small_mono;
  const bool asks = quiz_asks(app), hovered = draw_line_back(app, line, p);
  const float letter = text_width(font, "0");
  float x0 = p.at.x + p.gutter;
  const float baseline = p.at.y + std::floor(0.5f * (p.height - font->FontSize)) + font->Ascent;
  std::size_t number = 0;
  for (const ListingRun& run : code_runs(line)) {
    const ImVec2 at{x0 + letter * float(run.begin), p.at.y};
    const std::string_view text = std::string_view(line.text).substr(run.begin, run.end - run.begin);
    if (run.ink == CodeInk::number && !line.numbers[number].path.empty() && !asks)
      x0 += code_number(app, line, number, view.keys[index][number], at, p.height);
    else
      set_text(ImGui::GetWindowDrawList(), font, {at.x, baseline}, ink_of(look, run.ink), noted(app, text));
    if (run.ink == CodeInk::number) ++number;
  }
  if (!hovered) return;
  if (asks) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!ImGui::IsMouseClicked(0)) return;
  if (line.light >= 0) app.light = app.code.light = line.light;
  if (asks) answer_line(app, line);
}

// Brings a line to the top when another light was selected, or a section was pressed.
void follow(App& app, float line_height) {
  CodeView& view = app.code;
  if (view.light != app.light) {
    view.light = app.light;
    for (const CodeView::Section& section : view.sections)
      if (section.light == app.light) view.jump = section.line;
  }
  if (view.jump < 0) return;
  ImGui::SetScrollY(line_height * float(view.jump));
  ImGui::SetScrollX(0);
  view.jump = -1;
}

void draw_lines(App& app) {
  Look& look = app.look;
  CodeView& view = app.code;
  const float h = look.px(20), gutter = look.px(19);
  const std::size_t count = view.listing.lines.size();
  const float wide = gutter + text_width(look.fonts.small_mono, "0") * float(view.widest) + look.px(12);
  follow(app, h);
  move_held_number(app);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float scrolled = ImGui::GetScrollY(), seen = ImGui::GetWindowHeight();
  const std::size_t first = std::size_t(std::max(0.0f, std::floor(scrolled / h)));
  const std::size_t last = std::min(count, first + std::size_t(std::ceil(seen / h)) + 1);
  for (std::size_t i = first; i < last; ++i)
    draw_line(app, i, {{at.x, at.y + h * float(i)}, std::max(wide, room.x), h, gutter});
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({wide, h * float(count)});
}

}  // namespace

void draw_code_panel(App& app) {
  app.code.make(scene_with_solution(app), app.language(), quiz_asks(app));
  draw_heading(app);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  if (ImGui::BeginChild("lines", ImGui::GetContentRegionAvail(), false, ImGuiWindowFlags_HorizontalScrollbar))
    draw_lines(app);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace cg
