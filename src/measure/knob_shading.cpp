// Shading mode and tessellation against the light model at each pixel of the finest mesh.
#include <cmath>

#include "measure/knob_list.h"
#include "measure/ladder_parts.h"
#include "measure/tessellations.h"

namespace cg {

namespace {

void add_steps(const Tessellations& meshes, const Setting& common, ShadingMode mode, Ladder& out) {
  for (auto t = meshes.ladder.rbegin(); t != meshes.ladder.rend(); ++t) {
    Setting s = common;
    s.id = std::string(names_of<ShadingMode>[std::size_t(mode)].id) + "-" + std::to_string(t->level);
    s.label = {std::to_string(t->level), std::to_string(t->level)};
    s.x = t->h;
    s.scene = t->scene;
    s.scene.shading.mode = mode;
    out.settings.push_back(std::move(s));
  }
}

Ladder ladder_of(const TradeRequest& request, const Scene& scene, std::span<const ShadingMode> modes) {
  Setting common;
  common.view = view_of(request, 512);
  common.technique = technique_of(request, "software");
  const Tessellations meshes = tessellations_of(scene);
  Ladder out;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    common.series = i;
    add_steps(meshes, common, modes[i], out);
  }
  Scene finest = meshes.finest.scene;
  finest.shading.mode = ShadingMode::phong;
  out.references.push_back(reference_of(std::move(finest), common.view));
  out.references.back().view.normals = true;
  return out;
}

// The light at the eye: no point in view turns away from it, so that the colour has no kink, nor one where it is cut
// off.
Ladder smooth_ladder(const TradeRequest& request) {
  Scene scene = request.scene;
  Light light = scene.lights.empty() ? Light{} : scene.lights.front();
  light.enabled = true;
  light.kind = LightKind::point;
  light.position = scene.camera.position;
  light.w = 1;
  scene.lights = {light};
  scene.shading.clamp = false;
  constexpr ShadingMode modes[] = {ShadingMode::flat, ShadingMode::gouraud, ShadingMode::phong};
  return ladder_of(request, scene, modes);
}

constexpr Words surface_edges = {
    "Where the surface itself has an edge the mesh's lies h^2 beside it and the colour jumps, which makes h^1; at a "
    "seam "
    "or a tip the normal turns within one triangle, which makes h^(3/2).",
    "面に稜線があるとメッシュの稜線は h^2 だけずれ、そこで色が跳ぶので h^1 "
    "になる。継ぎ目や先端では一つの三角形の中で法線が急に回り、"
    "h^(3/2) になる。"};

Ladder terminator_ladder(const TradeRequest& request) {
  constexpr ShadingMode modes[] = {ShadingMode::gouraud};
  return ladder_of(request, request.scene, modes);
}

// Of the pixels in which both show the same part of the surface, and that faces the eye: elsewhere it is the outline
// that is off. A chord of length h runs at most h/2 before or behind its arc, also where the surface turns away.
// Towards the outline, at the distance d from it, the normal turns as 1/√d, so that the error there would be h^2
// √ln(1/h).
Errors errors_of_one_surface(const Setting& setting, const Frame& frame, const Setting& reference, const Frame& exact) {
  constexpr float facing = 0.25f;  // N.V
  const Camera& camera = setting.scene.camera;
  const glm::vec3 towards_eye(unit(camera.position - camera.target));
  const auto depth = [](const Frame& f, std::size_t i, const Setting& s) {
    return eye_depth(double(f.depth.pixels()[i]), s.scene.camera);
  };
  Frame same = frame;
  for (std::size_t i = 0; i < same.covered.size(); ++i)
    if (!(std::abs(depth(frame, i, setting) - depth(exact, i, reference)) < setting.x) ||
        glm::dot(exact.normal.pixels()[i], towards_eye) < facing)
      same.covered.pixels()[i] = 0;
  return colour_errors(setting, same, reference, exact);
}

}  // namespace

Knob shading_knob() {
  Knob k;
  k.id = "shading";
  k.name = {"Shading mode and tessellation", "シェーディング方式と細分割"};
  k.help = {
      "One colour a face, colours of vertices interpolated, or normals interpolated: how many triangles does each need "
      "for the same picture? The light stands at the eye, so that no shadow side is in view.",
      "面ごとに一色か、頂点の色を補間するか、法線を補間するか。同じ画質にそれぞれ三角形がいくつ要るかを見る。"
      "光源は視点に置き、陰の側が見えないようにする。"};
  k.parameter = "objects.0.tessellation";
  k.abscissa = {"h", {"edge of an average triangle", "三角形の平均の辺長"}, "m"};
  k.labels = {"level of tessellation", "細分割のレベル"};
  k.reference = {"the light model at each pixel of the finest mesh, in double",
                 "最も細かいメッシュの画素ごとの光源計算（double）"};
  k.error = {"RMSE of linear colour where both show the same part, N·V > 1/4",
             "同じ部分が見え N·V > 1/4 の画素での線形な色の RMSE"};
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
       .otherwise = surface_edges,
       .source = "Philip Davis, Interpolation and Approximation, 1975"},
      {.series = 2,
       .order = 2,
       .law = "h^2",
       .why = {"Normals interpolated linearly, and points on the chord, are both off by h^2.",
               "線形補間した法線も、弦の上の点も、ずれは h^2 に比例する。"},
       .otherwise = surface_edges,
       .source = "Bui Tuong Phong, Illumination for Computer Generated Pictures, 1975"},
  };
  k.bend_low = {"there the reference's own triangles are no longer small beside these.",
                "基準のメッシュの三角形が、比べる三角形に対して十分小さくない。"};
  k.bend_high = {"there a triangle is wider than what it should show (a highlight, a handle).",
                 "三角形が、表すべきもの（ハイライトや取っ手）より大きい。"};
  k.ladder = smooth_ladder;
  k.errors = errors_of_one_surface;
  return k;
}

Knob terminator_knob() {
  Knob k = shading_knob();
  k.id = "terminator";
  k.name = {"Gouraud shading at the terminator", "明暗境界でのグローシェーディング"};
  k.help = {
      "The scene in its own light: where light turns to shadow the colour has a kink, which lines between vertices "
      "cut off.",
      "シーンの光源のまま測る。明るい側と暗い側の境では色が折れ曲がり、頂点の間の直線がその角を切り落とす。"};
  k.series = {{"gouraud", {"Gouraud", "グロー"}}};
  k.predictions = {
      {.order = 1.5,
       .law = "h^(3/2)",
       .why = {"Along a kink the error is of order h in a band h wide: its share of the picture is h, and "
               "the RMSE h√h.",
               "折れ目に沿った幅 h の帯で誤差は h に比例する。帯の面積の割合も h なので、RMSE は h√h になる。"},
       .otherwise = {"Without a terminator or a highlight that is cut off in view it is h^2.",
                     "明暗境界や上限で切られたハイライトが見えていなければ h^2 になる。"},
       .source = "Philip Davis, Interpolation and Approximation, 1975; the kink of max(N·L, 0)"}};
  k.ladder = terminator_ladder;
  return k;
}

}  // namespace cg
