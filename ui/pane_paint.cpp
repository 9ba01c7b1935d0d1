// How the panes look: pictures, lines and handles over them, and the line of text below.
#include <array>
#include <cmath>
#include <string>

#include "image/ramp.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/line_style.h"
#include "ui/number.h"
#include "ui/panes.h"
#include "ui/probe_marks.h"
#include "ui/widgets.h"

namespace cg {

namespace {

ImVec2 middle(const Place& p) { return {0.5f * (p.low.x + p.high.x), 0.5f * (p.low.y + p.high.y)}; }

// Pictures are mostly dark in either theme: what stands on them is white.
constexpr ImU32 on_picture = IM_COL32(255, 255, 255, 255);

// The colour of a light, made bright: a dark light is seen too.
ImU32 colour_of(const Light& light) {
  const glm::dvec3 c = light.diffuse;
  const double most = std::max({c.x, c.y, c.z});
  if (!(most > 0) || !std::isfinite(most)) return IM_COL32(150, 150, 150, 255);
  const auto channel = [&](double v) { return int(40 + 215 * std::clamp(v / most, 0.0, 1.0)); };
  return IM_COL32(channel(c.x), channel(c.y), channel(c.z), 255);
}

std::string rounded(double v, int places) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", places, v);
  for (char& c : text)
    if (c == ',') c = '.';  // whatever the locale
  return text;
}

// Whether texels are shown as they are: magnified, or one to one (which is faster then, and the same).
bool shows_texels(const Place& place, const Drawing& drawing) {
  return drawing.coarseness == 1 && (place.magnification() >= 2 || place.magnification() == 1);
}

// A small number of a legend.
std::string two_digits(double v) { return rounded(v, v == 0 || v >= 10 ? 0 : v >= 1 ? 1 : v >= 0.1 ? 2 : 3); }

std::string milliseconds(double ms) {
  if (!(ms > 0)) return "–";
  return rounded(ms, ms < 100 ? 1 : 0) + " ms  " + rounded(1000 / ms, ms > 100 ? 1 : 0) + " fps";
}

std::string pixel_value(const DrawingHandle& drawing, const glm::dvec2& at) {
  if (!drawing || drawing->coarseness != 1) return {};
  const ColourImage& colour = drawing->frame.colour;
  const int x = int(std::floor(at.x)), y = int(std::floor(at.y));
  if (x < 0 || y < 0 || x >= colour.width() || y >= colour.height()) return {};
  const glm::vec3 c = colour.at(x, y);
  return rounded(double(c.r), 3) + " " + rounded(double(c.g), 3) + " " + rounded(double(c.b), 3);
}

}  // namespace

void Panes::paint_picture(App& app, const Texture& texture, const Place& place, float from, float to) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto x_at = [&](float t) { return place.low.x + t * (place.high.x - place.low.x); };
  if (texture.empty()) {
    draw->AddRectFilled({x_at(from), place.low.y}, {x_at(to), place.high.y}, app.look.palette.pane);
    return;
  }
  const Region& r = place.region;
  const float u0 = float(r.low.x), v0 = float(r.low.y), e = float(r.extent());
  draw->AddImage(texture.id(), {x_at(from), place.low.y}, {x_at(to), place.high.y}, {u0 + from * e, v0},
                 {u0 + to * e, v0 + e});
}

void Panes::paint_pane(App& app, int side, const Place& place) {
  const PaneState& pane = jobs_.pane(side);
  if (place.empty()) return;
  const bool old = pane.message.has_value();
  if (!old && on_screen_[std::size_t(side)]) {
    pictures_[std::size_t(side)].magnify(shows_texels(place, *on_screen_[std::size_t(side)]));
    paint_picture(app, pictures_[std::size_t(side)], place, 0, 1);
    paint_lines(app, side, place);
    paint_handles(app, place);
    paint_probe(app, side, place);
    paint_cursor(app, place);
  }
  paint_message(app, side, place);
  paint_footer(app, side, {place.low.x, place.high.y + app.look.px(6)}, place.high.x - place.low.x);
}

