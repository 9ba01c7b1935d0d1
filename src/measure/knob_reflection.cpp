// The half vector's highlight at four times the exponent against the reflection vector's.
#include "measure/knob_list.h"
#include "measure/ladder_parts.h"

namespace cg {

namespace {

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 512);
  const std::string technique = technique_of(request, "software");
  Ladder out;
  for (const int n : {2, 4, 8, 16, 32, 64, 128, 256, 512, 1024}) {
    Scene scene = request.scene;
    scene.shading.mode = ShadingMode::phong;
    scene.shading.clamp = false;  // the highlights are compared, not where they are cut off
    Scene lecture = scene;
    lecture.shading.reflection = Reflection::reflection_vector;
    change_materials(lecture, [n](Material& m) { m.n = n; });
    scene.shading.reflection = Reflection::half_vector;
    change_materials(scene, [n](Material& m) { m.n = 4 * n; });
    Setting s;
    s.id = "half-vector-" + std::to_string(4 * n);
    s.label = {std::to_string(n), std::to_string(n)};
    s.x = n;
    s.scene = std::move(scene);
    s.technique = technique;
    s.view = view;
    s.reference = out.references.size();
    out.references.push_back(reference_of(std::move(lecture), view));
    out.references.back().id = "reflection-vector-" + std::to_string(n);
    out.settings.push_back(std::move(s));
  }
  return out;
}

}  // namespace

// Tilt N by a small angle d away from H. In the plane of L and V, R turns by 2d: (R.V)^n = cos^n 2d and (N.H)^4n =
// cos^4n d agree to d^2. Across that plane R turns by 2d cos t only, t the angle between L and H: exp(-2 n d^2 cos^2 t)
// against exp(-2 n d^2). In units of 1/sqrt(n) the two lobes keep their shapes, so their largest difference is a
// constant, and the area over which they differ shrinks as 1/n.
Knob reflection_knob() {
  Knob k;
  k.id = "reflection";
  k.name = {"Half vector or reflection vector", "ハーフベクトルと反射ベクトル"};
  k.help = {
      "(N·H)^n with 4n is said to equal (R·V)^n. It does in the plane of L and V; across it the highlight of N·H "
      "is narrower, the more so the more oblique the light.",
      "(N·H) の指数を 4n にすると (R·V)^n と等しいと言われる。L と V の面内ではそのとおりだが、面に垂直な方向では N·H "
      "のハイライトが狭く、光が斜めなほど差が大きい。"};
  k.parameter = "shading.reflection";
  k.abscissa = {"n", {"exponent of R·V", "R·V の指数"}};
  k.reference = {"(R·V)^n at each pixel, in double", "画素ごとの (R·V)^n（double）"};
  k.error = {"RMSE of linear colour over the object's pixels", "物体の画素での線形な色の RMSE"};
  k.series = {{"half-vector", {"(N·H) with 4n", "(N·H)、指数 4n"}}};
  k.predictions = {
      {.of = ErrorKind::rmse,
       .order = -0.5,
       .law = "n^(-1/2)",
       .why = {"The two lobes keep their shapes while their area shrinks as 1/n.",
               "二つの山は形を保ったまま、面積が 1/n で縮む。"},
       .otherwise =
           {"Where the surface bends in one direction only (a rim, a handle) the highlight is a strip: its area "
            "shrinks as n^(-1/2), and the error as n^(-1/4).",
            "一方向にだけ曲がる面（縁や取っ手）ではハイライトが帯になり、面積は n^(-1/2)、誤差は n^(-1/4) で縮む。"},
       .source = "James Blinn, Models of Light Reflection, 1977; Frederick Fisher and Andrew Woo, R.E versus N.H "
                 "Specular Highlights, 1994"},
      {.of = ErrorKind::max,
       .order = 0,
       .law = "n^0",
       .why =
           {"Across the plane of L and V the widths differ by the cosine of half the angle between them, whatever n.",
            "L と V の面に垂直な方向では、幅の比は両者のなす角の半分の余弦で、n によらない。"},
       .source = "Frederick Fisher and Andrew Woo, R.E versus N.H Specular Highlights, 1994"}};
  k.bend_high = {"there a highlight is only a few pixels wide.", "ハイライトの幅が数画素しかない。"};
  k.bend_low = {"there a highlight is as wide as the object, and the surface's bend counts.",
                "ハイライトが物体と同じくらい広く、面の曲がりが効く。"};
  k.ladder = ladder;
  return k;
}

}  // namespace cg
