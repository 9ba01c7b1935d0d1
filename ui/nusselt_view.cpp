// Nusselt's projection drawn: the patch that is seen, its outline on the hemisphere of radius 1, and the shadow of that
// on the base, whose share of the disc is the form factor from the position.
#include <algorithm>
#include <cmath>

#include "math/transform.h"
#include "radiosity/closed_form.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/hemicube_cross.h"
#include "ui/line_style.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr double reach = 1.5;  // of the patch's farthest corner, in radii: nearer or farther its shadow is the same
constexpr int arc_steps = 48;

// The hemisphere from outside, by a parallel projection.
struct Outside {
  ImVec2 centre;
  double radius, azimuth, elevation;  // pixels, radians

  glm::dvec3 turned(const glm::dvec3& p) const {
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    return {p.x * c - p.y * s, p.x * s + p.y * c, p.z};
  }
  ImVec2 at(const glm::dvec3& p) const {
    const glm::dvec3 t = turned(p);
    const double up = t.z * std::cos(elevation) + t.y * std::sin(elevation);
    return {float(double(centre.x) + radius * t.x), float(double(centre.y) - radius * up)};
  }
  bool faces_us(const glm::dvec3& normal) const {
    const glm::dvec3 t = turned(normal);
    return t.z * std::sin(elevation) - t.y * std::cos(elevation) >= 0;
  }
  // The point of the base under a point of the screen.
  glm::dvec2 base(ImVec2 p) const {
    const double x = double(p.x - centre.x) / radius,
                 y = double(centre.y - p.y) / (radius * std::max(std::sin(elevation), 1e-3));
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    return {x * c + y * s, -x * s + y * c};
  }
};

class Painter {
 public:
  Painter(App& app, const Outside& view) : app_(app), view_(view), draw_(ImGui::GetWindowDrawList()) {}

  void line(const glm::dvec3& a, const glm::dvec3& b, ImU32 colour, float width) {
    draw_->AddLine(view_.at(a), view_.at(b), colour, app_.look.px(width));
  }
  // Fainter where the sphere turns away.
  template <class Curve>
  void curve(const Curve& point, ImU32 colour, float width) {
    for (int i = 0; i < arc_steps; ++i) {
      const glm::dvec3 a = point(double(i) / arc_steps), b = point(double(i + 1) / arc_steps);
      line(a, b, view_.faces_us(a + b) ? colour : faded(colour, 0.35f), width);
    }
  }
  void base(const Texture& disc) {
    if (!disc.empty())
      draw_->AddImageQuad(disc.id(), view_.at({-1, 1, 0}), view_.at({1, 1, 0}), view_.at({1, -1, 0}),
                          view_.at({-1, -1, 0}));
    const ImU32 ink = app_.look.palette.dim;
    for (int i = 0; i < 2 * arc_steps; ++i) line(on_base(i), on_base(i + 1), ink, 1.2f);
  }
  void hemisphere() {
    const ImU32 ink = faded(app_.look.palette.dim, 0.55f);
    for (const double height : {30.0, 60.0})
      curve(
          [&](double t) {
            const double a = 2 * pi * t, r = std::cos(radians(height));
            return glm::dvec3(r * std::cos(a), r * std::sin(a), std::sin(radians(height)));
          },
          ink, 1);
    for (int k = 0; k < 6; ++k)
      curve(
          [&](double t) {
            const double a = pi * t, around = pi * k / 6;
            return glm::dvec3(std::cos(a) * std::cos(around), std::cos(a) * std::sin(around), std::sin(a));
          },
          ink, 1);
    draw_->PathArcTo(view_.centre, float(view_.radius), float(-pi), 0, arc_steps);
    draw_->PathStroke(app_.look.palette.dim, 0, app_.look.px(1.2f));
  }
  // The inside of a closed curve of the base, by lines across it.
  void fill(const std::vector<glm::dvec3>& outline, ImU32 colour) {
    constexpr int rows = 70;
    double low = 1, high = -1;
    for (const glm::dvec3& p : outline) low = std::min(low, p.y), high = std::max(high, p.y);
    const double step = (high - low) / rows;
    for (int r = 0; r < rows && step > 0; ++r) {
      const double y = low + (r + 0.5) * step;
      std::vector<double> cuts;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a.y < y) != (b.y < y)) cuts.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
        draw_->AddQuadFilled(view_.at({cuts[i], y - 0.5 * step, 0}), view_.at({cuts[i + 1], y - 0.5 * step, 0}),
                             view_.at({cuts[i + 1], y + 0.5 * step, 0}), view_.at({cuts[i], y + 0.5 * step, 0}),
                             colour);
    }
  }
  void closed(const std::vector<glm::dvec3>& points, ImU32 colour, float width, bool on_sphere) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 &a = points[i], &b = points[(i + 1) % points.size()];
      line(a, b, on_sphere && !view_.faces_us(a + b) ? faded(colour, 0.55f) : colour, width);
    }
  }
  void polygon(const std::vector<glm::dvec3>& corners, ImU32 colour) {
    std::vector<ImVec2> seen;
    for (const glm::dvec3& c : corners) seen.push_back(view_.at(c));
    if (seen.size() < 3) return;
    double area = 0;  // ImGui wants them clockwise on the screen
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const ImVec2 &a = seen[i], &b = seen[(i + 1) % seen.size()];
      area += double(a.x) * double(b.y) - double(b.x) * double(a.y);
    }
    if (area < 0) std::reverse(seen.begin(), seen.end());
    draw_->AddConvexPolyFilled(seen.data(), int(seen.size()), faded(colour, 0.3f));
    draw_->AddPolyline(seen.data(), int(seen.size()), colour, ImDrawFlags_Closed, app_.look.px(1.6f));
  }

 private:
  static glm::dvec3 on_base(int i) {
    const double a = pi * i / arc_steps;
    return {std::cos(a), std::sin(a), 0};
  }
  App& app_;
  const Outside& view_;
  ImDrawList* draw_;
};

