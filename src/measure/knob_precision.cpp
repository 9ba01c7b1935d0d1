// float against double in the highlight's power (N.H)^n, over n.
#include "measure/knob_list.h"
#include "measure/ladder_parts.h"

namespace cg {

namespace {

Ladder ladder(const TradeRequest& request) {
  const View view = view_of(request, 512);
  technique_of(request, "software");
  Ladder out;
  for (const int n : {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048}) {
    Setting s;
    s.id = "float-" + std::to_string(n);
    s.label = {std::to_string(n), std::to_string(n)};
    s.x = n;
    s.scene = request.scene;
    s.scene.shading.mode = ShadingMode::phong;
    s.scene.shading.reflection = Reflection::half_vector;
    s.scene.shading.precision = Precision::single_precision;
    change_materials(s.scene, [n](Material& m) {
      m.k_a = m.k_d = m.emission = glm::dvec3(0);
      m.k_s = glm::dvec3(1);
      m.n = n;
    });
    s.technique = "software";
    s.view = view;
    s.reference = out.references.size();
    out.references.push_back(reference_of(s.scene, view));
    out.references.back().id = "double-" + std::to_string(n);
    out.settings.push_back(std::move(s));
  }
  return out;
}

}  // namespace

Knob precision_knob() {
  Knob k;
  k.id = "precision";
  k.name = {"float or double", "float と double"};
  k.help = {"The highlight alone, in float against double: the power multiplies the rounding of its base by n.",
            "ハイライトだけを float と double で比べる。累乗は底の丸め誤差を n 倍にする。"};
  k.parameter = "shading.precision";
  k.abscissa = {"n", {"shininess", "鏡面反射の鋭さ"}};
  k.reference = {"the same highlight in double", "double で計算した同じハイライト"};
  k.error = {"largest error of the linear highlight", "線形なハイライトの最大誤差"};
  k.plotted = ErrorKind::max;
  k.series = {{"float", {"float", "float"}}};
  k.predictions = {{.of = ErrorKind::max,
                    .order = 1,
                    .law = "n^1",
                    .why = {"d(c^n) = n c^(n-1) dc, and dc is about 2^-24 where c is near 1.",
                            "d(c^n) = n c^(n-1) dc で、c が 1 に近い所では dc は 2^-24 ほど。"},
                    .source = "Nicholas Higham, Accuracy and Stability of Numerical Algorithms, 2002"},
                   {.of = ErrorKind::rmse,
                    .order = 0.5,
                    .law = "n^(1/2)",
                    .why = {"The highlight's area shrinks as 1/n, so the root of the mean grows as n/√n.",
                            "ハイライトの面積は 1/n で縮むので、二乗平均の根は n/√n で増える。"},
                    .source = "Nicholas Higham, Accuracy and Stability of Numerical Algorithms, 2002"}};
  k.bend_high = {"above n = 128 the power is computed from the sine of the angle, which keeps its digits.",
                 "n が 128 を超えると角度の正弦から累乗を計算し、桁を失わない。"};
  k.bend_low = {"there the rounding of everything else, about 2^-24, is all there is.",
                "ほかの計算の丸め（2^-24 ほど）だけが残る。"};
  k.ladder = ladder;
  return k;
}

}  // namespace cg
