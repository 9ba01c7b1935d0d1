#include "mapping/uv_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

namespace cg {

namespace {

bool before(const glm::dvec2& a, const glm::dvec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Left of the edge from a to b; computed alike from both sides of it, and a point on it is on one side only.
bool left_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return before(a, b) ? cross(a, b, p) >= 0 : cross(b, a, p) < 0;
}

void cover(std::array<glm::dvec2, 3> t, int size, std::vector<std::uint8_t>& counts) {
  if (cross(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
  const glm::dvec2 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  const auto index = [&](double x) { return int(std::clamp(x, 0.0, double(size))); };
  for (int y = index(std::floor(low.y - 0.5)); y < index(std::ceil(high.y + 0.5)); ++y)
    for (int x = index(std::floor(low.x - 0.5)); x < index(std::ceil(high.x + 0.5)); ++x) {
      const glm::dvec2 p{x + 0.5, y + 0.5};
      if (left_of(t[0], t[1], p) && left_of(t[1], t[2], p) && left_of(t[2], t[0], p)) {
        std::uint8_t& count = counts[std::size_t(y) * std::size_t(size) + std::size_t(x)];
        count = std::uint8_t(std::min(255, count + 1));
      }
    }
}

}  // namespace

EdgeCuts layout_cuts(const UvLayout& layout, const UnwrapSurface& surface) {
  EdgeCuts cuts = border_cuts(surface);
  for (std::uint32_t c = 0; c < cuts.size(); ++c)
    if (!cuts[c])
      cuts[c] = layout.uv[c] != layout.uv[surface.next(surface.across(c))] ||
                layout.uv[surface.next(c)] != layout.uv[surface.across(c)];
  return cuts;
}

UvLayout make_layout(MeshHandle mesh, CornerUv uv) {
  UvLayout out{std::move(mesh), std::move(uv), {}, 0};
  const UnwrapSurface surface(out.mesh, "");
  ChartFaces charts = charts_between(surface, layout_cuts(out, surface));
  out.chart = std::move(charts.chart_of), out.charts = std::uint32_t(charts.faces.size());
  return out;
}

std::vector<SeamEdge> seams_of(const UvLayout& layout) {
  const UnwrapSurface surface(layout.mesh, "");
  return seams_of(surface, layout_cuts(layout, surface));
}

std::vector<Stretch> stretches_of(const UvLayout& layout) {
  const Mesh& mesh = *layout.mesh;
  const glm::dvec3 half = mesh.high() * 0.5 - mesh.low() * 0.5;
  const double extent = std::max({half.x, half.y, half.z}), to_unit = extent > 0 ? std::min(1 / extent, 1e300) : 1;
  const auto point = [&](std::uint32_t c) {
    return (mesh.data().positions[mesh.data().corners[c].position] * 0.5 - mesh.centre() * 0.5) * to_unit;
  };
  std::vector<Stretch> out;
  out.reserve(mesh.triangles().size());
  for (const Triangle& t : mesh.triangles()) {
    const auto& [a, b, c] = t.corner;
    out.push_back(stretch_of(lay_flat(point(a), point(b), point(c)), layout.uv[a], layout.uv[b], layout.uv[c]));
  }
  return out;
}

std::vector<std::uint8_t> coverage_of(const UvLayout& layout, int size) {
  std::vector<std::uint8_t> counts(std::size_t(size) * std::size_t(size));
  for (const Triangle& t : layout.mesh->triangles())
    cover({layout.uv[t.corner[0]] * double(size), layout.uv[t.corner[1]] * double(size),
           layout.uv[t.corner[2]] * double(size)},
          size, counts);
  return counts;
}

LayoutFigures figures_of(const UvLayout& layout, int size) {
  LayoutFigures out;
  for (const Stretch& s : stretches_of(layout)) out.distortion.add(s);
  const std::vector<std::uint8_t> counts = coverage_of(layout, size);
  out.pixels = counts.size();
  for (const std::uint8_t n : counts) out.covered_pixels += n > 0, out.overlapping_pixels += n > 1;
  return out;
}

}  // namespace cg
