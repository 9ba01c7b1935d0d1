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

void add_settings(Ladder& out, Scene scene, const std::string& prefix, std::size_t series,
                  std::initializer_list<int> values, const std::function<void(Radiosity&, int)>& set) {
  for (const int value : values) {
    set(scene.radiosity, value);
    out.settings.push_back(radiosity_setting(scene, prefix + std::to_string(value), value, series));
  }
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

Knob sweeping_knob() {
  Knob k;
  k.scene = "models/closed-cube.json";
  k.errors = relative_errors;
  k.reference = {"LU decomposition", "LU 分解"};
  k.error = {"largest error of B, over the largest B", "B の最大誤差 ÷ B の最大値"};
  k.plotted = ErrorKind::max;
  k.bend_low = {"the digits of the picture's floats are what is left.", "残るのは float の丸め。"};
  for (std::size_t i = 0; i < sweeping_solvers; ++i) {
    const Name& name = names_of<RadiositySolver>[i];
    k.series.push_back({name.id, name.label});
  }
  return k;
}

Ladder sweeping_ladder(Scene scene,
                       const std::function<void(Ladder& out, Scene& scene, const std::string& solver)>& add) {
  Ladder out;
  for (std::size_t i = 0; i < sweeping_solvers; ++i) {
    scene.radiosity.solver = RadiositySolver(int(i));
    Scene own = scene;
    add(out, own, std::string(names_of<RadiositySolver>[i].id));
  }
  scene.radiosity.solver = RadiositySolver::lu;
  out.references.push_back(radiosity_setting(scene, "lu", 1, 0));
  out.references.back().label = Words{"LU", "LU 分解"};
  return out;
}

Frame solved_light(const Setting& setting, const Radiosity& options, const std::function<void(Solver&)>& run,
                   Progress& progress) {
  const Patches patches = make_patches(setting.scene, options, progress);
  Solver solver(system_of(patches, closed_form_matrix(patches, progress)), options);
  CpuClock clock;
  run(solver);
  Frame frame;
  frame.cpu_ms = clock.lap_ms();
  frame.colour = row_of_colours(solver.radiosity());
  return frame;
}

void RelativeErrors::add(const glm::dvec3& value, const glm::dvec3& exact) {
  const glm::dvec3 d = value - exact;
  off_ += glm::dot(d, d);
  all_ += glm::dot(exact, exact);
  for (int c = 0; c < 3; ++c) {
    farthest_ = std::max(farthest_, std::abs(d[c]));
    largest_ = std::max(largest_, std::abs(exact[c]));
  }
  ++count_;
}

Errors RelativeErrors::errors() const {
  Errors out;
  out.samples = count_;
  out.rmse = all_ > 0 ? std::sqrt(off_ / all_) : 0;
  out.max = largest_ > 0 ? farthest_ / largest_ : 0;
  return out;
}

Errors relative_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  RelativeErrors sums;
  for (std::size_t i = 0; i < std::min(frame.colour.size(), reference.colour.size()); ++i)
    sums.add(glm::dvec3(frame.colour.pixels()[i]), glm::dvec3(reference.colour.pixels()[i]));
  return sums.errors();
}

}  // namespace cg
