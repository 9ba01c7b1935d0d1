#include "measure/radiosity_parts.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"
#include "params/numbers.h"
#include "radiosity/unoccluded_rows.h"

namespace cg {

namespace {

constexpr std::size_t few_patches = 54;

Patches patches_of(const Scene& scene) {
  Progress progress;
  return make_patches(scene, scene.radiosity, progress);
}

}  // namespace

Scene scene_of_few_patches(const TradeRequest& request) {
  Scene scene = request.scene;
  Patches patches = patches_of(scene);
  for (int i = 0; i < 64 && patches.patches.size() > few_patches; ++i) {
    scene.radiosity.patch_size *= 1.25;
    patches = patches_of(scene);
  }
  if (patches.patches.size() > few_patches || !nothing_hides(patches))
    throw InputError("SCENE",
                     {"its form factors have no closed form, as one face hides another or there are too many",
                      "面が多すぎるか、面どうしが隠し合うため、形態係数の厳密な値が求まらない"},
                     {"models/closed-cube.json or models/perpendicular-squares.json works",
                      "models/closed-cube.json や models/perpendicular-squares.json を使うとよい"});
  return scene;
}

Setting radiosity_setting(const Scene& scene, std::string id, double x, std::size_t series) {
  Setting s;
  s.id = std::move(id);
  s.label = {number_text(x), number_text(x)};
  s.series = series;
  s.x = x;
  s.scene = scene;
  s.technique = "software";
  s.view = {1, 1};
  return s;
}

Errors relative_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  Errors out;
  double off = 0, all = 0, largest = 0;
  for (std::size_t i = 0; i < std::min(frame.colour.size(), reference.colour.size()); ++i) {
    const glm::dvec3 exact(reference.colour.pixels()[i]), d = glm::dvec3(frame.colour.pixels()[i]) - exact;
    off += glm::dot(d, d);
    all += glm::dot(exact, exact);
    for (int c = 0; c < 3; ++c) {
      out.max = std::max(out.max, std::abs(d[c]));
      largest = std::max(largest, std::abs(exact[c]));
    }
    ++out.samples;
  }
  out.rmse = all > 0 ? std::sqrt(off / all) : 0;
  out.max = largest > 0 ? out.max / largest : 0;
  return out;
}

}  // namespace cg
