#include "radiosity/hemicube_rows.h"

#include "radiosity/sample_positions.h"

namespace cg {

void draw_items(const ItemScene& scene, const DrawItems& gl, const HemicubeFrame& frame, int resolution, RowSums& sums,
                HemicubeItems& items) {
  const std::vector<std::uint16_t>& above = sums.horizon.above;
  if (!gl) {
    scene.draw(frame, sums.horizon, resolution, items, sums.fronts);
    return;
  }
  scene.find_fronts(frame.position, sums.horizon, sums.fronts);
  std::vector<bool> drawn(scene.size());
  for (std::size_t p = 0; p < drawn.size(); ++p) drawn[p] = (above[p / wide] >> p % wide & 1) != 0;
  ItemFaces faces;
  gl(frame, resolution, drawn, faces);
  items.clear(resolution);
  items.take(faces);
}

HemicubeRows::HemicubeRows(std::span<const ItemPolygon> polygons, const Radiosity& options, bool normalise,
                           const MakeDrawItems& gl)
    : scene_(polygons),
      resolution_(hemicube_resolution(options.resolution)),
      samples_(options.samples),
      placement_(options.placement),
      normalise_(normalise),
      gl_(gl ? gl(polygons) : DrawItems{}),
      pixel_weights_(resolution_, options.weight),
      weights_(pixel_weights_) {}

FormFactorRow HemicubeRows::row(const Patch& part, std::uint32_t own, const Progress& progress) const {
  if (!(part.area > 0)) return {};
  Room& room = rooms_.local();
  RowSums& sums = room.sums;
  sums.begin(scene_, part, own);
  const std::vector<SamplePosition> positions = sample_positions(part, samples_, placement_);
  for (std::size_t number = 0; number < positions.size(); ++number) {
    const SamplePosition& p = positions[number];
    if (progress.cancelled.load(std::memory_order_relaxed)) throw Cancelled{};
    if (const std::uint32_t over = sums.lying_on(scene_, p.position); over != no_item) {
      sums.of_patch[over] += p.weight * pixel_weights_.sum();
      continue;
    }
    draw_items(scene_, gl_, hemicube_frame(p.position, part.normal, number, samples_), resolution_, sums, room.items);
    weights_.add(room.items, p.weight, sums.of_patch.data(), sums.rest);
  }
  return sums.finish(normalise_);
}

}  // namespace cg
