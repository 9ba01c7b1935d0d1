// The world after the division by w: the clip volume is a cube, and what the camera sees stands in it.
#include <imgui_internal.h>

#include <array>

#include "ui/app.h"
#include "ui/formula.h"
#include "ui/world_marks.h"
#include "ui/world_view.h"
#include "workbench/camera_control.h"
#include "workbench/world_lines.h"

namespace cg {

namespace {

constexpr double zoom_per_notch = 0.15;

void turn(App& app, Camera& camera, const Place& place) {
  ImGui::SetCursorScreenPos(place.low);
  ImGui::InvisibleButton("divided", {place.high.x - place.low.x, place.high.y - place.low.y});
  const ImGuiIO& io = ImGui::GetIO();
  const double height = place.screen_height();
  if (ImGui::IsItemActive()) {
    app.animating = true;
    camera = orbit(camera, -pi * double(io.MouseDelta.x) / height, pi * double(io.MouseDelta.y) / height);
  }
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetItemUsingMouseWheel();
  const double notches = std::clamp(double(io.MouseWheel), -10.0, 10.0);
  if (notches != 0 && std::isfinite(notches))
    camera = with_planes(zoom(camera, std::exp(-zoom_per_notch * notches), {0, 0}, 1), {glm::dvec3(0), 4});
}

}  // namespace

void WorldView::draw_divided(App& app, const Place& place) {
  if (!divided_camera_) {
    Camera camera;
    camera.position = {2.2, 1.7, 3.4};
    divided_camera_ = fit(camera, {glm::dvec3(0), 1.75}, double(place.width) / place.height);
  }
  turn(app, *divided_camera_, place);
  const double aspect = aspect_of(app);
  const DrawingHandle& drawn = app.drawings[0] ? app.drawings[0] : app.drawings[1];
  Scene scene = drawn ? drawn->scene : app.scene;  // its meshes are loaded
  scene.camera = app.scene.camera;
  clip_edges_.update(scene, aspect);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(place.low, place.high, IM_COL32(13, 13, 13, 255));
  call_ = {this, place, {}, {clip_cube()}, app.look.scale, *divided_camera_, true};
  if (const auto edges = clip_edges_.newest(); edges != kept_edges_ && edges) {
    kept_edges_ = edges;
    divided_renderer_.keep({*edges});
  }
  add_line_call(place);
  const PictureProjection projection(*divided_camera_, {place.width, place.height});
  const auto to_screen = [&](const glm::dvec3& point) {
    const auto seen = projection.project(point);
    return seen ? place.to_screen(seen->pixel) : ImVec2(-1e4f, -1e4f);
  };
  draw->PushClipRect(place.low, place.high, true);
  constexpr Words near_word{"near, z = −1", "前方面 z = −1"}, far_word{"far, z = +1", "後方面 z = +1"};
  mark_word(app, to_screen({-1, 1, 1}), near_word.in(app.language()));
  mark_word(app, to_screen({-1, 1, -1}), far_word.in(app.language()));
  if (const Probed* probed = shown_probed(app); probed && probed->probe.covered && probed->probe.object >= 0)
    if (const auto at = after_division(app.scene.camera, aspect, probed->probe.here.P))
      mark_knob(app, to_screen(*at), app.look.px(5), true, false);
  draw->PopClipRect();
}

}  // namespace cg
