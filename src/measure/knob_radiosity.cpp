// How large patches may be, and when a solver stops.
#include <algorithm>
#include <cmath>
#include <map>

#include "measure/knob_list.h"
#include "measure/radiosity_parts.h"
#include "radiosity/solution.h"
#include "scene/cpu_clock.h"

namespace cg {

namespace {

using FaceMeans = std::map<std::pair<std::uint32_t, std::uint32_t>, glm::dvec3>;

// The mean radiosity of each face.
FaceMeans means_of(const Scene& scene, double patch_size, Progress& progress) {
  Radiosity options = scene.radiosity;
  options.patch_size = patch_size;
  const SolutionHandle s = solve_radiosity(scene, options, nullptr, progress);
  FaceMeans out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> area;
  for (std::size_t i = 0; i < s->radiosity.size(); ++i) {
    const Patch& p = s->patches->patches[i];
    out[{p.object, p.face}] += p.area * s->radiosity[i];
    area[{p.object, p.face}] += p.area;
  }
  for (auto& [face, power] : out) power /= area[face];
  return out;
}

constexpr const char* limit = "limit";

// Where three means of patches halved twice are going, whatever the order. This work is based on: Alexander Aitken, On
// Bernoulli's Numerical Solution of Algebraic Equations, 1926.
double aitken(double first, double second, double third) {
  const double step = third - second, bend = step - (second - first);
  return std::abs(bend) > 1e-3 * std::abs(step) ? third - step * step / bend : third;
}

// What it cost is all of it.
Frame face_means(const Setting& setting, std::span<const Technique>, Progress& progress) {
  CpuClock clock;
  const double size = setting.scene.radiosity.patch_size;
  FaceMeans means = means_of(setting.scene, size, progress);
  if (setting.id == limit) {
    const FaceMeans coarse = means_of(setting.scene, 4 * size, progress),
                    half = means_of(setting.scene, 2 * size, progress);
    for (auto& [face, mean] : means)
      for (int c = 0; c < 3; ++c) mean[c] = aitken(coarse.at(face)[c], half.at(face)[c], mean[c]);
  }
  Frame frame;
  frame.cpu_ms = clock.lap_ms();
  std::vector<glm::dvec3> values;
  for (const auto& [face, mean] : means) values.push_back(mean);
  frame.colour = row_of_colours(values);
  return frame;
}

double longest_side(const Scene& scene) {
  double longest = 0;
  for (const Object& o : scene.objects)
    if (o.visible && o.mesh) {
      const glm::dvec3 side = (o.mesh->high() - o.mesh->low()) * glm::abs(o.transform.scale);
      longest = std::max(longest, std::max(side.x, std::max(side.y, side.z)));
    }
  return longest;
}

Ladder patch_ladder(const TradeRequest& request) {
  Ladder out;
  Scene scene = scene_of_few_patches(request);
  scene.radiosity.form_factors = FormFactors::closed_form;
  scene.radiosity.residual = 1e-8;
  const double side = longest_side(scene);
  const auto with = [&](int parts) {
    scene.radiosity.patch_size = side / parts * (1 + 1e-9);
    Setting s = radiosity_setting(scene, "patch-" + std::to_string(parts), side / parts, 0);
    s.label = {"1/" + std::to_string(parts), "1/" + std::to_string(parts)};
    return s;
  };
  for (const int parts : {8, 6, 5, 4, 3, 2, 1}) out.settings.push_back(with(parts));
  out.references.push_back(with(16));
  out.references.back().id = limit;
  return out;
}

// Until it stops by itself.
Frame light(const Setting& setting, std::span<const Technique>, Progress& progress) {
  return solved_light(
      setting, setting.scene.radiosity, [&](Solver& solver) { solver.run(progress); }, progress);
}

Ladder residual_ladder(const TradeRequest& request) {
  return sweeping_ladder(scene_of_few_patches(request), [](Ladder& out, Scene& with_solver, const std::string& solver) {
    for (int decade = 6; decade >= 1; --decade) {
      Radiosity& options = with_solver.radiosity;
      options.residual = std::pow(10, -decade);
      out.settings.push_back(radiosity_setting(with_solver, solver + "-" + std::to_string(decade), options.residual,
                                               std::size_t(options.solver)));
    }
  });
}

}  // namespace

Knob radiosity_patches_knob() {
  Knob k;
  k.scene = "models/closed-cube.json";
  k.errors = relative_errors;
  k.id = "radiosity-patches";
  k.name = {"Patch size", "パッチの大きさ"};
  k.help = {"One radiosity a patch: how small must they be? Exact form factors, each wall's mean compared.",
            "パッチごとにラジオシティは一つ。どこまで細かくすべきか。形態係数は厳密、壁の平均で比べる。"};
  k.parameter = "radiosity.patch_size";
  k.abscissa = {"h", {"side of a patch", "パッチの一辺"}, "m"};
  k.labels = {"share of the longest side", "最も長い辺に対する比"};
  k.reference = {"the limit of patches of 1/4, 1/8 and 1/16 of the longest side (Aitken)",
                 "最も長い辺の 1/4、1/8、1/16 のパッチから外挿した極限（エイトケン）"};
  k.error = {"RMS of the walls' mean radiosity, over that of the means",
             "壁ごとの平均ラジオシティの誤差の RMS ÷ 平均の RMS"};
  k.series = {{"means", {"Mean of each wall", "壁ごとの平均"}}};
  k.predictions = {
      {.order = 2,
       .law = "h^2",
       .why = {"A constant a patch is off by its gradient, as h, but the means of errors cancel to h^2.",
               "パッチごとに一定とした誤差は勾配に比例し h だが、平均では打ち消し合って h^2 になる。"},
       .otherwise = {"Where walls meet, the light goes as a power below 1 of the distance (0.76 where ρ = 0.5): its "
                     "gradient has no limit, and only patches far smaller come near the order 2.",
                     "壁どうしが接する所では光が距離の 1 未満のべき（ρ = 0.5 なら 0.76 乗）で変わり、勾配が発散する。"
                     "次数が 2 に近づくのはずっと小さいパッチから。"},
       .source = "James Arvo, Kenneth Torrance, Brian Smits, A Framework for the Analysis of Error in "
                 "Global Illumination Algorithms, 1994"}};
  k.bend_low = {"the reference is not much finer there.", "基準の細かさに近い。"};
  k.bend_high = {"a patch is a whole wall there.", "パッチが壁全体になっている。"};
  k.draw = face_means;
  k.ladder = patch_ladder;
  return k;
}

Knob radiosity_residual_knob() {
  Knob k = sweeping_knob();
  k.id = "radiosity-residual";
  k.name = {"When the solver stops", "解法をいつ止めるか"};
  k.help = {"Each iterative solver, stopped at larger and larger residuals, against LU.",
            "反復解法を残差の大きさを変えて止め、LU 分解の解と比べる。"};
  k.parameter = "radiosity.residual";
  k.abscissa = {"ε", {"residual over 1 − ρ_max", "残差 ÷（1 − ρ の最大値）"}};
  for (std::size_t i = 0; i < sweeping_solvers; ++i) {
    k.predictions.push_back(
        {.series = i,
         .of = ErrorKind::max,
         .order = 1,
         .law = "ε^1",
         .why = {"The error is the residual times the inverse of 1 − ρF, whose norm is 1/(1 − ρ) at most.",
                 "誤差は残差に 1 − ρF の逆行列をかけたもので、そのノルムは 1/(1 − ρ) 以下。"},
         .source = "Steven Gortler, Michael Cohen, Philipp Slusallek, Radiosity and Relaxation Methods, 1994"});
  }
  k.bend_high = {"few sweeps were made there.", "まだ数回しか反復していない。"};
  k.draw = light;
  k.ladder = residual_ladder;
  return k;
}

}  // namespace cg
