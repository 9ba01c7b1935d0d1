// How the scene looks from outside: the shaded mesh, lines over it, and the handles on them.
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/line_style.h"
#include "ui/panes.h"
#include "ui/probe_marks.h"
#include "ui/widgets.h"
#include "ui/world_marks.h"
#include "ui/world_view.h"
#include "workbench/world_lines.h"

namespace cg {

namespace {

// The camera as the drawing of lights needs it: this one's axes, about the scene's target.
Camera about_target(Camera camera, const glm::dvec3& target) {
  camera.position += target - camera.target;
  camera.target = target;
  return camera;
}

constexpr double vector_length = 0.12;

constexpr ImU32 white = IM_COL32(255, 255, 255, 255), dark = IM_COL32(0, 0, 0, 150);

}  // namespace

// Width / height of the pictures that the scene's camera makes.
double aspect_of(const App& app) {
  for (const DrawingHandle& drawing : app.drawings)
    if (drawing && drawing->view.height > 0) return double(drawing->view.width) / drawing->view.height;
  return 1;
}

const Probed* shown_probed(const App& app) {
  const auto& results = app.probing.results;
  const auto& best = results[std::size_t(app.probing.side)] ? results[std::size_t(app.probing.side)]
                                                            : results[std::size_t(1 - app.probing.side)];
  return app.probing.at ? best.get() : nullptr;
}

void mark_word(App& app, ImVec2 at, std::string_view text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  set_text(draw, app.look.fonts.small, {at.x + 1, at.y + 1}, IM_COL32(0, 0, 0, 220), noted(app, text));
  set_text(draw, app.look.fonts.small, at, IM_COL32(235, 238, 245, 255), text);
}

void mark_knob(App& app, ImVec2 at, float radius, bool full, bool held) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddCircle(at, radius + app.look.px(1.5f), dark, 20, app.look.px(3));
  if (full) draw->AddCircleFilled(at, 0.55f * radius, white, 16);
  draw->AddCircle(at, radius, white, 20, app.look.px(held ? 2.5f : 1.4f));
}

void WorldView::paint(App& app, const Place& place) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (picture_.empty())
    draw->AddRectFilled(place.low, place.high, app.look.palette.pane);
  else
    draw->AddImage(picture_.id(), place.low, place.high);
  if (!shown_) return;
  paint_lines(app, place);
  draw->PushClipRect(place.low, place.high, true);
  paint_marks(app, place);
  draw->PopClipRect();
}

void WorldView::paint_lines(App& app, const Place& place) {
  const Scene& scene = app.scene;
  const Camera& camera = shown_->scene.camera;
  call_ = {this, place, {}, {}, app.look.scale, camera, false};
  std::vector<Lines>& lines = call_.lines;
  const double size = handle_sphere_radius(camera, {place.width, place.height});
  lines = camera_lines(scene.camera, aspect_of(app), 0.14 * size);
  for (Lines& axis : axis_lines(0.5 * size)) lines.push_back(std::move(axis));
  const Camera lights_seen_by = about_target(camera, scene.camera.target);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].enabled)
      lines.push_back(light_lines(scene.lights[i], int(i) == app.light, lights_seen_by, size));
  if (const Probed* probed = shown_probed(app)) add_probe_lines(app, *probed, camera, vector_length, lines);
  add_line_call(place);
}

void WorldView::add_line_call(const Place& place) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const ImVec2 low = draw->GetClipRectMin(), high = draw->GetClipRectMax();
  call_.clip = {low.x, low.y, high.x, high.y};
  draw->AddCallback(&WorldView::draw_lines, &call_);
  draw->AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  draw->PopClipRect();
}

void WorldView::draw_lines(const ImDrawList*, const ImDrawCmd* command) {
  LineCall& call = *static_cast<LineCall*>(command->UserCallbackData);
  WorldView& view = *call.view;
  const LineTarget target = line_target(call.place, call.clip);
  const auto style = [&](Mark mark) { return style_of(call.scale, mark); };
  if (call.divided) return view.divided_renderer_.draw(call.lines, call.camera, target, Texture(), style);
  if (view.depth_of_ != view.shown_) {
    view.depth_.upload(view.shown_->frame.depth);
    view.depth_of_ = view.shown_;
  }
  view.renderer_.draw(call.lines, call.camera, target, view.depth_, style);
}

void WorldView::paint_marks(App& app, const Place& place) {
  Look& look = app.look;
  const Camera& camera = shown_->scene.camera;
  const PictureProjection projection(camera, {place.width, place.height});
  const auto to_screen = [&](const glm::dvec2& pixel) { return place.to_screen(pixel); };
  Scene seen = app.scene;
  seen.camera = camera;
  for (const Handle& h : light_handles(seen, {place.width, place.height})) {
    const bool held = (grab_.kind == Grab::light ? grab_.handle.light == h.light && grab_.handle.grip == h.grip
                                                 : pointed_ && pointed_->light == h.light && pointed_->grip == h.grip);
    const ImVec2 at = to_screen(h.pixel);
    mark_knob(app, at, look.px(h.grip == Grip::aim ? 3.5f : 5), h.grip != Grip::aim, held || h.light == app.light);
    if (h.grip != Grip::aim) mark_word(app, {at.x + look.px(9), at.y + look.px(5)}, std::to_string(h.light));
  }
  for (const Grab::Kind end : {Grab::eye, Grab::target})
    if (const auto p = projection.project(end == Grab::eye ? app.scene.camera.position : app.scene.camera.target))
      mark_knob(app, to_screen(p->pixel), look.px(4), end == Grab::eye, grab_.kind == end || pointed_end_ == end);
  const auto volume = view_volume(app.scene.camera, aspect_of(app));
  constexpr Words near_word{"near", "前方面"}, far_word{"far", "後方面"};
  for (const auto& [corner, name] : {std::pair{std::size_t(3), near_word}, {std::size_t(7), far_word}})
    if (const auto p = projection.project(volume[corner])) {
      const ImVec2 at = to_screen(p->pixel);
      mark_word(app, {at.x + look.px(4), at.y - look.px(4)}, name.in(app.language()));
    }
  if (const Probed* probed = shown_probed(app))
    paint_letters(app, vectors_of(app, probed->probe, camera, vector_length), projection, to_screen);
  if (pointed_ || pointed_end_ != Grab::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  constexpr Words eye_tip{"Drag: the scene's camera", "ドラッグでシーンのカメラを動かす"},
      target_tip{"Drag: the point that it looks at", "ドラッグで注視点を動かす"};
  if (grab_.kind == Grab::none && pointed_end_ != Grab::none && wants_tooltip(app))
    tooltip(app, {}, noted(app, pointed_end_ == Grab::eye ? eye_tip : target_tip), {});
}

}  // namespace cg
