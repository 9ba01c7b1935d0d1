// The silhouette of a polygon mesh against that of the finest one.
#include <algorithm>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/tessellations.h"

namespace cg {

namespace {

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 1024);
  const std::string technique = technique_of(request, "software");
  const Tessellations meshes = tessellations_of(request.scene);
  Ladder out;
  for (auto t = meshes.ladder.rbegin(); t != meshes.ladder.rend(); ++t) {
    Setting s;
    s.id = "silhouette-" + std::to_string(t->level);
    s.label = {std::to_string(t->level), std::to_string(t->level)};
    s.x = t->h;
    s.scene = t->scene;
    s.technique = technique;
    s.view = view;
    out.settings.push_back(std::move(s));
  }
  out.references.push_back(reference_of(meshes.finest.scene, view));
  return out;
}

// The share of the reference's pixels that one covers and the other does not.
Errors coverage_errors(const Setting&, const Frame& frame, const Setting&, const Frame& reference) {
  Errors out;
  std::size_t off = 0;
  for (std::size_t i = 0; i < std::min(frame.covered.size(), reference.covered.size()); ++i) {
    const bool a = frame.covered.pixels()[i] != 0, b = reference.covered.pixels()[i] != 0;
    out.samples += b;
    off += a != b;
  }
  if (out.samples) out.rmse = out.max = double(off) / double(out.samples);
  return out;
}

}  // namespace

Knob silhouette_knob() {
  Knob k;
  k.id = "silhouette";
  k.name = {"Tessellation and silhouette", "細分割と輪郭"};
  k.help = {"Shading can hide that a mesh has corners; its outline cannot. How many pixels does it miss?",
            "シェーディングは多面体の角を隠せるが、輪郭は隠せない。輪郭は何画素ずれるか。"};
  k.parameter = "objects.0.tessellation";
  k.abscissa = {"h", {"edge of an average triangle", "三角形の平均の辺長"}, "m"};
  k.labels = {"level of tessellation", "細分割のレベル"};
  k.reference = {"the outline of the finest mesh", "最も細かいメッシュの輪郭"};
  k.error = {"pixels covered by one alone, as a share of the object's", "片方だけが覆う画素の、物体の画素に対する割合"};
  k.series = {{"silhouette", {"Silhouette", "輪郭"}}};
  k.predictions = {{.order = 2,
                    .law = "h^2",
                    .why = {"A chord of length h lies h^2/8R inside an arc of radius R, all along the outline.",
                            "長さ h の弦は半径 R の弧より h^2/8R だけ内側にあり、輪郭全体でそうなる。"},
                    .source = "Henri Gouraud, Continuous Shading of Curved Surfaces, 1971; the sagitta of an arc"}};
  k.bend_low = {"there the outlines are a fraction of a pixel apart, and the reference has corners too.",
                "輪郭のずれが画素より小さく、基準にも角がある。"};
  k.bend_high = {"there whole parts of the shape are missing.", "形の一部がなくなるほど粗い。"};
  k.ladder = ladder;
  k.errors = coverage_errors;
  return k;
}

}  // namespace cg
