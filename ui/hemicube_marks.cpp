#include "ui/hemicube_marks.h"

#include "ui/app.h"
#include "ui/hemicube_desk.h"
#include "workbench/patch_lines.h"
#include "workbench/picking.h"

namespace cg {
namespace {

constexpr int hatch_lines = 14;

HemicubeDesk* open_desk(const App& app) {
  const bool open = app.settings.side == Side::hemicube && app.hemicube;
  return open && app.hemicube->state().ground && app.hemicube->current() ? app.hemicube.get() : nullptr;
}

void add(Lines& lines, const glm::dvec3& a, const glm::dvec3& b) {
  lines.points.push_back(glm::vec3(a - lines.origin)), lines.points.push_back(glm::vec3(b - lines.origin));
}

// Lines across the patch, so that what stands before it hides them.
Lines hatch(const Patch& p) {
  Lines lines{Mark::other_fill, p.centre, {}};
  const glm::dvec3 &a = p.corner[0], &b = p.corner[1], &c = p.corner[2], &d = p.corner[p.corners == 4 ? 3 : 2];
  for (int k = 1; k < hatch_lines; ++k) {
    const double t = double(k) / hatch_lines;
    add(lines, a + t * (b - a), d + t * (c - d));
  }
  return lines;
}

std::optional<std::uint32_t> patch_at(const App& app, const Place& place, const glm::dvec2& pixel) {
  const HemicubeDesk* desk = open_desk(app);
  if (!desk || pixel.x < 0 || pixel.y < 0 || pixel.x >= place.width || pixel.y >= place.height) return std::nullopt;
  const PictureProjection::Ray ray = PictureProjection(app.scene.camera, {place.width, place.height}).ray(pixel);
  return desk->state().ground->met(ray.origin, ray.direction);
}

}  // namespace

std::vector<Lines> hemicube_lines(const App& app) {
  const HemicubeDesk* desk = open_desk(app);
  if (!desk) return {};
  const auto& all = desk->state().ground->patches.patches;
  std::vector<Lines> out;
  const auto mark = [&](std::uint32_t number, Mark which) -> const Patch* {
    if (number >= all.size()) return nullptr;
    out.push_back(patch_lines(all[number], Mark::vector_edge));
    out.push_back(patch_lines(all[number], which));
    return &all[number];
  };
  const std::uint32_t own = std::uint32_t(app.settings.patch), item = desk->item(app.settings);
  if (const std::uint32_t other = item & ~from_behind; item != no_item && other != own)
    if (const Patch* p = mark(other, Mark::other_patch)) out.push_back(hatch(*p));
  const Patch* p = mark(own, Mark::patch);
  if (!p) return out;
  // The normal, from where the hemicube stands.
  const std::shared_ptr<const HemicubeSight>& sight = desk->state().sight;
  const bool shown = sight && sight->ground == desk->state().ground && sight->patch == own;
  const glm::dvec3 from = shown ? sight->view.frame.position : p->centre;
  for (const Mark which : {Mark::vector_edge, Mark::patch}) {
    Lines normal{which, p->centre, {}};
    add(normal, from, from + 0.4 * std::sqrt(p->area) * p->normal);
    out.push_back(std::move(normal));
  }
  return out;
}

bool choose_patch(App& app, const Place& place, const glm::dvec2& pixel) {
  if (!open_desk(app)) return false;
  if (const auto patch = patch_at(app, place, pixel)) app.settings.patch = int(*patch);
  return true;
}

void point_at_patch(App& app, const Place& place, const glm::dvec2& pixel) {
  const auto patch = patch_at(app, place, pixel);
  if (patch && int(*patch) != app.settings.patch) app.hemicube->point_at(*patch);
}

}  // namespace cg
