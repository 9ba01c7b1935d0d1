#include "ui/panes.h"

#include <epoxy/gl.h>

#include "ui/app.h"
#include "ui/layout.h"
#include "ui/pane.h"
#include "ui/radiosity_desk.h"
#include "workbench/camera_control.h"
#include "workbench/isolate.h"

namespace cg {

namespace {

constexpr double turntable_speed = 30;           // degrees a second
constexpr std::size_t many_triangles = 300'000;  // the farthest vertex of so many is not looked for in one frame

bool is_single(ViewMode view) { return view != ViewMode::two; }

// The scene with the meshes that were really drawn, where they are of the same objects.
Scene with_drawn_meshes(Scene scene, const DrawingHandle& drawing) {
  if (!drawing || drawing->scene.objects.size() != scene.objects.size()) return scene;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& drawn = drawing->scene.objects[i];
    Object& object = scene.objects[i];
    if (drawn.model == object.model && drawn.part == object.part && drawn.tessellation == object.tessellation)
      object.mesh = drawn.mesh;
  }
  return scene;
}

std::size_t triangles_of(const Scene& scene) {
  std::size_t count = 0;
  for (const Object& object : scene.objects)
    if (object.mesh) count += object.mesh->triangles().size();
  return count;
}

// A picture in the middle of a rectangle: square, or filling it.
Place placed(ImVec2 low, ImVec2 high, bool square, int largest, const Region& region) {
  Place place;
  place.region = region;
  float w = std::floor(high.x - low.x), h = std::floor(high.y - low.y);
  if (!(w >= 1) || !(h >= 1)) return place;
  if (square) w = h = std::min(w, h);
  place.low = {std::floor(low.x + 0.5f * (high.x - low.x - w)), std::floor(low.y + 0.5f * (high.y - low.y - h))};
  place.high = {place.low.x + w, place.low.y + h};
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  place.width = std::clamp(int(w * scale.x), 1, largest);
  place.height = std::clamp(int(h * scale.y), 1, largest);
  return place;
}

}  // namespace

Panes::Panes(const App& app)
    : jobs_(
          app.techniques, app.wake ? app.wake : [] {}),
      probes_(app.wake) {
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest_);
  largest_ = std::clamp(largest_, 64, 16384);
}

void draw_panes(App& app, ImVec2 size) {
  if (draw_large_trade(app, size) || draw_large_solver(app, size)) return;
  if (!app.panes) app.panes = std::make_shared<Panes>(app);
  app.panes->draw(app, size);
}

void Panes::draw(App& app, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (!(size.x >= 1) || !(size.y >= 1)) return;  // minimised, or squeezed to nothing
  area_ = {at.x, at.x + size.x};
  const std::array<Place, 2> place = places(app, at, size);
  const bool single = is_single(app.settings.view);
  keep_camera(app, place[0].empty() ? 1 : double(place[0].width) / place[0].height);
  pointing_ = {};
  const Scene shapes = with_drawn_meshes(app.scene, on_screen_[0] ? on_screen_[0] : on_screen_[1]);
  for (int side = 0; side < (single ? 1 : 2); ++side)
    take_mouse(app, gesture_, pointing_, region_, place[std::size_t(side)], side, app.settings.view == ViewMode::wipe,
               shapes);
  app.gesture = gesture_.kind != Gesture::none;
  last_camera_ = app.scene.camera;
  const auto start = std::chrono::steady_clock::now();
  submit(app, place[0]);
  take_pictures(app);
  ask_probes(app);
  exchange_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  report(app);

  Place seen = place[0];
  seen.region = region_;
  switch (app.settings.view) {
    case ViewMode::two:
      paint_pane(app, 0, seen);
      seen = place[1];
      seen.region = region_;
      paint_pane(app, 1, seen);
      break;
    case ViewMode::wipe:
      paint_wipe(app, seen);
      break;
    case ViewMode::flip:
      paint_flip(app, seen);
      break;
    case ViewMode::difference:
    case ViewMode::false_colour:
      paint_difference(app, seen);
      break;
  }
  ImGui::SetCursorScreenPos({at.x, at.y + size.y});
}

// The camera follows what is not a mouse: the turntable, "fit", and a projection chosen elsewhere.
void Panes::keep_camera(App& app, double aspect) {
  Camera& camera = app.scene.camera;
  if (last_camera_ && camera.projection != last_camera_->projection) {
    Camera chosen = *last_camera_;
    chosen.projection = camera.projection;
    if (chosen == camera) {  // only the projection was changed: keep the picture's size
      camera = with_projection(*last_camera_, camera.projection);
      const Sphere sphere = bounding_sphere(with_drawn_meshes(app.scene, on_screen_[0]), false);
      if (!planes_hold(camera, sphere)) camera = with_planes(camera, sphere);
    }
  }
  if (app.fit_asked) {
    const Scene shapes = with_drawn_meshes(app.scene, on_screen_[0]);
    camera = fit(camera, bounding_sphere(shapes, triangles_of(shapes) <= many_triangles), aspect);
    app.fit_asked = false;
    region_ = {};
  }
  if (app.turntable && gesture_.kind != Gesture::orbit) {
    camera = turntable(camera, turntable_speed, double(ImGui::GetIO().DeltaTime));
    app.animating = true;
  }
}

