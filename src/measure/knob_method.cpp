// Which method form factors come from: what each costs for how much accuracy.
#include "measure/knob_list.h"
#include "measure/radiosity_parts.h"
#include "radiosity/hemicube.h"

namespace cg {

namespace {

constexpr int hemicube_side = 4;  // Gauss points a side: what positions leave is below what pixels do

Ladder ladder(const TradeRequest& request) {
  Ladder out;
  const Scene scene = scene_of_few_patches(request);
  const auto add = [&](FormFactors method, double samples, const std::string& label, const auto& change) {
    Scene s = scene;
    s.radiosity.form_factors = method;
    change(s.radiosity);
    const std::string name(names_of<FormFactors>[std::size_t(method)].id);
    Setting& setting = out.settings.emplace_back(
        radiosity_setting(s, name + "-" + label, samples, std::size_t(method) - std::size_t(FormFactors::nusselt)));
    setting.label = {label, label};
  };
  for (const int side : {1, 2, 3, 4, 6, 8, 12})
    add(FormFactors::nusselt, side * side, std::to_string(side),
        [&](Radiosity& r) { r.samples = side, r.placement = Placement::grid; });
  for (const int resolution : {16, 24, 32, 48, 64, 96, 128, 192})
    add(FormFactors::hemicube, 3.0 * resolution * resolution * hemicube_side * hemicube_side,
        std::to_string(resolution),
        [&](Radiosity& r) { r.samples = hemicube_side, r.placement = Placement::gauss, r.resolution = resolution; });
  for (int rays = 64; rays <= 65536; rays *= 4)
    add(FormFactors::monte_carlo, rays, std::to_string(rays), [&](Radiosity& r) { r.rays = rays; });
  out.references.push_back(closed_form_of(scene));
  return out;
}

}  // namespace

Knob radiosity_method_knob() {
  Knob k = form_factor_knob();
  k.id = "radiosity-method";
  k.name = {"Method of form factors", "形態係数の求め方"};
  k.help = {
      "The Nusselt projection, hemicubes and rays beside each other: what a row costs and how far it is off. Only "
      "the last two know what hides what.",
      "ヌッセルト投影、ヘミキューブ、光線を並べ、行の計算時間と誤差を比べる。遮蔽を扱えるのは後の二つだけ。"};
  k.parameter = "radiosity.form_factors";
  k.abscissa = {"n", {"positions, pixels or rays a patch", "パッチごとの位置、画素、光線の数"}};
  k.labels = {"positions a side, pixels a side, rays", "一辺の位置数、一辺の画素数、光線数"};
  k.series = {{"nusselt", {"Nusselt projection", "ヌッセルト投影"}},
              {"hemicube", {"Hemicube, 4 × 4 positions", "ヘミキューブ（位置 4 × 4）"}},
              {"monte-carlo", {"Monte Carlo", "モンテカルロ法"}}};
  k.predictions = {
      {.series = 0,
       .order = -1,
       .law = "n^(-1)",
       .why = {"S × S positions integrate by the midpoint rule, off by 1/S^2.",
               "S × S 個の位置での積分は中点則であり、誤差は 1/S^2 になる。"},
       .otherwise = {"Where patches touch, what a position sees has no gradient at their edge, and the order is less.",
                     "パッチが接する所では勾配が発散し、次数は小さくなる。"},
       .source = "Philip Davis, Philip Rabinowitz, Methods of Numerical Integration, 1975"},
      {.series = 1,
       .order = -0.75,
       .law = "n^(-3/4)",
       .why = {"Of R × R pixels some √R too many or too few are counted at a border that lies askew: R^(-3/2) of all.",
               "斜めの境界では R × R 画素のうち √R 個ほど数え誤る。全体に対しては R^(-3/2) になる。"},
       .otherwise = {"The positions on a patch leave an error that no pixel mends.",
                     "位置の取り方による誤差は画素を増やしても消えない。"},
       .source = "David Kendall, On the number of lattice points inside a random oval, 1948"},
      {.series = 2,
       .order = -0.5,
       .law = "n^(-1/2)",
       .why = {"The mean of n random values scatters by their deviation over the root of n.",
               "n 個の乱数の平均のばらつきは標準偏差の 1/√n になる。"},
       .otherwise = {"Rays that are spread evenly do better.", "光線を均等に散らすともっと速く減る。"},
       .source = "Nicholas Metropolis, Stanislaw Ulam, The Monte Carlo Method, 1949"}};
  k.bend_low = {"there is too little of it for an order.", "数が少なすぎて次数が現れない。"};
  k.bend_high = {"what is left does not depend on it.", "残る誤差は数によらない。"};
  k.ladder = ladder;
  return k;
}

}  // namespace cg
