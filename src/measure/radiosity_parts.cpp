#include "measure/radiosity_parts.h"

#include <algorithm>
#include <cmath>

#include "params/input_error.h"
#include "params/numbers.h"
#include "radiosity/form_factors.h"
#include "radiosity/unoccluded_rows.h"
#include "scene/cpu_clock.h"

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

Setting closed_form_of(const Scene& scene) {
  Setting s = radiosity_setting(scene, "closed-form", 1, 0);
  s.label = Words{"closed form", "閉じた式"};
  s.scene.radiosity.form_factors = FormFactors::closed_form;
  return s;
}

Frame factors_of_all_pairs(const Setting& setting, std::span<const Technique>, Progress& progress) {
  const Patches patches = make_patches(setting.scene, setting.scene.radiosity, progress);
  const FormFactorMethod method = form_factor_method(patches, setting.scene.radiosity);
  const int n = int(patches.patches.size());
  Frame frame;
  frame.colour = ColourImage(n, n);
  CpuClock clock;
  for (int i = 0; i < n; ++i)
    for (const FormFactor& f : method.row(std::uint32_t(i), progress).factors)
      frame.colour.at(int(f.patch), i) = glm::vec3(f.value);
  frame.cpu_ms = clock.lap_ms();
  return frame;
}

Knob form_factor_knob() {
  Knob k;
  k.scene = "models/closed-cube.json";
  k.reference = {"the closed form of each pair", "各組の閉じた式の値"};
  k.error = {"RMS of the factors' errors, over that of the factors", "形態係数の誤差の RMS ÷ 係数の RMS"};
  k.draw = factors_of_all_pairs;
  k.errors = relative_errors;
  return k;
}

std::shared_ptr<const FormFactorMatrix> closed_form_matrix(const Patches& patches, Progress& progress) {
  const FormFactorMethod method = form_factor_method(patches, {.form_factors = FormFactors::closed_form});
  std::vector<double> area;
  for (const Patch& p : patches.patches) area.push_back(p.area);
  const std::size_t n = area.size();
  return FormFactorMatrix::make({.rows = n, .kept_rows = n}, method, std::move(area), patches.closed, 1, progress);
}

ColourImage row_of_colours(const std::vector<glm::dvec3>& values) {
  ColourImage out(int(values.size()), 1);
  for (std::size_t i = 0; i < values.size(); ++i) out.at(int(i), 0) = glm::vec3(values[i]);
  return out;
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
