// What a picture is drawn from: the scene's objects on their way through the pipeline, and the numbers by which
// the visibility buffer names their triangles.
#pragma once
#include <algorithm>

#include "raster/clip.h"
#include "raster/workers.h"
#include "scene/scene.h"

namespace cg {

// One object. Triangle t of its surface is visible as number first + t; its clipped triangle c as
// first + surface->triangle_count() + c.
struct DrawnObject {
  int index = 0;  // in Scene::objects
  SurfaceHandle surface;
  glm::dmat4 to_eye{1};
  glm::mat4 to_clip{1};
  std::uint32_t outside = 0;  // bits of all vertices, or-ed
  std::vector<WindowVertex> vertices;
  std::vector<ClippedTriangle> clipped;
  std::uint32_t first = 0, end = 0;
  bool tested = false;  // not opaque everywhere: find_visible() leaves it to test_alpha()

  bool is_clipped(std::uint32_t id) const { return id - first >= surface->triangle_count(); }
  const ClippedTriangle& clipped_triangle(std::uint32_t id) const {
    return clipped[id - first - surface->triangle_count()];
  }
  // The surface's triangle that `id` is, or was cut from.
  std::uint32_t source(std::uint32_t id) const { return is_clipped(id) ? clipped_triangle(id).source : id - first; }
  // The three vertices of a visible triangle in the window.
  std::array<const WindowVertex*, 3> window(std::uint32_t id) const {
    if (is_clipped(id)) {
      const auto& v = clipped_triangle(id).vertices;
      return {&v[0], &v[1], &v[2]};
    }
    const std::uint32_t* i = &surface->indices[3 * std::size_t(id - first)];
    return {&vertices[i[0]], &vertices[i[1]], &vertices[i[2]]};
  }
};

inline constexpr std::uint32_t no_triangle = 0xffffffffu;

struct Drawing {
  std::vector<DrawnObject> objects;
  // The object that `id` belongs to.
  std::size_t object_of(std::uint32_t id) const {
    const auto after = std::upper_bound(objects.begin(), objects.end(), id,
                                        [](std::uint32_t i, const DrawnObject& o) { return i < o.first; });
    return std::size_t(after - objects.begin()) - 1;
  }
};

// Calls draw(v0, v1, v2, id) for each triangle of the part that clipping left, in order.
template <class Draw>
void for_each_triangle(const DrawnObject& object, const Part& part, const Draw& draw) {
  const std::vector<std::uint32_t>& indices = object.surface->indices;
  auto cut = std::lower_bound(object.clipped.begin(), object.clipped.end(), part.begin,
                              [](const ClippedTriangle& c, std::size_t t) { return c.source < t; });
  for (std::size_t t = part.begin; t < part.end; ++t) {
    const WindowVertex& v0 = object.vertices[indices[3 * t]];
    const WindowVertex& v1 = object.vertices[indices[3 * t + 1]];
    const WindowVertex& v2 = object.vertices[indices[3 * t + 2]];
    if ((v0.outside | v1.outside | v2.outside) == 0) draw(v0, v1, v2, object.first + std::uint32_t(t));
    for (; cut != object.clipped.end() && cut->source == t; ++cut)
      draw(cut->vertices[0], cut->vertices[1], cut->vertices[2],
           object.first + std::uint32_t(object.surface->triangle_count() + std::size_t(cut - object.clipped.begin())));
  }
}

// The first steps of a picture. The visible objects that have triangles and can be placed, each with its surface and
// matrices; true where `drawing` held the same ones before;
bool gather_objects(const Scene& scene, const View& view, Workers& workers, Drawing& drawing);
// their vertices in the window;
void transform_objects(const Viewport& viewport, Workers& workers, Drawing& drawing);
// what the view volume cuts, where `clip` says that something may be cut, and every triangle's number.
void clip_objects(const Viewport& viewport, bool clip, Workers& workers, Drawing& drawing);

// All three, for whoever asks about a picture without drawing it.
Drawing drawing_of(const Scene& scene, const View& view, Workers& workers);

}  // namespace cg
