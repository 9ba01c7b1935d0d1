#include "ui/plot_view.h"

#include <algorithm>
#include <cmath>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/state_dump.h"

namespace cg {
namespace {

// Series have Okabe and Ito's colours, as quantities have; the front is what is read first.
ImU32 colour_of(const Look& look, PlotInk ink) {
  constexpr Quantity series[] = {Quantity::ambient, Quantity::diffuse, Quantity::reflection, Quantity::transmission,
                                 Quantity::specular};
  switch (ink) {
    case PlotInk::text:
    case PlotInk::front:
      return look.palette.text;
    case PlotInk::dim:
      return look.palette.dim;
    case PlotInk::grid:
      return look.palette.line;
    default:
      return look.of(series[(int(ink) - int(PlotInk::series0)) % 5]);
  }
}

void dashed_line(ImDrawList* draw, ImVec2 a, ImVec2 b, ImU32 colour, float thickness, float dash) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0) || !(dash > 0) || length > 1e5f) return;
  const auto at = [&](float t) { return ImVec2{a.x + (b.x - a.x) * t / length, a.y + (b.y - a.y) * t / length}; };
  for (float t = 0; t < length; t += 1.8f * dash)
    draw->AddLine(at(t), at(std::min(t + dash, length)), colour, thickness);
}

// Letters that read upwards: set to the right, then turned a quarter to the left about where they begin.
void upright_text(ImDrawList* draw, ImFont* font, ImVec2 at, ImU32 colour, std::string_view text, float scale) {
  const int first = draw->VtxBuffer.Size;
  draw->PushClipRect({at.x - 8192, at.y - 8192}, {at.x + 8192, at.y + 8192});  // they are not where they will be
  set_text(draw, font, at, colour, text, scale);
  draw->PopClipRect();
  for (int i = first; i < draw->VtxBuffer.Size; ++i) {
    ImVec2& p = draw->VtxBuffer[i].pos;
    p = {at.x + (p.y - at.y), at.y - (p.x - at.x)};
  }
}

class Painter {
 public:
  Painter(App& app, ImVec2 origin, const Plot& plot, int chosen)
      : app_(app), look_(app.look), draw_(ImGui::GetWindowDrawList()), origin_(origin), plot_(plot), chosen_(chosen) {}

  void paint(const PlotLayout& layout, int hovered) {
    for (const PlotMark& mark : layout.marks) {
      if (mark.places.empty()) continue;
      const ImU32 colour = colour_of(look_, mark.ink);
      switch (mark.kind) {
        case PlotMark::Kind::line:
          paint_line(mark, colour);
          break;
        case PlotMark::Kind::dot:
        case PlotMark::Kind::circle:
          paint_point(mark, colour, mark.point >= 0 && mark.point == hovered);
          break;
        case PlotMark::Kind::text:
          paint_text(mark, colour);
          break;
      }
    }
  }

 private:
  ImVec2 at(const PlotPlace& place) const { return {origin_.x + place.x, origin_.y + place.y}; }
  float thick(float size) const { return std::max(1.0f, size * look_.stroke); }

  void paint_line(const PlotMark& mark, ImU32 colour) {
    if (mark.dashed) {
      for (std::size_t i = 0; i + 1 < mark.places.size(); ++i)
        dashed_line(draw_, at(mark.places[i]), at(mark.places[i + 1]), colour, thick(mark.size), look_.px(5));
      return;
    }
    line_.clear();
    for (const PlotPlace& place : mark.places) line_.push_back(at(place));
    draw_->AddPolyline(line_.data(), int(line_.size()), colour, 0, thick(mark.size));
  }

  void paint_point(const PlotMark& mark, ImU32 colour, bool hovered) {
    const ImVec2 c = at(mark.places[0]);
    const float r = mark.size * look_.stroke;
    const bool chosen = mark.point >= 0 && int(plot_.points[std::size_t(mark.point)].index) == chosen_;
    if (hovered || chosen) draw_->AddCircleFilled(c, r + look_.px(5), faded(colour, 0.35f), 24);
    if (mark.kind == PlotMark::Kind::circle)
      draw_->AddCircleFilled(c, r, look_.palette.panel, 24), draw_->AddCircle(c, r, colour, 24, thick(look_.px(1.5f)));
    else
      draw_->AddCircleFilled(c, r, colour, 24);
    if (chosen) draw_->AddCircle(c, r + look_.px(3), look_.palette.accent, 24, thick(look_.px(1.5f)));
  }

  void paint_text(const PlotMark& mark, ImU32 colour) {
    const float scale = mark.size / look_.fonts.small->FontSize;
    if (mark.upright)
      upright_text(draw_, look_.fonts.small, at(mark.places[0]), colour, noted(app_, mark.text), scale);
    else
      set_text(draw_, look_.fonts.small, at(mark.places[0]), colour, noted(app_, mark.text), scale);
  }

  App& app_;
  const Look& look_;
  ImDrawList* draw_;
  ImVec2 origin_;
  const Plot& plot_;
  int chosen_;
  std::vector<ImVec2> line_;
};

void note_points(const App& app, const PlotLayout& layout, const Plot& plot, ImVec2 origin) {
  if (!app.dump) return;
  for (const PlotMark& mark : layout.marks) {
    if (mark.point < 0 || mark.kind == PlotMark::Kind::line || mark.kind == PlotMark::Kind::text) continue;
    const ImVec2 c{origin.x + mark.places[0].x, origin.y + mark.places[0].y};
    app.dump->place("point:" + std::to_string(plot.points[std::size_t(mark.point)].index), {c.x - 3, c.y - 3},
                    {c.x + 3, c.y + 3});
  }
}

void lay_out_again(App& app, PlotView& view, std::shared_ptr<const Plot> plot, ImVec2 size) {
  ImFont* font = app.look.fonts.small;
  if (view.plot == plot && view.size.x == size.x && view.size.y == size.y && view.language == app.language() &&
      view.font == font)
    return;
  const auto width = [font](const std::string& text, float letters) {
    return text_width(font, text, letters / font->FontSize);
  };
  const float letters = 1.07f * font->FontSize;
  view.head = plot->title.en.empty() ? 1.7f * letters : 0;
  view.layout = lay_out(*plot, size.x, size.y + view.head, letters, app.language(), width);
  view.plot = std::move(plot), view.size = size, view.language = app.language(), view.font = font;
}

}  // namespace

PlotMouse draw_plot(App& app, PlotView& view, const char* id, std::shared_ptr<const Plot> plot, ImVec2 size,
                    int chosen) {
  size = {std::max(size.x, app.look.px(120)), std::max(size.y, app.look.px(100))};
  ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, size);
  lay_out_again(app, view, std::move(plot), size);
  origin.y -= view.head;
  PlotMouse mouse;
  if (ImGui::IsItemHovered()) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    mouse.hovered = point_at(view.layout, {at.x - origin.x, at.y - origin.y});
    mouse.clicked = clicked && mouse.hovered >= 0;
    if (mouse.hovered >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  Painter(app, origin, *view.plot, chosen).paint(view.layout, mouse.hovered);
  note_points(app, view.layout, *view.plot, origin);
  return mouse;
}

}  // namespace cg
