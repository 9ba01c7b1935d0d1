#include "ui/pane_gestures.h"

#include <imgui_internal.h>

#include "ui/app.h"
#include "ui/hemicube_marks.h"
#include "workbench/camera_control.h"

namespace cg {

namespace {

constexpr float grab = 11;  // units from a handle or from the wipe's edge that still take hold of it
constexpr double most_magnified = 64;
constexpr double largest_viewport = 16384;
constexpr double zoom_per_notch = 0.15, region_per_notch = 0.35;

glm::dvec2 size_of(const Place& place) { return {place.width, place.height}; }

ImVec2 wipe_edge(const App& app, const Place& place) {
  return {place.low.x + float(app.settings.wipe) * (place.high.x - place.low.x), place.low.y};
}

void begin(App& app, Gesture& g, const Pointing& pointing, const Region& region, int side) {
  const ImGuiIO& io = ImGui::GetIO();
  g = {};
  g.side = side, g.start = io.MousePos;
  if (ImGui::IsMouseClicked(0) && pointing.handle) {
    g.kind = Gesture::light;
    g.handle = *pointing.handle;
    g.before = app.scene.lights[std::size_t(g.handle.light)];
    app.light = g.handle.light;
  } else if (ImGui::IsMouseClicked(0) && pointing.on_wipe) {
    g.kind = Gesture::wipe;
  } else if (region.factor > 1 && (io.KeyCtrl || ImGui::IsMouseClicked(2))) {
    g.kind = Gesture::region;
  } else if (ImGui::IsMouseClicked(2) || ImGui::IsMouseClicked(1) || io.KeyShift) {
    g.kind = Gesture::pan;
  } else {
    g.kind = Gesture::orbit;
  }
}

void drag_light(App& app, Gesture& g, const Place& place) {
  if (g.handle.light >= int(app.scene.lights.size())) return;
  const ImGuiIO& io = ImGui::GetIO();
  Light& light = app.scene.lights[std::size_t(g.handle.light)];
  if (io.KeyShift != g.along_view) {  // the drag goes on from where it is
    g.along_view = io.KeyShift;
    g.before = light;
    g.start = io.MousePos;
    for (const Handle& h : light_handles(app.scene, size_of(place)))
      if (h.light == g.handle.light && h.grip == g.handle.grip) g.handle = h;
  }
  const glm::dvec2 moved = place.to_picture(io.MousePos) - place.to_picture(g.start);
  light = dragged(g.before, g.handle, app.scene.camera, size_of(place), moved, g.along_view);
}

void go_on(App& app, Gesture& g, Region& region, const Place& place, const Scene& shapes) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 d = io.MouseDelta;
  app.animating = true;
  app.gesture = true;
  if (g.kind == Gesture::light) return drag_light(app, g, place);
  if (d.x == 0 && d.y == 0) return;
  if (g.kind == Gesture::orbit && !ImGui::IsMouseDragPastThreshold(0)) return;  // it may become a click
  const double height = place.screen_height() * region.factor;
  switch (g.kind) {
    case Gesture::orbit:
      move_camera(app, orbit(app.scene.camera, -pi * double(d.x) / height, pi * double(d.y) / height), shapes);
      break;
    case Gesture::pan:
      move_camera(app, pan(app.scene.camera, double(d.x) / height, double(d.y) / height), shapes);
      break;
    case Gesture::region:
      region = region.moved({double(d.x) / place.screen_width(), double(d.y) / place.screen_height()});
      break;
    case Gesture::wipe:
      app.settings.wipe = std::clamp(double(io.MousePos.x - place.low.x) / place.screen_width(), 0.0, 1.0);
      break;
    default:
      break;
  }
}

// A click, no drag: this pixel is asked about, or the patch in it where hemicubes are looked at.
void ask_about(App& app, const Gesture& g, const Place& place) {
  const glm::dvec2 pixel = place.to_picture(g.start);
  if (choose_patch(app, place, pixel)) return;
  app.probing.at = glm::dvec2(pixel.x / place.width, pixel.y / place.height);
  app.probing.side = g.side;
  app.probing.vertex = -1;
  app.settings.code_in_front = false;  // the numbers stand with the equation
}

void turn_wheel(App& app, Region& region, const Place& place, const Scene& shapes) {
  const ImGuiIO& io = ImGui::GetIO();
  const double notches = std::clamp(double(io.MouseWheel), -10.0, 10.0);
  if (notches == 0 || !std::isfinite(notches)) return;
  if (io.KeyCtrl) {
    const double most =
        std::min(most_magnified, largest_viewport / std::max(place.screen_width(), place.screen_height()));
    region = region.zoomed(std::exp(region_per_notch * notches), place.within(io.MousePos), most);
    return;
  }
  const glm::dvec2 pixel = place.to_picture(io.MousePos);
  const glm::dvec2 at(2 * pixel.x / place.width - 1, 1 - 2 * pixel.y / place.height);
  move_camera(app, zoom(app.scene.camera, std::exp(-zoom_per_notch * notches), at, double(place.width) / place.height),
              shapes);
}

}  // namespace

void move_camera(App& app, const Camera& moved, const Scene& shapes) {
  const Sphere sphere = bounding_sphere(shapes, false);
  Camera& camera = app.scene.camera;
  const bool held = planes_hold(camera, sphere);
  camera = held && !planes_hold(moved, sphere) ? with_planes(moved, sphere) : moved;
}

void take_mouse(App& app, Gesture& gesture, Pointing& pointing, Region& region, const Place& place, int side, bool wipe,
                const Scene& shapes) {
  if (place.empty()) return;
  ImGui::SetCursorScreenPos(place.low);
  ImGui::PushID(side);
  ImGui::InvisibleButton(
      "picture", {place.high.x - place.low.x, place.high.y - place.low.y},
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
  ImGui::PopID();
  note_place(app, "picture", side == 0 ? "left" : "right");
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (hovered) {
    pointing.side = side;
    pointing.pixel = place.to_picture(mouse);
    const double reach = double(app.look.px(grab)) / place.magnification();
    if (app.settings.handles)
      pointing.handle = handle_at(light_handles(app.scene, size_of(place)), pointing.pixel, reach);
    pointing.on_wipe =
        wipe && !pointing.handle && std::abs(mouse.x - wipe_edge(app, place).x) < app.look.px(grab) * 0.7f;
    if (!pointing.handle && !pointing.on_wipe) point_at_patch(app, place, pointing.pixel);
    turn_wheel(app, region, place, shapes);
  }
  if (ImGui::IsItemActivated()) begin(app, gesture, pointing, region, side);
  if (gesture.kind == Gesture::none || gesture.side != side) return;
  if (active) return go_on(app, gesture, region, place, shapes);
  if (gesture.kind == Gesture::orbit && !ImGui::IsMouseDragPastThreshold(0)) ask_about(app, gesture, place);
  gesture.kind = Gesture::none;
}

}  // namespace cg
