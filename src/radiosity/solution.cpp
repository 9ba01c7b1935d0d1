#include "radiosity/solution.h"

#include <chrono>
#include <cmath>

#include "params/input_error.h"
#include "params/numbers.h"
#include "radiosity/elements.h"
#include "radiosity/field.h"
#include "radiosity/matrix_rows.h"
#include "raster/workers.h"

namespace cg {

namespace {

using Clock = std::chrono::steady_clock;

// How far the sum of a closed scene's row may be from 1 without a word.
constexpr double sum_tolerance = 1e-3;

double lap(Clock::time_point& begin) {
  const Clock::time_point now = Clock::now();
  return std::chrono::duration<double>(now - std::exchange(begin, now)).count();
}

// What form factors depend on beside the geometry, and nothing else.
Radiosity only_method(const Radiosity& options) {
  Radiosity out;
  out.form_factors = options.form_factors;
  out.normalise = options.normalise;
  if (options.form_factors == FormFactors::monte_carlo) out.rays = options.rays;
  if (options.form_factors == FormFactors::closed_form || options.form_factors == FormFactors::monte_carlo) return out;
  out.samples = options.samples;
  out.placement = options.placement;
  out.resolution = options.resolution;
  out.item_buffer = options.item_buffer;
  out.weight = options.weight;
  return out;
}

bool same_light(const Patches& a, const Patches& b) {
  return std::equal(
      a.patches.begin(), a.patches.end(), b.patches.begin(), b.patches.end(),
      [](const Patch& p, const Patch& q) { return p.reflectance == q.reflectance && p.emission == q.emission; });
}

class Making {
 public:
  Making(const Scene& scene, const Radiosity& options, const SolveOptions& how, Progress& progress)
      : scene_(scene), how_(how), progress_(progress), out_(std::make_shared<RadiositySolution>()) {
    out_->options = options;
  }

  SolutionHandle run(const SolutionHandle& earlier) {
    begin_ = Clock::now();
    make_patches_of_scene();
    const bool same_factors = earlier && earlier->matrix && earlier->geometry == out_->geometry &&
                              only_method(earlier->options) == only_method(out_->options) &&
                              double(earlier->matrix->bytes()) <= out_->options.memory * 1024 * 1024 &&
                              (earlier->matrix->whole() || earlier->options.memory == out_->options.memory);
    if (same_factors && earlier->options == out_->options && same_light(*earlier->patches, *out_->patches))
      return unchanged(*earlier);
    if (same_factors)
      keep_factors(*earlier);
    else
      compute_factors();
    solve();
    light_elements();
    tell();
    return out_;
  }

 private:
  void make_patches_of_scene() {
    auto patches = std::make_shared<Patches>(make_patches(scene_, out_->options, progress_));
    if (patches->patches.empty())
      throw InputError("SCENE", {"no visible face has an area", "面積のある面が見えていない"},
                       {"a scene with at least one works: cornell-box", "cornell-box のように面のあるシーンが必要"});
    out_->geometry = geometry_key(scene_, out_->options);
    out_->patches = std::move(patches);
    out_->figures.patches_s = lap(begin_);
  }

  // Made when a row is first wanted: its tables take a while.
  const FormFactorMethod& method() {
    if (method_.row) return method_;
    const std::shared_ptr<const Patches> patches = out_->patches;
    method_ = how_.method ? how_.method(*patches, out_->options) : form_factor_method(*patches, out_->options);
    // The patches live as long as a matrix that still computes rows.
    method_.row = [patches, row = std::move(method_.row)](std::uint32_t i, const Progress& p) { return row(i, p); };
    return method_;
  }

  SolutionHandle unchanged(const RadiositySolution& earlier) {
    *out_ = earlier;
    out_->kept = {Words{"nothing changed: all of it", "変更なし：すべて"}};
    RadiosityFigures& f = out_->figures;
    f.patches_s = f.form_factors_s = f.solve_s = f.elements_s = 0;
    return out_;
  }

