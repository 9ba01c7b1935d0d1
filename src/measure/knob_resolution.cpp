// A small picture, its pixels repeated, against a large one.
#include "measure/knob_list.h"
#include "measure/ladder_parts.h"

namespace cg {

namespace {

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 1024);
  const std::string technique = technique_of(request, "software");
  Ladder out;
  for (const int factor : {2, 4, 8, 16, 32, 64}) {
    Setting s;
    s.view = {view.width / factor, view.height / factor, request.threads};
    if (s.view.width * factor != view.width || s.view.height * factor != view.height) break;
    s.id = "size-" + std::to_string(s.view.width);
    s.label = {std::to_string(s.view.width), std::to_string(s.view.width)};
    s.x = factor;
    s.scene = request.scene;
    s.technique = technique;
    s.resampling = Resampling::nearest;
    s.factor = factor;
    out.settings.push_back(std::move(s));
  }
  out.references.push_back(reference_of(request.scene, view));
  return out;
}

}  // namespace

Knob resolution_knob() {
  Knob k;
  k.id = "resolution";
  k.name = {"Resolution", "解像度"};
  k.help = {"A smaller picture, its pixels repeated until it is as large: what the window shows while a slider moves.",
            "小さく描いた画像の画素を並べて拡大する。スライダを動かす間にウィンドウが見せるもの。"};
  k.parameter = "--size";
  k.abscissa = {"h", {"side of a pixel, in the large picture's", "画素の辺（大きい画像の画素が単位）"}, "pixel"};
  k.labels = {"pixels across", "横の画素数"};
  k.reference = {"the large picture", "大きい画像"};
  k.error = {"RMSE of linear colour over the whole picture", "画像全体での線形な色の RMSE"};
  k.series = {{"nearest", {"Pixels repeated", "画素の繰り返し"}}};
  k.predictions = {
      {.order = 0.5,
       .law = "h^(1/2)",
       .why = {"Along an edge a band about h/4 wide has the wrong colour altogether; its share of the "
               "picture is proportional to h, and the RMSE to the root.",
               "輪郭に沿った幅 h/4 ほどの帯で色がまったく違う。帯の割合は h に比例し、RMSE はその平方根に比例する。"},
       .source = "Stéphane Mallat, A Wavelet Tour of Signal Processing, 2009, chapter 9 (linear "
                 "approximation of images with edges)"}};
  k.bend_low = {"there the shading inside the edges, whose error goes as h, is no longer small.",
                "輪郭の内側の陰影（誤差は h に比例）が無視できなくなる。"};
  k.bend_high = {"there parts of the shape are narrower than a pixel.", "形の一部が画素より細い。"};
  k.ladder = ladder;
  k.errors = colour_errors_everywhere;
  return k;
}

}  // namespace cg