void Panes::paint_wipe(App& app, const Place& place) {
  if (place.empty()) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float t = float(app.settings.wipe), edge = place.low.x + t * (place.high.x - place.low.x);
  for (int side = 0; side < 2; ++side) {
    const std::size_t i = std::size_t(side);
    if (on_screen_[i]) pictures_[i].magnify(shows_texels(place, *on_screen_[i]));
    if (jobs_.pane(side).message) continue;
    draw->PushClipRect({side == 0 ? place.low.x : edge, place.low.y}, {side == 0 ? edge : place.high.x, place.high.y},
                       true);
    paint_picture(app, pictures_[i], place, 0, 1);
    paint_lines(app, side, place);
    paint_probe(app, side, place);
    draw->PopClipRect();
  }
  paint_handles(app, place);
  paint_cursor(app, place);
  const bool held = pointing_.on_wipe || gesture_.kind == Gesture::wipe;
  const ImU32 colour = held ? on_picture : faded(on_picture, 0.75f);
  draw->AddRectFilled({edge - app.look.px(1), place.low.y}, {edge + app.look.px(1), place.high.y}, colour);
  const ImVec2 knob{edge, middle(place).y};
  draw->AddCircleFilled(knob, app.look.px(7), colour, 24);
  if (held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  paint_name(app, 0, {place.low.x + app.look.px(10), place.low.y + app.look.px(8)}, false);
  paint_name(app, 1, {place.high.x - app.look.px(10), place.low.y + app.look.px(8)}, true);
  for (int side = 0; side < 2; ++side) {
    Place half = place;
    (side == 0 ? half.high.x : half.low.x) = edge;
    paint_message(app, side, half);
  }
  paint_both_footers(app, place);
}

void Panes::paint_flip(App& app, const Place& place) {
  if (place.empty()) return;
  const bool typing = ImGui::GetIO().WantTextInput;
  if (!typing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab), false))
    flipped_ = 1 - flipped_, auto_flip_ = false;
  if (auto_flip_) {
    if (app.now - flipped_at_ > 0.7) flipped_ = 1 - flipped_, flipped_at_ = app.now;
    app.next_frame = std::min(app.next_frame, flipped_at_ + 0.71);
  }
  app.probing.side = flipped_;
  paint_pane(app, flipped_, place);
  paint_name(app, flipped_, {place.low.x + app.look.px(10), place.low.y + app.look.px(8)}, false);
  const Words label{"Auto", "自動"};
  const float w = button_width(app, label.in(app.language()));
  ImGui::SetCursorScreenPos({place.high.x - w - app.look.px(6), place.low.y + app.look.px(6)});
  if (button(app, "auto flip",
             {.label = label.in(app.language()),
              .tip = {"Changes by itself; Tab changes by hand", "自動で切り替える。Tab で手動"},
              .shortcut = "Tab",
              .chosen = auto_flip_}))
    auto_flip_ = !auto_flip_, flipped_at_ = app.now;
}

void Panes::paint_difference(App& app, const Place& place) {
  if (place.empty()) return;
  const bool there = shown_difference_ && !shown_difference_->picture.empty();
  if (there && !jobs_.pane(0).message && !jobs_.pane(1).message) {
    difference_.magnify(place.magnification() >= 2);
    paint_picture(app, difference_, place, 0, 1);
    paint_lines(app, 0, place);
    paint_handles(app, place);
    paint_probe(app, 0, place);
    paint_cursor(app, place);
    paint_worst(app, place);
  }
  for (int side = 0; side < 2; ++side) paint_message(app, side, place);
  paint_gain(app, place);
  if (app.settings.view == ViewMode::false_colour) paint_legend(app, place);
  paint_both_footers(app, place);
}

void Panes::paint_lines(App& app, int side, const Place& place) {
  const DrawingHandle& drawing = on_screen_[std::size_t(side)];
  const Settings& s = app.settings;
  const std::shared_ptr<const Probed>& probed = app.probing.results[std::size_t(side)];
  if (!drawing || !(s.wireframe || s.face_normals || s.vertex_normals || s.handles || s.axes || probed)) return;
  LineCall& call = line_calls_[std::size_t(side)];
  call = {this, side, place, {}, {}, {}};
  const Camera& camera = drawing->scene.camera;
  const double extent = handle_sphere_radius(camera, {place.width, place.height});
  if (s.handles)
    for (std::size_t i = 0; i < drawing->scene.lights.size(); ++i) {
      const Light& light = drawing->scene.lights[i];
      if (light.enabled) call.more.push_back(light_lines(light, int(i) == app.light, camera, extent));
    }
  if (s.axes)
    for (Lines& axis : axis_lines(1.2)) call.more.push_back(std::move(axis));
  if (probed) add_probe_lines(app, *probed, camera, 0.2, call.more);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const ImVec2 low = draw->GetClipRectMin(), high = draw->GetClipRectMax();
  call.clip = {low.x, low.y, high.x, high.y};
  call.style = [scale = app.look.scale](Mark m) { return style_of(scale, m); };
  draw->AddCallback(&Panes::draw_lines, &call);
  draw->AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  draw->PopClipRect();
}

