// Which solver: how much nearer each sweep brings it to the light, and what that costs.
#include <cmath>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/radiosity_parts.h"

namespace cg {

namespace {

constexpr double reflectance = 0.9;  // of all surfaces: sweeps enough to see an order

// After as many sweeps as x says.
Frame light_after(const Setting& setting, std::span<const Technique>, Progress& progress) {
  Radiosity options = setting.scene.radiosity;
  options.residual = 1e-300;
  return solved_light(
      setting, options,
      [&](Solver& solver) {
        if (options.solver == RadiositySolver::lu) return solver.run(progress);
        for (long sweep = std::lround(std::log(setting.x) / std::log(reflectance)); sweep > 0; --sweep)
          solver.sweep(progress);
      },
      progress);
}

Ladder ladder(const TradeRequest& request) {
  Scene scene = scene_of_few_patches(request);
  change_materials(scene, [](Material& m) { m.k_d = glm::dvec3(reflectance); });
  return sweeping_ladder(scene, [](Ladder& out, Scene& with_solver, const std::string& solver) {
    for (const int sweeps : {40, 32, 24, 16, 12, 8, 6, 4, 3, 2, 1}) {
      const std::string n = std::to_string(sweeps);
      out.settings.push_back(radiosity_setting(with_solver, solver + "-" + n, std::pow(reflectance, sweeps),
                                               std::size_t(with_solver.radiosity.solver)));
      out.settings.back().label = {n, n};
    }
  });
}

}  // namespace

Knob radiosity_solver_knob() {
  Knob k = sweeping_knob();
  k.id = "radiosity-solver";
  k.name = {"Solver", "解法"};
  k.help = {
      "Each iterative solver after 1 to 40 sweeps (as many rows or shots as there are patches), all reflectances "
      "0.9, against LU.",
      "反復解法を 1〜40 スイープ（パッチ数と同じ回数の行または放出）で止め、LU 分解の解と比べる。反射率はすべて "
      "0.9。"};
  k.parameter = "radiosity.solver";
  k.abscissa = {"q", {"what as many bounces leave, ρ^k of k sweeps", "k 回の反射で残る割合 ρ^k（k はスイープ数）"}};
  k.labels = {"sweeps", "スイープ数"};
  for (std::size_t i = 0; i < sweeping_solvers; ++i) {
    Prediction p{.series = i,
                 .of = ErrorKind::max,
                 .order = 2,
                 .law = "q^2",
                 .why = {"A value that is new counts at once: a sweep does what two of Jacobi's do.",
                         "新しい値をすぐに使うので、1 スイープでヤコビ法の 2 スイープ分進む。"},
                 .source =
                     "David Young, Iterative Methods for Solving Partial Difference Equations of Elliptic Type, "
                     "1954"};
    if (i == 0) {
      p.order = 1, p.law = "q^1";
      p.why = {"A sweep of Jacobi's is one more bounce, which leaves ρ of the light before.",
               "ヤコビ法の 1 スイープは反射 1 回分で、残りは ρ 倍になる。"};
      p.source =
          "Cindy Goral, Kenneth Torrance, Donald Greenberg, Bennett Battaile, Modeling the Interaction of Light "
          "Between Diffuse Surfaces, 1984";
    } else if (i >= 2) {
      p.why = {"The brightest shoots first, and so all in turn: as Gauss and Seidel's sweep, by columns.",
               "最も明るいものから順に放出するので、列ごとに見たガウス・ザイデル法と同じ速さになる。"};
      p.source = "Steven Gortler, Michael Cohen, Philipp Slusallek, Radiosity and Relaxation Methods, 1994";
    }
    k.predictions.push_back(p);
  }
  k.bend_high = {"the first bounces are not yet like those that follow.", "最初の数回の反射はその後と様子が違う。"};
  k.draw = light_after;
  k.ladder = ladder;
  return k;
}

}  // namespace cg
