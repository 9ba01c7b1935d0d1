#include "raster/frame_layers.h"

#include "raster/interpolation.h"
#include "raster/recent_triangles.h"
#include "shading/eye_normal.h"

namespace cg {

namespace {

constexpr std::size_t rows_a_part = 16;

// Calls fill(run's triangle, x, y, its pixels among the eight from x on) for each run of pixels that show the same
// triangle. `Triangle` is made of a SeenTriangle.
template <class Triangle, class Fill>
void for_each_seen(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers, const Fill& fill) {
  const std::size_t height = std::size_t(visibility.height);
  workers.for_each(part_count(height, rows_a_part), [&](int i) {
    const Part rows = part_of(height, rows_a_part, i);
    RecentTriangles<Triangle> recent;
    for (std::size_t y = rows.begin; y < rows.end; ++y)
      for (int x = 0; x < visibility.width; x += lanes) {
        const Lanes<std::uint32_t>& shown = visibility.group(x, int(y)).triangle;
        const LaneBytes covered = lane_bytes(shown != no_triangle) & first_lanes(visibility.width - x);
        for_each_run(shown, covered, [&](std::uint32_t id, const Lanes<std::int32_t>& mask) {
          fill(recent.get(id, [&] { return Triangle(SeenTriangle(drawing, id)); }), x, int(y),
               lane_bytes(mask) & covered);
        });
      }
  });
}

struct NumberedTriangle {
  std::int32_t object = nothing, triangle = nothing;
  NumberedTriangle() = default;
  explicit NumberedTriangle(const SeenTriangle& t)
      : object(t.object.index), triangle(std::int32_t(t.object.surface->triangle[t.source])) {}
};

struct NormalTriangle {
  std::size_t index = 0;  // as in Drawing::objects
  TriangleWeights<double> weights;
  CornerVectors<double> normals;
  NormalTriangle() = default;
  explicit NormalTriangle(const SeenTriangle& t)
      : index(t.index), weights(t.window), normals(t.corners<double>(t.object.surface->normals)) {}
};

}  // namespace

void fill_ids(const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers, Frame& frame) {
  for_each_seen<NumberedTriangle>(drawing, visibility, workers,
                                  [&](const NumberedTriangle& t, int x, int y, LaneBytes shown) {
                                    for (int i = 0; i < lanes; ++i)
                                      if (has_lane(shown, i))
                                        frame.object.at(x + i, y) = t.object, frame.triangle.at(x + i, y) = t.triangle;
                                  });
}

void fill_normals(const Scene& scene, const Drawing& drawing, const VisibilityBuffer& visibility, Workers& workers,
                  Frame& frame) {
  std::vector<NormalTransform<double>> to_world;
  for (const DrawnObject& o : drawing.objects)
    to_world.push_back(
        normals_to_eye<double>(matrix(scene.objects[std::size_t(o.index)].transform), NormalLength::normalize));
  for_each_seen<NormalTriangle>(
      drawing, visibility, workers, [&](const NormalTriangle& t, int x, int y, LaneBytes shown) {
        Weights<Lanes<double>> weights;
        LaneVectors<double> N;
        t.weights.at(Lanes<double>(lane_numbers<double> + double(x)), double(visibility.height - 1 - y), weights);
        t.normals.at(weights, N);
        for (int i = 0; i < lanes; ++i)
          if (has_lane(shown, i))
            frame.normal.at(x + i, y) = glm::vec3(eye_normal(to_world[t.index], {N.x[i], N.y[i], N.z[i]}));
      });
}

}  // namespace cg
