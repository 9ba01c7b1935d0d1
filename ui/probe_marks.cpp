// The probed pixel in the pictures: a ring about it, and the letters of its vectors.
#include "ui/probe_marks.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/line_style.h"
#include "ui/panes.h"
#include "workbench/camera_control.h"

namespace cg {

namespace {

void ring(ImDrawList* draw, ImVec2 at, float radius, float unit) {
  draw->AddCircle(at, radius, IM_COL32(0, 0, 0, 170), 24, 3.5f * unit);
  draw->AddCircle(at, radius, IM_COL32(255, 255, 255, 255), 24, 1.6f * unit);
}

// The vertices that were lit, where they can be told apart.
void paint_corners(App& app, const Probe& probe, const PictureProjection& projection,
                   const std::function<ImVec2(const glm::dvec2&)>& to_screen) {
  std::vector<ImVec2> corners;
  for (const LitPoint& v : probe.vertices)
    if (const auto seen = projection.project(v.P)) corners.push_back(to_screen(seen->pixel));
  if (corners.size() != 3) return;
  const auto apart = [&](std::size_t a, std::size_t b) {
    return std::max(std::abs(corners[a].x - corners[b].x), std::abs(corners[a].y - corners[b].y));
  };
  if (std::min({apart(0, 1), apart(1, 2), apart(2, 0)}) < app.look.px(14)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool chosen = int(k) == app.probing.vertex;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddCircleFilled(corners[k], app.look.px(chosen ? 4.5f : 3), IM_COL32(255, 255, 255, 255), 12);
    set_text(draw, app.look.fonts.small, {corners[k].x + app.look.px(6), corners[k].y + app.look.px(14)},
             IM_COL32(255, 255, 255, 230), std::to_string(k + 1));
  }
}

}  // namespace

int probed_light(const App& app, const LitPoint& point) {
  for (const ProbedLight& l : point.lights)
    if (l.light == app.light) return app.light;
  return point.lights.empty() ? -1 : point.lights.front().light;
}

std::vector<ProbedVector> vectors_of(const App& app, const Probe& probe, const Camera& camera, double length) {
  if (!probe.covered || probe.object < 0) return {};
  const LitPoint& point = shown_point(probe, app.probing.vertex);
  return probed_vectors(point, probed_light(app, point), length * axes_of(camera).height);
}

void add_probe_lines(const App& app, const Probed& probed, const Camera& camera, double length,
                     std::vector<Lines>& out) {
  for (Lines& line : vector_lines(vectors_of(app, probed.probe, camera, length))) out.push_back(std::move(line));
  if (Lines triangle = triangle_lines(probed.probe); !triangle.points.empty()) out.push_back(std::move(triangle));
}

void paint_letters(App& app, const std::vector<ProbedVector>& vectors, const PictureProjection& projection,
                   const std::function<ImVec2(const glm::dvec2&)>& to_screen) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Look& look = app.look;
  for (const ProbedVector& v : vectors) {
    const auto foot = projection.project(v.foot), tip = projection.project(v.tip);
    if (!foot || !tip) continue;
    const ImVec2 a = to_screen(foot->pixel), b = to_screen(tip->pixel);
    const float dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    const ImU32 colour = colour_of(v.mark);
    const float size = look.px(8);
    if (length > size) {  // the tip of an arrow that is seen from the side
      const float ux = dx / length, uy = dy / length;
      const ImVec2 tip{b.x + ux * size * 0.4f, b.y + uy * size * 0.4f},
          left{b.x - ux * size - uy * size * 0.4f, b.y - uy * size + ux * size * 0.4f},
          right{b.x - ux * size + uy * size * 0.4f, b.y - uy * size - ux * size * 0.4f};
      draw->AddTriangle(tip, left, right, IM_COL32(0, 0, 0, 150), look.px(2));
      draw->AddTriangleFilled(tip, left, right, colour);
    } else {
      draw->AddCircleFilled(b, look.px(3), colour, 12);
    }
    const float out = look.px(12) / std::max(length, look.px(1));
    const ImVec2 at{b.x + dx * out - look.px(5), b.y + dy * out + look.px(6)};
    for (const ImVec2& aside : {ImVec2{1, 1}, {-1, 1}, {1, -1}, {-1, -1}})
      set_text(draw, look.fonts.bold, {at.x + aside.x, at.y + aside.y}, IM_COL32(0, 0, 0, 190), v.letter);
    set_text(draw, look.fonts.bold, at, colour, v.letter);
  }
}

void Panes::ask_probes(App& app) {
  if (app.peek) {
    for (int side = 0; side < 2; ++side) probed_from_[std::size_t(side)] = jobs_.submitted(side) + 1;
    return;
  }
  std::array<DrawingHandle, 2> drawings;
  std::array<const Technique*, 2> techniques{};
  for (std::size_t side = 0; side < 2; ++side) {
    const int technique = side == 0 ? app.left : app.right;
    techniques[side] = &app.techniques[std::size_t(technique)];
    if (!jobs_.pane(int(side)).message) drawings[side] = on_screen_[side];
    if (drawings[side] && drawings[side]->serial < probed_from_[side]) return;
  }
  probes_.update(app.probing.at, drawings, techniques);
  for (int side = 0; side < 2; ++side) app.probing.results[std::size_t(side)] = probes_.of(side);
}

void Panes::paint_probe(App& app, int side, const Place& place) {
  if (!app.probing.at) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(place.low, place.high, true);
  const glm::ivec2 pixel = pixel_at(*app.probing.at, place.width, place.height);
  const ImVec2 at = place.to_screen(glm::dvec2(pixel) + 0.5);
  ring(draw, at, std::max(app.look.px(6), float(place.magnification()) * 0.8f), app.look.px(1));
  const std::shared_ptr<const Probed>& probed = app.probing.results[std::size_t(side)];
  const DrawingHandle& drawing = on_screen_[std::size_t(side)];
  if (probed && drawing) {
    const Camera& camera = drawing->scene.camera;
    const PictureProjection projection(camera, {place.width, place.height});
    const auto to_screen = [&](const glm::dvec2& p) { return place.to_screen(p); };
    paint_letters(app, vectors_of(app, probed->probe, camera), projection, to_screen);
    paint_corners(app, probed->probe, projection, to_screen);
  }
  draw->PopClipRect();
}

}  // namespace cg
