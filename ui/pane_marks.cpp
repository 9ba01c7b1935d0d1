// What stands on the pictures at its place: lines, the handles of the lights, the pixel under the mouse, the worst one.
#include <array>
#include <cmath>
#include <string>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/line_style.h"
#include "ui/number.h"
#include "ui/panes.h"
#include "ui/probe_marks.h"
#include "ui/widgets.h"

namespace cg {

namespace {

// The colour of a light, made bright: a dark light is seen too.
ImU32 colour_of(const Light& light) {
  const glm::dvec3 c = light.diffuse;
  const double most = std::max({c.x, c.y, c.z});
  if (!(most > 0) || !std::isfinite(most)) return IM_COL32(150, 150, 150, 255);
  const auto channel = [&](double v) { return int(40 + 215 * std::clamp(v / most, 0.0, 1.0)); };
  return IM_COL32(channel(c.x), channel(c.y), channel(c.z), 255);
}

}  // namespace

void Panes::paint_lines(App& app, int side, const Place& place) {
  const DrawingHandle& drawing = on_screen_[std::size_t(side)];
  const Settings& s = app.settings;
  const std::shared_ptr<const Probed>& probed = app.probing.results[std::size_t(side)];
  if (!drawing ||
      !(s.wireframe || s.face_normals || s.vertex_normals || s.handles || s.axes || probed || !app.pointed.empty()))
    return;
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
  call.more.insert(call.more.end(), app.pointed.begin(), app.pointed.end());
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const ImVec2 low = draw->GetClipRectMin(), high = draw->GetClipRectMax();
  call.clip = {low.x, low.y, high.x, high.y};
  call.style = [scale = app.look.scale * app.look.stroke](Mark m) { return style_of(scale, m); };
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