  void keep_factors(const RadiositySolution& earlier) {
    out_->matrix = earlier.matrix;
    out_->figures.matrix = earlier.figures.matrix;
    const std::string n = std::to_string(out_->patches->patches.size());
    out_->kept.push_back({"form factors of " + n + " patches: they do not depend on ρ and E",
                          n + " パッチの形態係数（ρ や E に依存しない）"});
  }

  void compute_factors() {
    const std::size_t n = out_->patches->patches.size();
    const MatrixPlan plan = plan_matrix(n, method(), out_->options.memory, progress_);
    if (how_.announce) how_.announce(plan);
    std::vector<double> area;
    for (const Patch& p : out_->patches->patches) area.push_back(p.area);
    const Normalise normalise = out_->patches->closed ? out_->options.normalise : Normalise::none;
    out_->matrix = FormFactorMatrix::make(plan, method(), std::move(area), normalise != Normalise::none, how_.threads,
                                          progress_, normalise == Normalise::reciprocal);
    out_->figures.form_factors_s = lap(begin_);
    out_->figures.matrix = out_->matrix->figures(how_.threads, progress_);
    lap(begin_);
  }

  void solve() {
    Solver solver(system_of(*out_->patches, out_->matrix), out_->options, how_.threads, &progress_);
    solver.forget_states();
    solver.run(progress_);
    RadiosityFigures& f = out_->figures;
    f.solve_s = lap(begin_);
    f.matrix_bytes = out_->matrix->bytes();
    f.steps = solver.steps();
    f.sweeps = solver.sweeps();
    f.error_bound = solver.curve().back().error_bound;
    f.end = solver.end();
    out_->radiosity = solver.radiosity();
    out_->curve = solver.curve();
    // Rows that are not kept would all have to be computed once more.
    if (out_->matrix->whole()) f.residual = solver.residual(progress_);
    if (out_->matrix->whole() && out_->patches->closed) f.energy_error = energy_error(solver);
    if (const Text message = solver.message(); !message.en.empty()) out_->notes.push_back(message);
    lap(begin_);
  }

  // What leaves patches of a closed room, less what arrives at them, over what is emitted.
  double energy_error(const Solver& solver) {
    const std::vector<glm::dvec3> received = solver.part(LightPart::received, progress_);
    glm::dvec3 lost(0), emitted(0);
    for (std::size_t i = 0; i < received.size(); ++i) {
      const Patch& p = out_->patches->patches[i];
      lost += p.area * (out_->radiosity[i] - received[i]);
      emitted += p.area * p.emission;
    }
    double out = 0;
    for (int c = 0; c < 3; ++c)
      if (emitted[c] > 0) out = std::max(out, std::abs(lost[c] / emitted[c]));
    return out;
  }

  // Elements that are whole patches have the patch's light. Of the others each gathers its own, E + rho sum_j F_ej B_j.
  void light_elements() {
    const Patches& whole = *out_->patches;
    out_->element_radiosity.resize(whole.elements.size());
    for (std::size_t e = 0; e < whole.elements.size(); ++e)
      out_->element_radiosity[e] = out_->radiosity[whole.elements[e].patch];
    if (out_->options.adaptive_levels == 0 || out_->figures.end == SolverEnd::diverges) return;
    auto refined = std::make_shared<Patches>(whole);
    for (int level = 0; level < out_->options.adaptive_levels; ++level)
      if (!refine(*refined)) break;
    out_->patches = std::move(refined);
    out_->figures.elements_s = lap(begin_);
  }

  // One level; false: no element had to be cut.
  bool refine(Patches& patches) {
    std::vector<glm::dvec3> reflected = out_->element_radiosity;
    for (std::size_t e = 0; e < reflected.size(); ++e)
      reflected[e] -= patches.patches[patches.elements[e].patch].emission;
    std::vector<int> levels;
    for (const Element& e : patches.elements) levels.push_back(e.level);
    const std::vector<std::uint32_t> former = refine_elements(patches, reflected, out_->options, progress_);
    if (former.empty()) return false;
    const Channels b(out_->radiosity);
    std::vector<glm::dvec3> light(patches.elements.size());
    const FormFactorMethod& rows = method();
    Workers workers(how_.threads, progress_);
    std::atomic<std::size_t> done{0};
    workers.for_each(int(light.size()), [&](int k) {
      const auto e = std::size_t(k);
      const Element& element = patches.elements[e];
      light[e] = element.level == levels[former[e]]
                     ? out_->element_radiosity[former[e]]
                     : gather(rows, element_as_patch(patches, std::uint32_t(e)), element.patch, b);
      workers.done(float(++done) / float(light.size()));
    });
    out_->element_radiosity = std::move(light);
    return true;
  }

