#include "ui/hemicube_cross.h"

#include <algorithm>
#include <cmath>

#include "image/ramp.h"
#include "radiosity/sample_positions.h"
#include "ui/app.h"
#include "ui/formula.h"
#include "ui/hemicube_figures.h"
#include "ui/line_style.h"
#include "ui/widgets.h"

namespace cg {
namespace {

constexpr std::size_t most_edges = 8000;

// The cross on the screen: pixels of the hemicube, from its upper left corner, to pixels of the screen and back.
struct Cross {
  ImVec2 low;
  float side;
  int resolution;

  ImVec2 at(double x, double y) const {
    const double s = double(side) / (2 * resolution);
    return {float(double(low.x) + x * s), float(double(low.y) + y * s)};
  }
  std::optional<glm::ivec2> pixel(ImVec2 p) const {
    const double s = 2 * resolution / double(side);
    const int x = int(std::floor(double(p.x - low.x) * s)), y = int(std::floor(double(p.y - low.y) * s));
    if (x < 0 || y < 0 || x >= 2 * resolution || y >= 2 * resolution || !cross_pixel(x, y, resolution))
      return std::nullopt;
    return glm::ivec2(x, y);
  }
  double pixel_size() const { return double(side) / (2 * resolution); }
};

void paint_faces(App& app, HemicubeDesk& desk, const Cross& cross) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high{cross.low.x + cross.side, cross.low.y + cross.side};
  HemicubeArt& art = desk.art;
  if (!art.picture.empty()) draw->AddImage(art.picture.id(), cross.low, high);
  const bool marks = art.pair && art.pair->sight == art.sight && !art.others.empty() && desk.pointed() != no_item;
  if (marks) draw->AddImage(art.others.id(), cross.low, high);
  // The five faces stand apart.
  const float a = 0.25f * cross.side, b = 0.75f * cross.side, gap = look.px(1);
  for (const float t : {a, b}) {
    draw->AddRectFilled({cross.low.x + t - gap, cross.low.y}, {cross.low.x + t + gap, high.y}, look.palette.panel);
    draw->AddRectFilled({cross.low.x, cross.low.y + t - gap}, {high.x, cross.low.y + t + gap}, look.palette.panel);
  }
}

void paint_outline(App& app, const Cross& cross, const HemicubePair& pair) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const std::size_t count = std::min(pair.outline.size(), most_edges);
  for (const auto& [colour, width] : {std::pair{IM_COL32(0, 0, 0, 170), 3.4f}, {other_patch_colour, 1.6f}})
    for (std::size_t i = 0; i < count; ++i) {
      const PixelEdge& e = pair.outline[i];
      draw->AddLine(cross.at(e.x0, e.y0), cross.at(e.x1, e.y1), colour, app.look.px(width));
    }
}

void paint_pointed(App& app, const Cross& cross, const glm::ivec2& pixel) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const double grow = std::max(0.0, 0.5 * (double(app.look.px(5)) / cross.pixel_size() - 1));
  const ImVec2 a = cross.at(pixel.x - grow, pixel.y - grow), b = cross.at(pixel.x + 1 + grow, pixel.y + 1 + grow);
  draw->AddRect(a, b, IM_COL32(0, 0, 0, 220), 0, 0, app.look.px(3.5f));
  draw->AddRect(a, b, on_picture, 0, 0, app.look.px(1.5f));
}

// A word in a corner of the cross, where no face is.
void corner_text(App& app, ImVec2 at, float width, ImFont* font, ImU32 colour, std::string_view text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect({at.x, at.y - app.look.px(18)}, {at.x + width, at.y + app.look.px(8)}, true);
  set_text(draw, font, at, colour, text, fitting_scale(font, noted(app, text), width));
  draw->PopClipRect();
}

// Where the patch's hemicubes stand, in the frame of the cross; one is chosen by the mouse.
void draw_positions(App& app, const HemicubeSight& sight, ImVec2 low, float side) {
  Look& look = app.look;
  const Patch& patch = sight.ground->patches.patches[sight.patch];
  const HemicubeFrame& frame = sight.view.frame;
  std::vector<glm::dvec2> corners;
  glm::dvec2 least(1e300), most(-1e300);
  const auto flat = [&](const glm::dvec3& p) {
    const glm::dvec3 d = p - patch.centre;
    return glm::dvec2(glm::dot(d, frame.x), -glm::dot(d, frame.y));
  };
  for (int k = 0; k < patch.corners; ++k) {
    corners.push_back(flat(patch.corner[std::size_t(k)]));
    least = glm::min(least, corners.back()), most = glm::max(most, corners.back());
  }
  const double extent = std::max({most.x - least.x, most.y - least.y, 1e-300});
  const glm::dvec2 middle = 0.5 * (least + most);
  const auto at = [&](const glm::dvec2& p) {
    const glm::dvec2 q = (p - middle) * (double(side) / extent);
    return ImVec2(low.x + 0.5f * side + float(q.x), low.y + 0.5f * side + float(q.y));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::vector<ImVec2> outline;
  for (const glm::dvec2& c : corners) outline.push_back(at(c));
  draw->AddPolyline(outline.data(), int(outline.size()), look.palette.dim, ImDrawFlags_Closed, look.px(1));
  const std::vector<SamplePosition> all = sample_positions(patch, sight.options.samples, sight.options.placement);
  const float radius = std::clamp(0.3f * side / float(sight.options.samples), look.px(1), look.px(3));
  std::size_t nearest = 0;
  float least_distance = 1e30f;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ImVec2 p = at(flat(all[i].position));
    const bool chosen = i == sight.position;
    draw->AddCircleFilled(p, chosen ? 1.6f * radius : radius, chosen ? look.palette.text : look.palette.dim, 12);
    const float d = std::hypot(p.x - mouse.x, p.y - mouse.y);
    if (d < least_distance) least_distance = d, nearest = i;
  }
  if (all.size() < 2) return;
  const float margin = look.px(4);
  ImGui::SetCursorScreenPos({low.x - margin, low.y - margin});
  ImGui::InvisibleButton("positions", {side + 2 * margin, side + 2 * margin});
  note_place(app, "hemicube", "positions");
  if (ImGui::IsItemActive()) app.settings.position = int(nearest);
  if (wants_tooltip(app))
    tooltip(app, {},
            Words{"The patch and its S × S positions. Click one: the cross is seen from there.",
                  "パッチと S × S 個の位置。クリックした位置から見た展開図になる。"}
                .in(app.language()),
            {});
}

