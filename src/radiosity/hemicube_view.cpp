#include "radiosity/hemicube_view.h"

#include "radiosity/hemicube_rows.h"
#include "radiosity/sample_positions.h"

namespace cg {

struct HemicubeViewer::Drawn {
  const Patches& patches;
  std::vector<ItemPolygon> polygons;
  ItemScene scene;
  DrawItems gl;  // null where OpenGL does not draw

  Drawn(const Patches& p, const MakeDrawItems& make_gl)
      : patches(p), polygons(item_polygons(p)), scene(polygons), gl(make_gl ? make_gl(polygons) : DrawItems{}) {}
};

HemicubeViewer::HemicubeViewer(const Patches& patches, MakeDrawItems gl)
    : drawn_(std::make_shared<const Drawn>(patches, gl)) {}

std::size_t HemicubeViewer::positions(const Patch& patch, const Radiosity& options) {
  return sample_positions(patch, options.samples, options.placement).size();
}

HemicubeView HemicubeViewer::view(std::uint32_t patch, std::size_t position, const Radiosity& options) const {
  const Patch& from = drawn_->patches.patches[patch];
  const SamplePosition at = sample_positions(from, options.samples, options.placement)[position];
  HemicubeView out;
  out.frame = hemicube_frame(at.position, from.normal, position, options.samples);
  out.resolution = hemicube_resolution(options.resolution);
  out.share = at.weight;
  const bool gl = options.item_buffer == ItemBuffer::gl;
  if (gl && !drawn_->gl) throw no_opengl_for_hemicubes();
  RowSums sums;
  sums.begin(drawn_->scene, from, patch);
  out.lying_on = sums.lying_on(drawn_->scene, at.position);
  HemicubeItems items;
  draw_items(drawn_->scene, gl ? drawn_->gl : DrawItems{}, out.frame, out.resolution, sums, items);
  const PixelWeights weights(out.resolution, options.weight);
  const int size = 2 * out.resolution;
  out.items = Image<std::uint32_t>(size, size, no_item);
  out.weights = Image<float>(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (const auto p = cross_pixel(x, y, out.resolution)) {
        out.items.at(x, y) = out.lying_on != no_item ? out.lying_on : items.item(p->face, p->x, p->y);
        out.weights.at(x, y) = weights(p->face, p->x, p->y);
      }
  return out;
}

std::optional<CrossPixel> cross_pixel(int x, int y, int resolution) {
  const int half = resolution / 2;
  const int s = x - half, t = 2 * resolution - 1 - y - half;  // from the top face's lowest corner
  const bool within_s = s >= 0 && s < resolution, within_t = t >= 0 && t < resolution;
  if (within_s && within_t) return CrossPixel{HemicubeFace::top, s, t};
  if (within_t)
    return s < 0 ? CrossPixel{HemicubeFace::left, x, t} : CrossPixel{HemicubeFace::right, s - resolution, t};
  if (within_s)
    return t < 0 ? CrossPixel{HemicubeFace::lower, s, t + half} : CrossPixel{HemicubeFace::upper, s, t - resolution};
  return std::nullopt;
}

glm::dvec3 pixel_direction(const HemicubeView& view, const CrossPixel& pixel) {
  const glm::dvec3 d = on_cube(pixel.face, sample_point(view.frame, pixel.face, pixel.x, pixel.y, view.resolution));
  return unit(d.x * view.frame.x + d.y * view.frame.y + d.z * view.frame.z);
}

}  // namespace cg
