#include "ui/world_view.h"

#include <imgui_internal.h>

#include "ui/app.h"
#include "ui/pane_gestures.h"
#include "ui/radiosity_desk.h"
#include "workbench/camera_control.h"
#include "workbench/isolate.h"
#include "workbench/model_library.h"
#include "workbench/world_lines.h"

namespace cg {

namespace {

constexpr float grab_radius = 11;  // units
constexpr double zoom_per_notch = 0.15;

glm::dvec2 size_of(const Place& place) { return {place.width, place.height}; }

// The scene as it is drawn for this view: what depends on where one looks from, the highlight, is left out.
Scene matt(Scene scene) {
  const auto edit = [](Material& m) { m.k_s = glm::dvec3(0); };
  edit(scene.material);
  for (Object& object : scene.objects) edit(object.material);
  scene.shading.precision = Precision::single_precision;
  scene.shading.two_sided = true;
  scene.mistakes = {};
  scene.display.background = glm::dvec3(0.05);
  return scene;
}

}  // namespace

WorldView::WorldView(const App& app) : clip_edges_(app.wake) {
  for (const Technique& technique : app.techniques) {
    if (technique.id != "software") continue;
    Job::Hooks hooks;
    hooks.prepare = [](Scene& scene) { load_meshes(scene); };
    hooks.wake = app.wake;
    job_ = std::make_unique<Job>(technique, std::move(hooks));
  }
}

Scene WorldView::seen_from_here(const App& app) const {
  Scene scene = app.scene;
  scene.camera = *camera_;
  return scene;
}

void WorldView::draw(App& app, ImVec2 size, bool divided) {
  if (!(size.x >= 1) || !(size.y >= 1)) return;
  Place place;
  place.low = ImGui::GetCursorScreenPos();
  place.high = {place.low.x + std::floor(size.x), place.low.y + std::floor(size.y)};
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  place.width = std::clamp(int(size.x * scale.x), 1, 4096), place.height = std::clamp(int(size.y * scale.y), 1, 4096);
  if (divided) {
    draw_divided(app, place);
    return ImGui::SetCursorScreenPos({place.low.x, place.high.y});
  }
  if (!camera_) camera_ = outside_camera(app.scene, double(place.width) / place.height);
  take_mouse(app, place);
  // The planes of this view hold the scene and its camera.
  Sphere all = bounding_sphere(app.scene, false);
  all.radius += glm::distance(all.centre, app.scene.camera.position);
  if (!planes_hold(*camera_, all)) camera_ = with_planes(*camera_, all);
  submit(app, place);
  paint(app, place);
  ImGui::SetCursorScreenPos({place.low.x, place.high.y});
}

void WorldView::submit(App& app, const Place& place) {
  if (!job_) return;
  Request wanted;
  wanted.scene = matt(isolated(scene_with_solution(app), app.isolated.term, app.isolated.light));
  wanted.scene.camera = *camera_;
  wanted.view.width = place.width, wanted.view.height = place.height;
  wanted.view.threads = drawing_threads();
  if (!has_asked_ || !(asked_.view == wanted.view) || !(asked_.scene == wanted.scene)) {
    asked_ = wanted, has_asked_ = true;
    job_->submit(std::move(wanted));
  }
  const Job::State state = job_->poll();
  if (state.busy) app.next_frame = std::min(app.next_frame, app.now + 0.1);
  if (state.drawing && state.drawing != shown_) {
    shown_ = state.drawing;
    picture_.upload(shown_->shown);
  }
}

void WorldView::take_mouse(App& app, const Place& place) {
  ImGui::SetCursorScreenPos(place.low);
  ImGui::InvisibleButton(
      "world", {place.high.x - place.low.x, place.high.y - place.low.y},
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  pointed_.reset(), pointed_end_ = Grab::none;
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered) {
    const glm::dvec2 mouse = place.to_picture(io.MousePos);
    const double reach = double(app.look.px(grab_radius)) / place.magnification();
    pointed_ = handle_at(light_handles(seen_from_here(app), size_of(place)), mouse, reach);
    const PictureProjection projection(*camera_, size_of(place));
    const auto near_it = [&](const glm::dvec3& point) {
      const auto seen = projection.project(point);
      return seen && glm::distance(seen->pixel, mouse) < reach;
    };
    if (!pointed_ && near_it(app.scene.camera.position)) pointed_end_ = Grab::eye;
    if (!pointed_ && pointed_end_ == Grab::none && near_it(app.scene.camera.target)) pointed_end_ = Grab::target;
    ImGui::SetItemUsingMouseWheel();
    if (const double notches = std::clamp(double(io.MouseWheel), -10.0, 10.0); notches != 0 && std::isfinite(notches)) {
      const glm::dvec2 at(2 * mouse.x / place.width - 1, 1 - 2 * mouse.y / place.height);
      camera_ = zoom(*camera_, std::exp(-zoom_per_notch * notches), at, double(place.width) / place.height);
    }
    if (ImGui::IsMouseDoubleClicked(0) && !pointed_ && pointed_end_ == Grab::none)
      camera_ = outside_camera(app.scene, double(place.width) / place.height);
  }
  if (ImGui::IsItemActivated()) begin(app, place);
  if (grab_.kind == Grab::none) return;
  if (active)
    go_on(app, place);
  else
    grab_.kind = Grab::none;
}

void WorldView::begin(App& app, const Place& place) {
  const ImGuiIO& io = ImGui::GetIO();
  grab_ = {};
  grab_.start = io.MousePos;
  const bool left = ImGui::IsMouseClicked(0);
  if (left && pointed_) {
    grab_.kind = Grab::light;
    grab_.handle = *pointed_;
    grab_.before = app.scene.lights[std::size_t(pointed_->light)];
    app.light = pointed_->light;
  } else if (left && pointed_end_ != Grab::none) {
    grab_.kind = pointed_end_;
    grab_.point = pointed_end_ == Grab::eye ? app.scene.camera.position : app.scene.camera.target;
  } else {
    grab_.kind = left && !io.KeyShift ? Grab::orbit : Grab::pan;
  }
  (void)place;
}

void WorldView::go_on(App& app, const Place& place) {
  const ImGuiIO& io = ImGui::GetIO();
  app.animating = true;
  const double height = place.screen_height();
  const ImVec2 d = io.MouseDelta;
  switch (grab_.kind) {
    case Grab::orbit:
      camera_ = orbit(*camera_, -pi * double(d.x) / height, pi * double(d.y) / height);
      break;
    case Grab::pan:
      camera_ = pan(*camera_, double(d.x) / height, double(d.y) / height);
      break;
    case Grab::light: {
      app.gesture = true;
      if (grab_.handle.light >= int(app.scene.lights.size())) break;
      const glm::dvec2 moved = place.to_picture(io.MousePos) - place.to_picture(grab_.start);
      app.scene.lights[std::size_t(grab_.handle.light)] =
          dragged(grab_.before, grab_.handle, *camera_, size_of(place), moved, io.KeyShift);
      break;
    }
    case Grab::eye:
    case Grab::target:
      app.gesture = true;
      drag_camera(app, place);
      break;
    case Grab::none:
      break;
  }
}

// An end of the scene's camera, in the plane parallel to the screen.
void WorldView::drag_camera(App& app, const Place& place) {
  const PictureProjection projection(*camera_, size_of(place));
  const auto seen = projection.project(grab_.point);
  if (!seen) return;
  const glm::dvec2 moved = place.to_picture(ImGui::GetIO().MousePos) - place.to_picture(grab_.start);
  if (moved == glm::dvec2(0)) return;
  const glm::dvec3 point = projection.unproject(seen->pixel + moved, seen->depth);
  Camera camera = app.scene.camera;
  (grab_.kind == Grab::eye ? camera.position : camera.target) = point;
  if (is_finite(point) && glm::distance(camera.position, camera.target) > 1e-6) move_camera(app, camera, app.scene);
}

}  // namespace cg