// The colours of the weights.
void draw_scale(App& app, const HemicubeSight& sight, ImVec2 low, float side) {
  Look& look = app.look;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float width = look.px(10);
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i) {
    const glm::u8vec4 c = ramp(1 - (i + 0.5) / steps);
    draw->AddRectFilled({low.x, low.y + side * float(i) / steps}, {low.x + width, low.y + side * float(i + 1) / steps},
                        IM_COL32(c.r, c.g, c.b, 255));
  }
  const float x = low.x + width + look.px(4);
  corner_text(app, {x, low.y + look.px(10)}, side, look.fonts.small_mono, look.palette.dim,
              short_number(largest_delta_form_factor(sight.view.resolution), 7));
  corner_text(app, {x, low.y + side}, side, look.fonts.small_mono, look.palette.dim, "0");
}

void draw_corners(App& app, HemicubeDesk& desk, const Cross& cross, const HemicubeSight& sight) {
  Look& look = app.look;
  const Language l = app.language();
  const float quarter = 0.25f * cross.side, far = cross.low.x + 0.75f * cross.side + look.px(8);
  const float width = quarter - look.px(8), top = cross.low.y + look.px(14);
  const auto name = [&](float x, std::string_view letter, std::uint32_t patch, ImU32 ink) {
    const auto& objects = app.scene.objects;
    const std::uint32_t object = sight.ground->patches.patches[patch].object;
    const float w =
        typeset(ImGui::GetWindowDrawList(), {look.fonts.math, look.fonts.math_sub}, {x, top}, ink, noted(app, letter));
    corner_text(app, {x + w + look.px(6), top}, width - w, look.fonts.mono, ink, std::to_string(patch));
    if (object < objects.size())
      corner_text(app, {x, top + look.px(19)}, width, look.fonts.small, look.palette.dim, objects[object].name);
  };
  name(cross.low.x, "i", sight.patch, own_ink(app));
  if (desk.art.pair && desk.art.pair->sight == desk.art.sight) name(far, "j", desk.art.pair->other(), other_ink(app));
  const float box = quarter - look.px(20), bottom = cross.low.y + cross.side - box - look.px(4);
  draw_positions(app, sight, {cross.low.x + look.px(4), bottom}, box);
  if (sight.show == HemicubeShow::weights) draw_scale(app, sight, {far, bottom}, box);
  if (sight.show == HemicubeShow::seen) {
    const Words what = sight.solved ? Words{"solved", "解いた光"} : Words{"material", "素材の色"};
    corner_text(app, {far, bottom + box}, width, look.fonts.small, look.palette.dim, what.in(l));
  }
}

}  // namespace

// On white darker, as the quantities of the same colours.
ImU32 own_ink(const App& app) { return app.look.of(Quantity::specular); }
ImU32 other_ink(const App& app) { return app.look.of(Quantity::ambient); }

std::string patch_name(const App& app, const HemicubeGround& ground, std::uint32_t patch) {
  const std::uint32_t object = ground.patches.patches[patch].object;
  std::string out = std::to_string(patch);
  if (object < app.scene.objects.size() && !app.scene.objects[object].name.empty())
    out += " " + app.scene.objects[object].name;
  return out;
}

PointedPixel draw_hemicube_cross(App& app, HemicubeDesk& desk, float side) {
  const HemicubeSight& sight = *desk.art.sight;
  const Cross cross{ImGui::GetCursorScreenPos(), side, sight.view.resolution};
  paint_faces(app, desk, cross);
  draw_corners(app, desk, cross, sight);
  ImGui::SetCursorScreenPos(cross.low);
  ImGui::InvisibleButton("cross", {side, side});
  note_place(app, "hemicube", "cross");
  PointedPixel out;
  if (ImGui::IsItemHovered())
    if (const auto pixel = cross.pixel(ImGui::GetIO().MousePos)) {
      out = {pixel->x, pixel->y};
      const std::uint32_t item = sight.view.items.at(pixel->x, pixel->y);
      if (item != no_item) {
        desk.point_at(item);
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        const int patch = int(item & ~from_behind);
        if (ImGui::IsMouseDoubleClicked(0))
          app.settings.patch = patch, app.settings.other_patch = -1;
        else if (ImGui::IsItemActivated())
          app.settings.other_patch = app.settings.other_patch == patch ? -1 : patch;
      }
    }
  if (desk.art.pair && desk.art.pair->sight == desk.art.sight) paint_outline(app, cross, *desk.art.pair);
  if (out.x >= 0) paint_pointed(app, cross, {out.x, out.y});
  ImGui::SetCursorScreenPos({cross.low.x, cross.low.y + side});
  return out;
}

}  // namespace cg