// Two beside each other, or one (the second is then empty). A line of text has room below each.
std::array<Place, 2> Panes::places(App& app, ImVec2 at, ImVec2 size) const {
  const float footer = app.look.px(26), gap = app.look.px(8);
  const float low = at.y, high = at.y + size.y - footer;
  const bool square = app.settings.square;
  if (is_single(app.settings.view))
    return {placed({at.x, low}, {at.x + size.x, high}, square, largest_, region_), Place{}};
  const float half = std::floor(0.5f * (size.x - gap));
  return {placed({at.x, low}, {at.x + half, high}, square, largest_, region_),
          placed({at.x + size.x - half, low}, {at.x + size.x, high}, square, largest_, region_)};
}

void Panes::submit(App& app, const Place& place) {
  if (place.empty()) return;
  Request wanted;
  const Isolated& alone = app.peek ? *app.peek : app.isolated;
  wanted.scene = isolated(scene_with_solution(app), alone.term, alone.light);
  wanted.mark_clamped = app.settings.clamped;
  if (wanted.mark_clamped) wanted.scene.shading.clamp = false;
  wanted.view.width = place.width, wanted.view.height = place.height;
  wanted.view.threads = drawing_threads();
  wanted.view.reuse = true;
  const ViewMode view = app.settings.view;
  const bool together = view == ViewMode::difference || view == ViewMode::false_colour;
  jobs_.update(wanted, app.left, app.right, together);
  jobs_.compare(view, app.settings.gain);
  const DrawingHandle& drawn = jobs_.pane(0).drawing ? jobs_.pane(0).drawing : jobs_.pane(1).drawing;
  if (drawn)
    jobs_.outline(drawn->scene, {.edges = app.settings.wireframe,
                                 .face_normals = app.settings.face_normals,
                                 .vertex_normals = app.settings.vertex_normals,
                                 .normal_length = app.settings.normal_length});
  // A stale pass is cancelled by asking, also when no event comes.
  if (jobs_.busy()) app.next_frame = std::min(app.next_frame, app.now + 0.1);
}

void Panes::take_pictures(App& app) {
  for (int side = 0; side < 2; ++side) upload(side);
  if (const auto& compared = jobs_.compared(); compared && compared != shown_difference_) {
    shown_difference_ = compared;
    difference_.upload(compared->picture);
  }
  if (const auto& overlay = jobs_.overlay(); overlay && overlay != kept_lines_) {
    kept_lines_ = overlay;
    renderer_.keep(overlay->lines);
    if (overlay->thinned)
      say(app, Text("The mesh has more lines than can be told apart: only a part of them is drawn",
                    "線が多すぎて見分けられないため、一部だけを描いています"));
  }
}

void Panes::upload(int side) {
  const DrawingHandle& drawing = jobs_.pane(side).drawing;
  DrawingHandle& shown = on_screen_[std::size_t(side)];
  if (!drawing) {
    shown = nullptr;
    return;
  }
  if (drawing == shown) return;
  pictures_[std::size_t(side)].upload(drawing->shown);
  shown = drawing;
}

void Panes::report(App& app) {
  Figures& f = app.figures;
  f.left_ms = jobs_.pane(0).ms, f.right_ms = jobs_.pane(1).ms;
  const auto& compared = jobs_.compared();
  f.valid = compared && jobs_.pictures_match();
  if (f.valid) {
    const Difference& d = compared->difference;
    f.max_error = d.max_error, f.rmse = d.rmse;
    f.coverage_mismatch = long(d.coverage_mismatch), f.over_1_255 = long(d.over_1_255);
  }
  for (int side = 0; side < 2; ++side) app.drawings[side] = jobs_.pane(side).drawing;
}

void Panes::draw_lines(const ImDrawList*, const ImDrawCmd* command) {
  LineCall& call = *static_cast<LineCall*>(command->UserCallbackData);
  Panes& panes = *call.panes;
  const DrawingHandle& drawing = panes.on_screen_[std::size_t(call.side)];
  if (!drawing) return;
  const LineTarget target = line_target(call.place, call.clip);
  Texture& depth = panes.depths_[std::size_t(call.side)];
  if (panes.depth_of_[std::size_t(call.side)] != drawing) {
    depth.upload(drawing->frame.depth);
    panes.depth_of_[std::size_t(call.side)] = drawing;
  }
  panes.renderer_.draw(call.more, drawing->scene.camera, target, depth, call.style);
}

}  // namespace cg
