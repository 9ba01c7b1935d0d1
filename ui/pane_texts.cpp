// What is written in and under the pictures: why there is none, times and values, names, the difference's gain and
// scale.
#include <cmath>
#include <string>
#include <vector>

#include "image/ramp.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/line_style.h"
#include "ui/number.h"
#include "ui/panes.h"
#include "ui/widgets.h"

namespace cg {

namespace {

// A small number of a legend.
std::string two_digits(double v) { return rounded(v, v == 0 || v >= 10 ? 0 : v >= 1 ? 1 : v >= 0.1 ? 2 : 3); }

// How long a picture took: in full, shorter, not at all.
std::vector<std::string> times(double ms) {
  if (!(ms > 0)) return {"–", ""};
  const std::string time = rounded(ms, ms < 100 ? 1 : 0) + " ms";
  return {time + "  " + rounded(1000 / ms, ms > 100 ? 1 : 0) + " fps", time, ""};
}

// The pixel and its colour: in full, without its place, with fewer digits.
std::vector<std::string> pixel_texts(const DrawingHandle& drawing, const glm::dvec2& at) {
  if (!drawing || drawing->coarseness != 1) return {""};
  const ColourImage& colour = drawing->frame.colour;
  const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
  if (x < 0 || y < 0 || x >= colour.width() || y >= colour.height()) return {""};
  const glm::vec3 c = colour.at(x, y);
  const auto digits = [&](int n) {
    return rounded(double(c.r), n) + " " + rounded(double(c.g), n) + " " + rounded(double(c.b), n);
  };
  return {"(" + std::to_string(x) + ", " + std::to_string(y) + ")  " + digits(3), digits(3), digits(1), ""};
}

struct Footer {
  std::string time, value;
};

// The longest pair that fits beside each other; of the two the time gives way first.
Footer fitting(ImFont* font, const std::vector<std::string>& times, const std::vector<std::string>& values,
               float width) {
  for (const std::string& value : values)
    for (const std::string& time : times)
      if (text_width(font, time) + text_width(font, value) <= width) return {time, value};
  return {};
}

}  // namespace

void Panes::paint_message(App& app, int side, const Place& place) {
  const PaneState& pane = jobs_.pane(side);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (!pane.message) {
    if (pane.busy && pane.ms > 150) {  // how far a slow technique has come
      const float y = place.high.y - app.look.px(3), w = place.high.x - place.low.x;
      draw->AddRectFilled({place.low.x, y}, {place.low.x + w * pane.fraction, place.high.y}, on_picture);
    }
    return;
  }
  if (place.high.x - place.low.x < app.look.px(60)) return;
  draw->AddRectFilled(place.low, place.high, app.look.palette.pane, app.look.px(4));
  const std::string_view text = noted(app, *pane.message);
  ImFont* font = app.look.fonts.text;
  const float wrap = std::min(app.look.px(460), place.high.x - place.low.x - app.look.px(32));
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, wrap, text.data(), text.data() + text.size());
  const ImVec2 c = place.middle();
  draw->AddText(font, font->FontSize, {std::floor(c.x - 0.5f * size.x), std::floor(c.y - 0.5f * size.y)},
                app.look.palette.dim, text.data(), text.data() + text.size(), wrap);
}

void Panes::paint_footer(App& app, int side, ImVec2 at, float width) {
  const PaneState& pane = jobs_.pane(side);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = app.look.fonts.small_mono;
  std::vector<std::string> values{""};
  if (pointing_.side >= 0 && !pane.message) values = pixel_texts(on_screen_[std::size_t(side)], pointing_.pixel);
  if (region_.factor > 1)
    for (std::string& value : values) value += "  ×" + rounded(region_.factor, 1);
  const Footer footer = fitting(font, times(pane.message ? 0 : pane.ms), values, width - app.look.px(20));
  const float baseline = at.y + app.look.px(14);
  draw->PushClipRect({at.x, at.y}, {at.x + width, at.y + app.look.px(22)}, true);
  set_text(draw, font, {at.x, baseline}, app.look.palette.dim, noted(app, footer.time));
  set_text(draw, font, {at.x + width - text_width(font, footer.value) - app.look.px(4), baseline},
           app.look.palette.text, noted(app, footer.value));
  draw->PopClipRect();
}

