// The near plane's distance against the precision of depth: in metres, and in pixels that show the wrong surface.
#include <algorithm>
#include <cmath>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/verdict.h"
#include "params/numbers.h"
#include "workbench/model_library.h"

namespace cg {

namespace {

constexpr std::string_view source =
    "Kurt Akeley and Jonathan Su, Minimum Triangle Separation for Correct z-Buffer Occlusion, 2006";

// From `first` half decades below the nearest thing on, `count` of them; the reference stands half way to that thing.
Ladder near_ladder(const TradeRequest& request, const Scene& scene, int first, int count, bool ids) {
  View view = view_of(request, 512);
  view.ids = ids;
  const std::string technique = technique_of(request, "software");
  const double most = 0.5 * nearest_depth(scene);
  Ladder out;
  for (int step = first + count - 1; step >= first; --step) {
    Setting s;
    const std::string text = short_number(std::pow(10.0, (std::round(2 * std::log10(most)) - step) / 2), 2);
    s.x = parse_number(text).value_or(1);
    s.id = "near-" + text;
    s.label = {text, text};
    s.scene = scene;
    s.scene.camera.near_plane = s.x;
    s.technique = technique;
    s.view = view;
    out.settings.push_back(std::move(s));
  }
  Scene near = scene;
  near.camera.near_plane = most;
  out.references.push_back(reference_of(std::move(near), view));
  out.references.back().technique = technique;
  return out;
}

Errors depth_errors(const Setting& setting, const Frame& frame, const Setting& reference, const Frame& exact) {
  Errors out;
  double squares = 0;
  for (std::size_t i = 0; i < std::min(frame.depth.size(), exact.depth.size()); ++i) {
    if (!frame.covered.pixels()[i] || !exact.covered.pixels()[i]) continue;
    const double off = std::abs(eye_depth(double(frame.depth.pixels()[i]), setting.scene.camera) -
                                eye_depth(double(exact.depth.pixels()[i]), reference.scene.camera));
    squares += off * off;
    out.max = std::max(out.max, off);
    ++out.samples;
  }
  if (out.samples) out.rmse = std::sqrt(squares / double(out.samples));
  return out;
}

Ladder depth_ladder(const TradeRequest& request) { return near_ladder(request, request.scene, 2, 9, false); }

// Beside each object a copy of it, a centimetre to the right and of another colour: the two cross where the surface
// runs along that shift, at all angles.
Ladder fighting_ladder(const TradeRequest& request) {
  Scene scene = request.scene;
  const std::size_t count = scene.objects.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!scene.objects[i].visible) continue;
    Object copy = scene.objects[i];
    copy.name += " 2";
    copy.transform.translate.x += 0.01;
    copy.own_material = true;
    copy.material = material_of(scene, scene.objects[i]);
    copy.material.k_d = {0.8, 0.2, 0.1};
    scene.objects.push_back(std::move(copy));
  }
  load_meshes(scene);
  return near_ladder(request, scene, 1, 8, true);
}

// The share of the pixels that show another object than the reference does.
Errors object_errors(const Setting&, const Frame& frame, const Setting&, const Frame& exact) {
  Errors out;
  std::size_t off = 0;
  for (std::size_t i = 0; i < std::min(frame.object.size(), exact.object.size()); ++i) {
    if (exact.object.pixels()[i] == nothing) continue;
    ++out.samples;
    off += frame.object.pixels()[i] != exact.object.pixels()[i];
  }
  if (out.samples) out.rmse = out.max = double(off) / double(out.samples);
  return out;
}

Knob near_knob() {
  Knob k;
  k.parameter = "camera.near";
  k.abscissa = {"near", {"distance of the near plane", "前方クリップ面の距離"}, "m"};
  return k;
}

}  // namespace

Knob near_plane_knob() {
  Knob k = near_knob();
  k.id = "near-plane";
  k.name = {"Near plane and depth precision", "前方クリップ面と奥行きの精度"};
  k.help = {
      "Depth is stored as 1 - near/z: the nearer the near plane, the fewer steps are left for what is seen. It "
      "costs no time at all.",
      "奥行きは 1 - near/z の形で保存される。クリップ面が近いほど、見えるものに残る段が減る。時間は少しもかからない。"};
  k.reference = {"the near plane half way to the nearest thing",
                 "最も近い物体までの半分の位置にクリップ面を置いたもの"};
  k.error = {"RMSE of the depth over the pixels that both cover", "両方が覆う画素での奥行きの RMSE"};
  k.error_unit = "m";
  k.series = {{"depth", {"Depth", "奥行き"}}};
  k.predictions = {{.order = -1,
                    .law = "near^-1",
                    .why = {"One step of the stored depth is z^2/near times that step in metres.",
                            "保存された奥行きの 1 段は、距離にしてその z^2/near 倍になる。"},
                    .source = source}};
  k.bend_high = {"there the near plane is not small beside z, and the reference is no better.",
                 "クリップ面の距離が z に近く、基準の精度も変わらない。"};
  k.bend_low = {"there depths round to 1, and pixels are lost.", "奥行きが 1 に丸められ、画素が失われる。"};
  k.ladder = depth_ladder;
  k.errors = depth_errors;
  return k;
}

Knob z_fighting_knob() {
  Knob k = near_knob();
  k.id = "z-fighting";
  k.name = {"Near plane and z-fighting", "前方クリップ面と z ファイティング"};
  k.help = {"Each object has a copy a centimetre to its right; where the two cross, depth must tell them apart.",
            "各物体の 1 cm 右に複製を置く。二つの面が交わる所では、奥行きだけが前後を決める。"};
  k.reference = {"the near plane half way to the nearest thing",
                 "最も近い物体までの半分の位置にクリップ面を置いたもの"};
  k.error = {"share of the pixels that show the wrong object", "違う物体が見える画素の割合"};
  k.series = {{"z-fighting", {"Wrong pixels", "誤った画素"}}};
  k.predictions = {{.order = -1,
                    .law = "near^-1",
                    .why = {"Pixels go wrong where the gap of the crossing surfaces is below a step of depth, and that "
                            "step grows as 1/near.",
                            "交わる面の隙間が奥行きの 1 段より狭い画素で誤り、1 段は 1/near で広がる。"},
                    .source = source}};
  k.bend_high = {"there only a handful of pixels are wrong.", "誤る画素が数えるほどしかない。"};
  k.bend_low = {"there the gap is below a step nearly everywhere: no more than about half the pixels can be wrong.",
                "ほとんどの場所で隙間が 1 段より狭い。誤る画素は約半分で頭打ちになる。"};
  k.ladder = fighting_ladder;
  k.errors = object_errors;
  return k;
}

}  // namespace cg
