#include "raster/frame_layers.h"

#include "raster/interpolation.h"
#include "raster/recent_triangles.h"
#include "shading/eye_normal.h"

namespace cg {

namespace {

constexpr std::size_t rows_a_part = 16;

// What the layers say about a triangle.
struct LayerTriangle {
  std::size_t index = 0;  // as in Drawing::objects
  std::int32_t object = nothing, triangle = nothing;
  TriangleWeights<double> weights;
  CornerVectors<double> normals;

  LayerTriangle() = default;
  explicit LayerTriangle(const SeenTriangle& t)
      : index(t.index),
        object(t.object.index),
        triangle(std::int32_t(t.object.surface->triangle[t.source])),
        weights(t.window),
        normals(t.corners<double>(t.object.surface->normals)) {}
};

// The normals of the pixels `shown`, in world space.
void fill_normals(const LayerTriangle& triangle, const NormalTransform<double>& to_world, int x, int y_up,
                  LaneBytes shown, glm::vec3* normal) {
  Weights<Lanes<double>> weights;
  LaneVectors<double> N;
  triangle.weights.at(Lanes<double>(lane_numbers<double> + double(x)), double(y_up), weights);
  triangle.normals.at(weights, N);
  for (int i = 0; i < lanes; ++i)
    if (has_lane(shown, i)) normal[i] = glm::vec3(eye_normal(to_world, {N.x[i], N.y[i], N.z[i]}));
}

}  // namespace

void fill_ids_and_normals(const Scene& scene, const Drawing& drawing, const VisibilityBuffer& visibility,
                          Workers& workers, Frame& frame) {
  const bool ids = !frame.object.empty(), normals = !frame.normal.empty();
  if (!ids && !normals) return;
  std::vector<NormalTransform<double>> to_world;
  for (const DrawnObject& o : drawing.objects)
    to_world.push_back(
        normals_to_eye<double>(matrix(scene.objects[std::size_t(o.index)].transform), NormalLength::normalize));
  const auto fill = [&](RecentTriangles<LayerTriangle>& recent, int x, int y) {
    const Lanes<std::uint32_t>& shown = visibility.group(x, y).triangle;
    const LaneBytes covered = lane_bytes(shown != no_triangle) & first_lanes(visibility.width - x);
    for_each_run(shown, covered, [&](std::uint32_t id, const Lanes<std::int32_t>& mask) {
      const LaneBytes mine = lane_bytes(mask) & covered;
      const LayerTriangle& t = recent.get(id, [&] { return LayerTriangle(SeenTriangle(drawing, id)); });
      for (int i = 0; i < lanes && ids; ++i)
        if (has_lane(mine, i)) frame.object.at(x + i, y) = t.object, frame.triangle.at(x + i, y) = t.triangle;
      if (normals) fill_normals(t, to_world[t.index], x, visibility.height - 1 - y, mine, frame.normal.row(y) + x);
    });
  };
  const std::size_t height = std::size_t(visibility.height);
  workers.for_each(part_count(height, rows_a_part), [&](int i) {
    const Part rows = part_of(height, rows_a_part, i);
    RecentTriangles<LayerTriangle> recent;
    for (std::size_t y = rows.begin; y < rows.end; ++y)
      for (int x = 0; x < visibility.width; x += lanes) fill(recent, x, int(y));
  });
}

}  // namespace cg