  glm::dvec3 gather(const FormFactorMethod& rows, const Patch& part, std::uint32_t own, const Channels& b) const {
    const PassingRow row{rows.part_row(part, own, progress_).factors, 1};
    return part.emission + part.reflectance * row.times(b);
  }

  void tell() {
    const MatrixFigures& m = out_->figures.matrix;
    if (out_->patches->closed && m.rows > 0 && m.sum_error() > sum_tolerance) {
      const std::string off = number_text(std::round(m.sum_error() * 1e5) / 1e5);
      out_->notes.push_back({"a row of form factors is off 1 by " + off + " in this closed scene",
                             "閉じたシーンなのに形態係数の行の和が 1 から " + off + " ずれている"});
    }
    if (out_->patches->closed && out_->options.normalise == Normalise::reciprocal && !out_->matrix->whole())
      out_->notes.push_back(Words{"rows sum to 1 but are not reciprocal: that takes all of them in memory",
                                  "行の和は 1 だが相反則は成り立たない（全行を保存するメモリが必要）"});
    if (out_->patches->degenerate > 0) {
      const std::string n = std::to_string(out_->patches->degenerate);
      out_->notes.push_back({n + " faces without area take no part", "面積のない " + n + " 面は計算に入らない"});
    }
  }

  const Scene& scene_;
  const SolveOptions& how_;
  Progress& progress_;
  std::shared_ptr<RadiositySolution> out_;
  FormFactorMethod method_;
  Clock::time_point begin_;
};

}  // namespace

SolutionHandle solve_radiosity(const Scene& scene, const Radiosity& options, const SolutionHandle& earlier,
                               Progress& progress, const SolveOptions& how) {
  return Making(scene, options, how, progress).run(earlier);
}

RadiosityHandle drawable(const Scene& scene, const RadiositySolution& s) {
  auto field = std::make_shared<RadiosityField>(field_of(scene, *s.patches, s.element_radiosity, s.geometry));
  const auto name = [](auto value) { return names_of<decltype(value)>[std::size_t(value)].label; };
  const Words method = name(s.options.form_factors), solver = name(s.options.solver);
  const std::string n = std::to_string(s.patches->patches.size());
  const std::string off = number_text(std::pow(10, std::ceil(std::log10(std::max(s.figures.error_bound, 1e-17)))));
  field->summary = {n + " patches, " + std::string(method.en) + ", " + std::string(solver.en) + ", error < " + off,
                    n + " パッチ、" + std::string(method.ja) + "、" + std::string(solver.ja) + "、誤差 < " + off};
  return field;
}

double form_factor(const RadiositySolution& solution, std::uint32_t from, std::uint32_t to, const Progress& progress) {
  const std::vector<Patch>& patches = solution.patches->patches;
  const FormFactorMatrix& matrix = *solution.matrix;
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patches[i].object != from) continue;
    area += patches[i].area;
    const auto add = [&](std::size_t j, double f) { sum += patches[j].object == to ? patches[i].area * f : 0; };
    if (i < matrix.kept_rows())
      matrix.visit(i, add);
    else
      for (const FormFactor& f : matrix.row(i, progress).factors) add(f.patch, f.value);
  }
  return area > 0 ? sum / area : 0;
}

std::vector<ObjectLight> mean_radiosity(const RadiositySolution& solution, std::size_t objects) {
  std::vector<ObjectLight> out(objects);
  for (std::size_t i = 0; i < solution.radiosity.size(); ++i) {
    const Patch& p = solution.patches->patches[i];
    if (p.object >= objects) continue;
    out[p.object].radiosity += p.area * solution.radiosity[i];
    out[p.object].area += p.area;
  }
  for (ObjectLight& o : out)
    if (o.area > 0) o.radiosity /= o.area;
  return out;
}

}  // namespace cg