void Panes::paint_handles(App& app, const Place& place) {
  if (!app.settings.handles) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const bool many = app.scene.lights.size() > 1;
  const float r = app.look.px(6);
  for (const Handle& h : light_handles(app.scene, {place.width, place.height})) {
    const Light& light = app.scene.lights[std::size_t(h.light)];
    const ImVec2 at = place.to_screen(h.pixel);
    const bool in_hand =
        (gesture_.kind == Gesture::light && gesture_.handle.light == h.light && gesture_.handle.grip == h.grip) ||
        (gesture_.kind == Gesture::none && pointing_.handle && pointing_.handle->light == h.light &&
         pointing_.handle->grip == h.grip);
    const ImU32 colour = faded(colour_of(light), h.behind ? 0.4f : 1.0f);
    const ImU32 ring = in_hand || h.light == app.light ? on_picture : faded(on_picture, 0.6f);
    const float size = h.grip == Grip::aim ? 0.7f * r : r;
    draw->AddCircle(at, size + app.look.px(2), IM_COL32(0, 0, 0, 150), 24, app.look.px(3));
    if (h.grip == Grip::place)
      draw->AddCircleFilled(at, size, colour, 24);
    else if (h.grip == Grip::sphere)
      draw->AddCircleFilled(at, 0.45f * size, colour, 16);
    draw->AddCircle(at, size + app.look.px(1), faded(ring, h.behind ? 0.5f : 1.0f), 24,
                    app.look.px(in_hand ? 2.5f : 1.5f));
    if (many && h.grip != Grip::aim)
      set_text(draw, app.look.fonts.small, {at.x + r + app.look.px(5), at.y + app.look.px(5)},
               IM_COL32(255, 255, 255, 230), noted(app, std::to_string(h.light)));
  }
  draw->PopClipRect();
  if (gesture_.kind == Gesture::none && pointing_.handle && place.contains(ImGui::GetIO().MousePos)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    constexpr std::array<Words, 3> tips{
        {{"Drag: move it. With Shift: nearer or farther", "ドラッグで動かす。Shift で前後に動かす"},
         {"Drag: where the light comes from", "ドラッグで光の来る向きを変える"},
         {"Drag: where the spot points", "ドラッグでスポットの向きを変える"}}};
    tooltip(app, "GL_LIGHT" + std::to_string(pointing_.handle->light),
            noted(app, tips[std::size_t(pointing_.handle->grip)]), "");
  }
}

// The pixel under the mouse, marked in both pictures; magnified pixels get a frame.
void Panes::paint_cursor(App& app, const Place& place) {
  if (pointing_.side < 0 || pointing_.handle || gesture_.kind != Gesture::none) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const double m = place.magnification();
  const bool here = place.contains(ImGui::GetIO().MousePos);
  if (here && m < 6) return;
  const glm::dvec2 pixel = glm::floor(pointing_.pixel);
  draw->PushClipRect(place.low, place.high, true);
  if (m >= 6) {
    const ImVec2 a = place.to_screen(pixel), b = place.to_screen(pixel + 1.0);
    draw->AddRect(a, b, IM_COL32(0, 0, 0, 200), 0, 0, app.look.px(3));
    draw->AddRect(a, b, IM_COL32(255, 255, 255, 255), 0, 0, app.look.px(1));
  } else {
    const ImVec2 c = place.to_screen(pointing_.pixel);
    for (const auto& [colour, w] : {std::pair{IM_COL32(0, 0, 0, 160), 3.0f}, {IM_COL32(255, 255, 255, 230), 1.0f}})
      for (const ImVec2& d : {ImVec2{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        draw->AddLine({c.x + d.x * app.look.px(4), c.y + d.y * app.look.px(4)},
                      {c.x + d.x * app.look.px(10), c.y + d.y * app.look.px(10)}, colour, app.look.px(w));
  }
  draw->PopClipRect();
}

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
  const ImVec2 c = middle(place);
  draw->AddText(font, font->FontSize, {std::floor(c.x - 0.5f * size.x), std::floor(c.y - 0.5f * size.y)},
                app.look.palette.dim, text.data(), text.data() + text.size(), wrap);
}

void Panes::paint_footer(App& app, int side, ImVec2 at, float width) {
  const PaneState& pane = jobs_.pane(side);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = app.look.fonts.small_mono;
  const float baseline = at.y + app.look.px(14);
  draw->PushClipRect({at.x, at.y}, {at.x + width, at.y + app.look.px(22)}, true);
  std::string right;
  if (pointing_.side >= 0 && !pane.message) {
    const std::string value = pixel_value(on_screen_[std::size_t(side)], pointing_.pixel);
    if (!value.empty())
      right =
          "(" + std::to_string(int(pointing_.pixel.x)) + ", " + std::to_string(int(pointing_.pixel.y)) + ")  " + value;
  }
  if (region_.factor > 1) right += "  ×" + rounded(region_.factor, 1);
  const float right_width = text_width(font, noted(app, right)) + app.look.px(4);
  const std::string times = milliseconds(pane.message ? 0 : pane.ms);
  if (right.empty() || text_width(font, noted(app, times)) + app.look.px(10) + right_width <= width)
    set_text(draw, font, {at.x, baseline}, app.look.palette.dim, times);
  set_text(draw, font, {at.x + width - right_width, baseline}, app.look.palette.text, right);
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

void Panes::paint_worst(App& app, const Place& place) {
  if (pointing_.side < 0 || !shown_difference_ || shown_difference_->difference.worst_x < 0) return;
  const Difference& d = shown_difference_->difference;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const ImVec2 c = place.to_screen({d.worst_x + 0.5, d.worst_y + 0.5});
  draw->AddCircle(c, app.look.px(9), IM_COL32(0, 0, 0, 200), 24, app.look.px(4));
  draw->AddCircle(c, app.look.px(9), on_picture, 24, app.look.px(2));
  const std::string text = rounded(255 * d.max_error, 2) + "/255";
  set_text(draw, app.look.fonts.small_mono, {c.x + app.look.px(14), c.y + app.look.px(5)}, IM_COL32(255, 255, 255, 255),
           noted(app, text));
  draw->PopClipRect();
}

}  // namespace cg