// All of it in the hemicube's frame, as the disc is.
std::vector<glm::dvec3> outline_in(const NusseltProjection& shadow, const HemicubeFrame& frame) {
  std::vector<glm::dvec3> out;
  for (const glm::dvec3& p : shadow.outline) {
    const glm::dvec3 world = p.x * shadow.x + p.y * shadow.y;
    out.push_back({glm::dot(world, frame.x), glm::dot(world, frame.y), p.z});
  }
  return out;
}

std::vector<glm::dvec3> patch_in(const HemicubeSight& sight, std::uint32_t patch) {
  const HemicubeFrame& frame = sight.view.frame;
  const Patch& p = sight.ground->patches.patches[patch];
  std::vector<glm::dvec3> out;
  double farthest = 0;
  for (const glm::dvec3& c :
       clipped_to_front(std::span(p.corner.data(), std::size_t(p.corners)), frame.position, frame.z)) {
    const glm::dvec3 d = c - frame.position;
    out.push_back({glm::dot(d, frame.x), glm::dot(d, frame.y), glm::dot(d, frame.z)});
    farthest = std::max(farthest, glm::length(out.back()));
  }
  for (glm::dvec3& c : out) c *= farthest > 0 ? reach / farthest : 0;
  return out;
}

PointedPixel take_mouse(App& app, HemicubeDesk& desk, const Outside& view, ImVec2 low, ImVec2 size) {
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton("nusselt", size);
  note_place(app, "hemicube", "nusselt");
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    desk.azimuth = std::remainder(desk.azimuth + 0.5 * double(io.MouseDelta.x / app.look.scale), 360.0);
    desk.elevation = std::clamp(desk.elevation + 0.5 * double(io.MouseDelta.y / app.look.scale), 4.0, 90.0);
    app.animating = true;
  }
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return {};
  const HemicubeSight& sight = *desk.art.sight;
  const glm::dvec2 p = view.base(io.MousePos);
  const double r2 = glm::dot(p, p);
  if (r2 >= 1) return {};
  const glm::ivec2 pixel = cross_place({p, std::sqrt(1 - r2)}, sight.view.resolution);
  if (const std::uint32_t item = sight.view.items.at(pixel.x, pixel.y); item != no_item) desk.point_at(item);
  return {pixel.x, pixel.y};
}

}  // namespace

PointedPixel draw_nusselt(App& app, HemicubeDesk& desk, float side, float height) {
  Look& look = app.look;
  const HemicubeSight& sight = *desk.art.sight;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const double radius = 0.38 * double(std::min(side, height));
  const Outside view{
      {low.x + 0.5f * side, low.y + 0.72f * height}, radius, radians(desk.azimuth), radians(desk.elevation)};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(low, {low.x + side, low.y + height}, true);
  Painter paint(app, view);
  paint.base(desk.art.picture);
  const ImU32 ink = other_ink(app);
  const HemicubePair* pair = desk.art.pair && desk.art.pair->sight == desk.art.sight ? desk.art.pair.get() : nullptr;
  std::vector<glm::dvec3> outline;
  if (pair) outline = outline_in(pair->shadow, sight.view.frame);
  std::vector<glm::dvec3> shadow = outline;
  for (glm::dvec3& p : shadow) p.z = 0;
  paint.fill(shadow, IM_COL32(0, 0, 0, 90));
  paint.closed(shadow, IM_COL32(0, 0, 0, 200), 3.4f, false);
  paint.closed(shadow, ink, 1.8f, false);
  paint.hemisphere();
  if (pair && !outline.empty()) {
    const std::vector<glm::dvec3> corners = patch_in(sight, pair->other());
    for (const glm::dvec3& c : corners) paint.line({0, 0, 0}, c, faded(ink, 0.45f), 1);
    for (std::size_t i = 0; i < outline.size(); i += std::max<std::size_t>(outline.size() / 16, 1))
      paint.line(outline[i], shadow[i], faded(ink, 0.6f), 1);
    paint.closed(outline, ink, 2.2f, true);
    paint.polygon(corners, ink);
  }
  paint.line({0, 0, 0}, {0, 0, 1.18}, look.palette.text, 1.6f);
  const ImVec2 tip = view.at({0, 0, 1.18});
  set_text(draw, look.fonts.bold, {tip.x + look.px(5), tip.y + look.px(8)}, look.palette.text, "N");
  draw->PopClipRect();
  const PointedPixel out = take_mouse(app, desk, view, low, {side, height});
  ImGui::SetCursorScreenPos({low.x, low.y + height});
  return out;
}

}  // namespace cg
