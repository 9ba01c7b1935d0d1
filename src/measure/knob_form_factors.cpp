// How exact form factors are: where on a patch they are sampled, how finely, and by rays.
#include "measure/knob_list.h"
#include "measure/radiosity_parts.h"

namespace cg {

namespace {

Ladder positions_ladder(const TradeRequest& request) {
  Ladder out;
  Scene scene = scene_of_few_patches(request);
  scene.radiosity.form_factors = FormFactors::hemicube;
  scene.radiosity.resolution = 256;
  for (const Placement placement : {Placement::grid, Placement::gauss}) {
    scene.radiosity.placement = placement;
    const std::string name(names_of<Placement>[std::size_t(placement)].id);
    add_settings(out, scene, name + "-", std::size_t(placement), {1, 2, 3, 4, 6, 8},
                 [](Radiosity& r, int samples) { r.samples = samples; });
  }
  out.references.push_back(closed_form_of(scene));
  return out;
}

Ladder resolution_ladder(const TradeRequest& request) {
  Ladder out;
  Scene scene = scene_of_few_patches(request);
  scene.radiosity.form_factors = FormFactors::hemicube;
  scene.radiosity.placement = Placement::gauss;
  for (const int samples : {1, 4}) {
    scene.radiosity.samples = samples;
    add_settings(out, scene, samples == 1 ? "centre-" : "gauss-", samples == 1 ? 0 : 1,
                 {16, 24, 32, 48, 64, 96, 128, 192, 256}, [](Radiosity& r, int pixels) { r.resolution = pixels; });
  }
  out.references.push_back(closed_form_of(scene));
  return out;
}

Ladder rays_ladder(const TradeRequest& request) {
  Ladder out;
  Scene scene = scene_of_few_patches(request);
  scene.radiosity.form_factors = FormFactors::monte_carlo;
  add_settings(out, scene, "monte-carlo-", 0, {64, 256, 1024, 4096, 16384, 65536},
               [](Radiosity& r, int rays) { r.rays = rays; });
  out.references.push_back(closed_form_of(scene));
  return out;
}

}  // namespace

Knob radiosity_positions_knob() {
  Knob k = form_factor_knob();
  k.id = "radiosity-positions";
  k.name = {"Positions on a patch", "パッチ上の位置の数"};
  k.help = {"S × S hemicubes a patch instead of one at its centre: this is where the accuracy of form factors is.",
            "中央の 1 か所でなく S × S 個のヘミキューブを置く。形態係数の精度を決めるのはこれ。"};
  k.parameter = "radiosity.samples";
  k.abscissa = {"S", {"positions a side", "一辺の位置の数"}};
  k.series = {{"grid", {"Uniform grid", "等間隔"}}, {"gauss", {"Gauss points", "ガウス点"}}};
  k.predictions = {{.series = 0,
                    .order = -2,
                    .law = "S^(-2)",
                    .why = {"The middles of a grid integrate over a patch by the midpoint rule: 1/S^2 of the error.",
                            "等間隔の中点で積分するのは中点則であり、誤差は 1/S^2 になる。"},
                    .otherwise = {"Pixels of the hemicube set a floor that positions only average.",
                                  "ヘミキューブの画素による誤差は、位置を増やしても平均されるだけで残る。"},
                    .source = "Philip Davis, Philip Rabinowitz, Methods of Numerical Integration, 1975"}};
  k.bend_low = {"one position is no integral yet.", "1 か所では積分になっていない。"};
  k.bend_high = {"the hemicube's pixels are what is left.", "残るのはヘミキューブの画素による誤差。"};
  k.ladder = positions_ladder;
  return k;
}

Knob radiosity_resolution_knob() {
  Knob k = form_factor_knob();
  k.id = "radiosity-resolution";
  k.name = {"Hemicube resolution", "ヘミキューブの解像度"};
  k.help = {"More pixels see the borders of patches more exactly; from the centre alone that hardly helps.",
            "画素を増やすと境界は正確になるが、中央の 1 か所だけではほとんど良くならない。"};
  k.parameter = "radiosity.resolution";
  k.abscissa = {"R", {"pixels a side", "一辺の画素数"}};
  k.series = {{"centre", {"Centre alone", "中央だけ"}}, {"gauss", {"4 × 4 Gauss points", "ガウス点 4 × 4"}}};
  k.predictions = {
      {.series = 0,
       .order = 0,
       .law = "R^0",
       .why = {"A point of the patch is taken for all of it, and no pixel can mend that.",
               "パッチ全体を 1 点で代表させた誤差は、画素を増やしても消えない。"},
       .source = "Daniel Baum, Holly Rushmeier, James Winget, Improving Radiosity Solutions Through the Use of "
                 "Analytically Determined Form-Factors, 1989"},
      {.series = 1,
       .order = -1.5,
       .law = "R^(-3/2)",
       .why =
           {"Hemicubes are turned, so a border crosses rows of pixels: some R errors, which cancel but for √R of R^2.",
            "ヘミキューブを回して置くので境界は画素の列を斜めに横切り、R 個ほどの誤差が打ち消し合って R^2 のうち √R "
            "だけ残る。"},
       .otherwise =
           {"Straight borders do better at most angles, up to R^(-2) (Maria Tarnopolska-Weiss, On the Number of "
            "Lattice Points in Planar Polygons, 1978). Those parallel to the normal run along pixels of the "
            "side faces: rows stand aside by quarters of a pixel there, which leaves a fourth of R^(-1).",
            "まっすぐな境界は多くの角度でもっと速く、R^(-2) まで減る（Maria Tarnopolska-Weiss, On the Number of "
            "Lattice Points in Planar Polygons, 1978）。法線に平行な境界は側面の画素の列に沿うので、列ごとに "
            "1/4 画素ずらしてあり、R^(-1) の誤差は 4 分の 1 になる。"},
       .source = "David Kendall, On the number of lattice points inside a random oval, 1948"}};
  k.bend_low = {"patches are few pixels large there.", "パッチが数画素しかない。"};
  k.bend_high = {"there the positions on the patch are what is left.", "残るのはパッチ上の位置による誤差。"};
  k.ladder = resolution_ladder;
  return k;
}

Knob radiosity_rays_knob() {
  Knob k = form_factor_knob();
  k.id = "radiosity-rays";
  k.name = {"Form factors by rays", "光線による形態係数"};
  k.help = {"Monte Carlo rays instead of hemicubes: no pixels, no bias, but noise.",
            "ヘミキューブの代わりにモンテカルロ法の光線を使う。画素も偏りもないが、ノイズがある。"};
  k.parameter = "radiosity.rays";
  k.abscissa = {"n", {"rays a patch", "パッチごとの光線数"}};
  k.series = {{"monte-carlo", {"Monte Carlo", "モンテカルロ法"}}};
  k.predictions = {{.order = -0.5,
                    .law = "n^(-1/2)",
                    .why = {"The mean of n random values scatters by their deviation over the root of n.",
                            "n 個の乱数の平均のばらつきは標準偏差の 1/√n になる。"},
                    .otherwise = {"Rays that are spread evenly do better.", "光線を均等に散らすともっと速く減る。"},
                    .source = "Nicholas Metropolis, Stanislaw Ulam, The Monte Carlo Method, 1949"}};
  k.bend_low = {"most patches are met by no ray there.", "多くのパッチに光線が一本も届かない。"};
  k.bend_high = {"the digits of float are what is left.", "残るのは float の丸め。"};
  k.ladder = rays_ladder;
  return k;
}

}  // namespace cg