// Under one picture of both techniques: half of the whole width for each.
void Panes::paint_both_footers(App& app, const Place& place) {
  const float gap = app.look.px(24), half = std::floor(0.5f * (area_.y - area_.x - gap)),
              y = place.high.y + app.look.px(6);
  paint_footer(app, 0, {area_.x, y}, half);
  paint_footer(app, 1, {area_.y - half, y}, half);
}

void Panes::paint_name(App& app, int side, ImVec2 at, bool from_right) {
  const int technique = jobs_.pane(side).technique;
  if (technique < 0) return;
  const std::string_view name = noted(app, app.techniques[std::size_t(technique)].name);
  ImFont* font = app.look.fonts.small;
  const float w = text_width(font, name), pad = app.look.px(6);
  const float x = from_right ? at.x - w : at.x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x - pad, at.y - app.look.px(2)}, {x + w + pad, at.y + app.look.px(20)}, IM_COL32(0, 0, 0, 130),
                      app.look.px(4));
  set_text(draw, font, {x, at.y + app.look.px(14)}, IM_COL32(240, 242, 248, 255), name);
}

void Panes::paint_gain(App& app, const Place& place) {
  const About* about = nullptr;
  std::apply([&](const auto&... f) { ((f.about.name == "gain" ? void(about = &f.about) : void()), ...); },
             fields_of<Settings>);
  Look& look = app.look;
  const float w = look.px(140), h = look.px(24), pad = look.px(10);
  const std::string text = "× " + rounded(app.settings.gain, app.settings.gain < 10 ? 1 : 0);
  const float text_w = look.px(52);
  const ImVec2 at{place.high.x - w - text_w - 2 * pad, place.low.y + look.px(8)};
  if (at.x < place.low.x) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({at.x - pad, at.y}, {place.high.x - look.px(6), at.y + h}, IM_COL32(0, 0, 0, 130), look.px(4));
  ImGui::SetCursorScreenPos(at);
  double position = slider_position(*about, app.settings.gain);
  if (slider(app, "gain", position, on_picture, false, {w, h}))
    app.settings.gain = slider_value(*about, position, false);
  if (wants_tooltip(app)) tooltip(app, about->label.in(app.language()), about->help.in(app.language()), "");
  set_text(draw, look.fonts.small_mono, {at.x + w + look.px(10), at.y + look.px(17)}, IM_COL32(240, 242, 248, 255),
           noted(app, text));
}

void Panes::paint_legend(App& app, const Place& place) {
  Look& look = app.look;
  const float w = std::min(look.px(260), place.high.x - place.low.x - look.px(60)), h = look.px(10);
  if (w < look.px(80)) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 at{place.low.x + look.px(18), place.high.y - look.px(40)};
  draw->AddRectFilled({at.x - look.px(10), at.y - look.px(8)}, {at.x + w + look.px(34), at.y + look.px(34)},
                      IM_COL32(0, 0, 0, 150), look.px(4));
  constexpr int steps = 48;
  for (int i = 0; i < steps; ++i) {
    const glm::u8vec4 c = ramp((i + 0.5) / steps);
    draw->AddRectFilled({at.x + w * float(i) / steps, at.y}, {at.x + w * float(i + 1) / steps + 0.5f, at.y + h},
                        IM_COL32(c.r, c.g, c.b, 255));
  }
  const auto numbers = ramp_legend(255 / app.settings.gain);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string text = two_digits(numbers[i]) + (i + 1 == numbers.size() ? "/255" : "");
    set_text(draw, look.fonts.small_mono,
             {at.x + w * float(i) / float(numbers.size() - 1) - (i ? look.px(8) : 0), at.y + look.px(27)},
             IM_COL32(240, 242, 248, 255), noted(app, text));
  }
}

}  // namespace cg
