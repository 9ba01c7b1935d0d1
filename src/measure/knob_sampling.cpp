// Several samples a pixel, in software and by OpenGL's multisampling, against 1024.
#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "params/input_error.h"
#include "workbench/technique_list.h"

namespace cg {

namespace {

// 1024 samples a pixel make a picture 32 times as wide: 9 million samples here.
constexpr int own_size = 96, finest = 32;

constexpr Words lattice_why = {
    "A square grid of N samples misjudges an edge's area by the root of its perimeter, N^(1/4) of N samples.",
    "N 個の格子点で数える面積の誤差は周長の平方根、つまり N 個中 N^(1/4) 個ほど。"};
constexpr Words lattice_otherwise = {
    "The law holds for edges at random places on the average; one picture with few edges scatters about it.",
    "この法則は輪郭の位置について平均したもので、輪郭の少ない一枚の画像ではばらつく。"};
constexpr std::string_view lattice_source =
    "David Kendall, On the number of lattice points inside a random oval, 1948; Don Mitchell, Consequences of "
    "Stratified Sampling in Graphics, 1996";

Setting reference_with(const Scene& scene, const View& picture, Resampling filter) {
  Setting reference = reference_of(scene, picture);
  oversample(reference, picture, finest, filter);
  reference.id = std::string(filter == Resampling::box ? "box" : "tent") + "-1024";
  return reference;
}

Ladder supersampling_ladder(const TradeRequest& request) {
  const View picture = view_of(request, own_size);
  const std::string technique = technique_of(request, "software");
  Ladder out;
  for (const Resampling filter : {Resampling::box, Resampling::tent}) {
    const bool box = filter == Resampling::box;
    for (const int m : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14}) {
      Setting s;
      const std::string samples = std::to_string(m * m);
      s.id = std::string(box ? "box-" : "tent-") + samples;
      s.label = {samples, samples};
      s.series = box ? 0 : 1;
      s.x = m * m;
      s.scene = request.scene;
      s.technique = technique;
      s.view.threads = request.threads;
      oversample(s, picture, m, filter);
      s.reference = out.references.size();
      out.settings.push_back(std::move(s));
    }
    out.references.push_back(reference_with(request.scene, picture, filter));
  }
  return out;
}

Ladder multisampling_ladder(const TradeRequest& request) {
  const View picture = view_of(request, own_size);
  const Technique& gl = find_technique(request.techniques, technique_of(request, "gl"));
  if (!gl.most_samples)
    throw InputError(gl.id, {"this technique has no multisampling", "この手法にマルチサンプリングはない"},
                     {"gl has it", "gl が使える"});
  const int most = gl.most_samples();
  Ladder out;
  for (int samples = 1; samples <= std::min(most, 64); samples *= 2) {
    Setting s;
    s.id = "msaa-" + std::to_string(samples);
    s.label = {std::to_string(samples), std::to_string(samples)};
    s.x = samples;
    s.scene = request.scene;
    s.technique = gl.id;
    s.view = picture;
    s.view.samples = samples;
    out.settings.push_back(std::move(s));
  }
  if (most < 16) {
    const std::string n = std::to_string(most);
    out.notes.push_back({"This driver offers " + n + " samples at most: the line has few points.",
                         "このドライバーのサンプル数は最大 " + n + " なので、点が少ない。"});
    out.notes.push_back({"A driver may take more samples than asked for; points with the same error show where it did.",
                         "ドライバーは求めた数より多いサンプルを使ってもよい。誤差が等しい点はその場合に当たる。"});
  }
  out.references.push_back(reference_with(request.scene, picture, Resampling::box));
  return out;
}

}  // namespace

Knob supersampling_knob() {
  Knob k;
  k.id = "supersampling";
  k.name = {"Supersampling", "スーパーサンプリング"};
  k.help = {
      "The picture is drawn larger and filtered down: each pixel is the mean of N samples (box), or weighted by "
      "a tent two pixels wide.",
      "大きく描いて縮める。画素は N 個のサンプルの平均（ボックス）か、幅 2 "
      "画素の三角形の重み付き平均（テント）になる。"};
  k.parameter = "--size";
  k.abscissa = {"N", {"samples a pixel", "1 画素のサンプル数"}};
  k.reference = {"1024 samples a pixel with the same filter", "同じフィルターで 1 画素 1024 サンプル"};
  k.error = {"RMSE of linear colour over the whole picture", "画像全体での線形な色の RMSE"};
  k.series = {{"box", {"Box", "ボックス"}}, {"tent", {"Tent", "テント"}}};
  k.predictions = {{.series = 0,
                    .order = -0.75,
                    .law = "N^(-3/4)",
                    .why = lattice_why,
                    .otherwise = lattice_otherwise,
                    .source = lattice_source},
                   {.series = 1,
                    .order = -0.75,
                    .law = "N^(-3/4)",
                    .why = lattice_why,
                    .otherwise = lattice_otherwise,
                    .source = lattice_source}};
  k.bend_high = {"there the reference's own 1024 samples are not many more.",
                 "基準の 1024 サンプルが、比べるサンプル数に対して十分多くない。"};
  k.bend_low = {"there a pixel has too few samples for the law of large numbers.",
                "サンプルが少なすぎて、多数の平均としての法則が成り立たない。"};
  k.ladder = supersampling_ladder;
  k.errors = colour_errors_everywhere;
  return k;
}

Knob multisampling_knob() {
  Knob k;
  k.id = "multisampling";
  k.name = {"Multisampling in OpenGL", "OpenGL のマルチサンプリング"};
  k.help = {"Coverage is sampled several times a pixel, the colour once: edges become smooth, highlights do not.",
            "画素ごとに被覆だけを何度も調べ、色は一度だけ計算する。輪郭は滑らかになるが、ハイライトは変わらない。"};
  k.parameter = "GL_SAMPLES";
  k.abscissa = {"N", {"samples a pixel", "1 画素のサンプル数"}};
  k.reference = {"1024 samples a pixel in software, mean", "ソフトウェアによる 1 画素 1024 サンプルの平均"};
  k.error = {"RMSE of linear colour over the whole picture", "画像全体での線形な色の RMSE"};
  k.series = {{"msaa", {"Multisampling", "マルチサンプリング"}}};
  k.predictions = {
      {.order = -0.75,
       .law = "N^(-3/4)",
       .why = {"One sample in each of N strata of a pixel: the strata that an edge crosses number √N.",
               "画素を N 区画に分けて 1 サンプルずつ取ると、輪郭が横切る区画は √N 個になる。"},
       .otherwise = {"Inside the triangles the colour is still computed once a pixel, at a point that may "
                     "lie outside of what is covered: that error stays, however many samples there are.",
                     "三角形の内側では色を画素ごとに一度しか計算せず、その点は覆われた部分の外のこともある。"
                     "この誤差はサンプルを増やしても残る。"},
       .source = "Don Mitchell, Consequences of Stratified Sampling in Graphics, 1996"}};
  k.bend_high = {"there what is left is inside the triangles, where multisampling computes one colour a pixel.",
                 "残る誤差は三角形の内側にあり、そこでは色を画素ごとに一度しか計算しない。"};
  k.bend_low = {"there a pixel has too few samples for the law of large numbers.",
                "サンプルが少なすぎて、多数の平均としての法則が成り立たない。"};
  k.ladder = multisampling_ladder;
  k.errors = colour_errors_everywhere;
  return k;
}

}  // namespace cg
