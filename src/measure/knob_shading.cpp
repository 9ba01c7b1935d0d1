// Shading mode and tessellation against the light model at each pixel of the finest mesh.
#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/tessellations.h"

namespace cg {

namespace {

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 512);
  const std::string technique = technique_of(request, "software");
  const Tessellations meshes = tessellations_of(request.scene);
  Ladder out;
  for (const ShadingMode mode : {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong})
    for (auto t = meshes.ladder.rbegin(); t != meshes.ladder.rend(); ++t) {
      const Name& name = names_of<ShadingMode>[std::size_t(mode)];
      Setting s;
      s.id = std::string(name.id) + "-" + std::to_string(t->level);
      s.label = {std::to_string(t->level), std::to_string(t->level)};
      s.series = std::size_t(mode);
      s.x = t->h;
      s.scene = t->scene;
      s.scene.shading.mode = mode;
      s.technique = technique;
      s.view = view;
      out.settings.push_back(std::move(s));
    }
  Scene finest = meshes.finest.scene;
  finest.shading.mode = ShadingMode::phong;
  out.references.push_back(reference_of(std::move(finest), view));
  return out;
}

}  // namespace

Knob shading_knob() {
  Knob k;
  k.id = "shading";
  k.name = {"Shading mode and tessellation", "シェーディング方式と細分割"};
  k.help = {
      "One colour a face, colours of vertices interpolated, or normals interpolated: how many triangles does each "
      "need for the same picture?",
      "面ごとに一色か、頂点の色を補間するか、法線を補間するか。同じ画質にそれぞれ三角形がいくつ要るかを見る。"};
  k.parameter = "objects.0.tessellation";
  k.abscissa = {"h", {"edge of an average triangle", "三角形の平均の辺長"}, "m"};
  k.reference = {"the light model at each pixel of the finest mesh, in double",
                 "最も細かいメッシュの画素ごとの光源計算（double）"};
  k.error = {"RMSE of linear colour over the pixels that both cover", "両方が覆う画素での線形な色の RMSE"};
  k.series = {{"flat", {"Flat", "フラット"}}, {"gouraud", {"Gouraud", "グロー"}}, {"phong", {"Phong", "フォン"}}};
  k.predictions = {
      {.series = 0,
       .order = 1,
       .law = "h^1",
       .why = {"A face has the colour of one of its points, so the error is the colour's gradient times h.",
               "面の色は一点での色なので、誤差は色の勾配と h の積になる。"},
       .source = "Henri Gouraud, Continuous Shading of Curved Surfaces, 1971"},
      {.series = 1,
       .order = 2,
       .law = "h^2",
       .why = {"Linear interpolation leaves the colour's curvature: its error is at most h^2/8 times the second "
               "derivative.",
               "線形補間では色の曲がりが残り、誤差は二階微分の h^2/8 倍以下になる。"},
       .source = "Philip Davis, Interpolation and Approximation, 1975"},
      {.series = 2,
       .order = 2,
       .law = "h^2",
       .why = {"Normals interpolated linearly, and points on the chord, are both off by h^2.",
               "線形補間した法線も、弦の上の点も、ずれは h^2 に比例する。"},
       .source = "Bui Tuong Phong, Illumination for Computer Generated Pictures, 1975"},
  };
  k.bend_fine = {"there the reference's own triangles are no longer small beside these.",
                 "基準のメッシュの三角形が、比べる三角形に対して十分小さくない。"};
  k.bend_coarse = {"there a triangle is wider than what it should show (a highlight, a handle).",
                   "三角形が、表すべきもの（ハイライトや取っ手）より大きい。"};
  k.ladder = ladder;
  return k;
}

}  // namespace cg
