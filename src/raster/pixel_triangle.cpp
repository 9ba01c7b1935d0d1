#include "raster/pixel_triangle.h"

#include "raster/visibility.h"

namespace cg {

namespace {

// How deep inside a visible triangle the pixel lies: its smallest weight.
double depth_inside(const DrawnObject& object, std::uint32_t id, int x, int y) {
  const glm::dvec3 w = TriangleWeights<double>(object.window(id)).at(x, y);
  return std::min({w.x, w.y, w.z});
}

}  // namespace

std::optional<PixelTriangle> triangle_at(const Scene& scene, const View& view, int x, int y, Progress& progress) {
  Workers workers(view.threads, progress);
  Drawing drawing = drawing_of(scene, view, workers);
  const std::uint32_t id = visible_at(drawing, view.width, view.height, x, y);
  if (id == no_triangle) return std::nullopt;
  return PixelTriangle{std::move(drawing.objects[drawing.object_of(id)]), id, x, view.height - 1 - y};
}

std::optional<PixelTriangle> triangle_at(const Scene& scene, const View& view, int x, int y, int object, int triangle,
                                         Progress& progress) {
  Scene alone = scene;
  for (std::size_t i = 0; i < alone.objects.size(); ++i) alone.objects[i].visible = int(i) == object;
  Workers workers(view.threads, progress);
  Drawing drawing = drawing_of(alone, view, workers);
  if (drawing.objects.empty()) return std::nullopt;
  DrawnObject& o = drawing.objects[0];
  const auto found = std::lower_bound(o.surface->triangle.begin(), o.surface->triangle.end(), std::uint32_t(triangle));
  if (found == o.surface->triangle.end() || *found != std::uint32_t(triangle)) return std::nullopt;
  const std::uint32_t source = std::uint32_t(found - o.surface->triangle.begin());
  const std::uint32_t* v = &o.surface->indices[3 * std::size_t(source)];
  std::optional<std::uint32_t> best;
  const int up = view.height - 1 - y;
  if ((o.vertices[v[0]].outside | o.vertices[v[1]].outside | o.vertices[v[2]].outside) == 0) best = source;
  for (std::uint32_t c = 0; c < o.clipped.size(); ++c) {
    if (o.clipped[c].source != source) continue;
    const std::uint32_t id = std::uint32_t(o.surface->triangle_count()) + c;
    if (!best || depth_inside(o, id, x, up) > depth_inside(o, *best, x, up)) best = id;
  }
  if (!best) return std::nullopt;
  return PixelTriangle{std::move(o), *best, x, up};
}

}  // namespace cg
