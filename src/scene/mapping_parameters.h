// Where a mesh's uv come from: a projector that stands in the scene (automatic mapping), or an unwrap along seams
// (manual mapping).
#pragma once
#include <vector>

#include "scene/camera.h"
#include "scene/transform.h"

namespace cg {

enum class ProjectionShape { planar, cylindrical, spherical, box, view };
template <>
inline constexpr std::array<Name, 5> names_of<ProjectionShape>{{{"planar", {"Planar", "平面"}},
                                                                {"cylindrical", {"Cylindrical", "円筒"}},
                                                                {"spherical", {"Spherical (polar)", "球（極座標）"}},
                                                                {"box", {"Box", "直方体"}},
                                                                {"view", {"From view", "視点から"}}}};

struct Projector {
  ProjectionShape shape = ProjectionShape::spherical;
  Transform place;
  double repeat_u = 1, repeat_v = 1;
  Camera view;
  double aspect = 1;
  friend bool operator==(const Projector&, const Projector&) = default;
};

template <>
inline constexpr auto fields_of<Projector> = std::tuple{
    field(&Projector::shape,
          {.name = "shape",
           .label = {"Projection", "投影"},
           .help = {"The surface that the texture is wrapped around before it is projected onto the object.",
                    "物体に投影する前に、テクスチャを巻きつける面。"}}),
    field(&Projector::place,
          {.name = "place",
           .label = {"Projector", "投影器"},
           .help = {"Where the projector stands. Planar: the square from -1 to 1, seen along z. Cylinder and sphere: "
                    "around y, the cylinder from -1 to 1.",
                    "投影器の位置と向き。平面は z 方向から見た -1〜1 の正方形。円筒と球は y 軸のまわりで、"
                    "円筒の高さは -1〜1。"}}),
    field(&Projector::repeat_u, {.name = "repeat_u",
                                 .range = {-1e4, 1e4},
                                 .slider = Range{1, 16},
                                 .label = {"Repeats in u", "u の繰り返し"},
                                 .help = {"How often the texture stands side by side; a whole number closes the seam.",
                                          "横に並べる枚数。整数なら継ぎ目が合う。"}}),
    field(&Projector::repeat_v, {.name = "repeat_v",
                                 .range = {-1e4, 1e4},
                                 .slider = Range{1, 16},
                                 .label = {"Repeats in v", "v の繰り返し"},
                                 .help = {"How often the texture stands one above the other.", "縦に並べる枚数。"}}),
    field(&Projector::view, {.name = "view",
                             .label = {"View", "視点"},
                             .help = {"Of “from view”: the camera that throws the texture like a slide.",
                                      "「視点から」で、スライドのようにテクスチャを投影するカメラ。"}}),
    field(&Projector::aspect, {.name = "aspect",
                               .range = {1e-3, 1e3},
                               .slider = Range{0.25, 4},
                               .scale = Scale::logarithmic,
                               .label = {"Aspect", "縦横比"},
                               .help = {"Of “from view”: width over height.", "「視点から」の画面の幅 ÷ 高さ。"}}),
};
static_assert(well_described<Projector>());

// A mesh edge along which the unwrap is cut: the indices of its two positions.
struct SeamEdge {
  int a = 0, b = 1;
  friend bool operator==(const SeamEdge&, const SeamEdge&) = default;
};
template <>
inline constexpr auto fields_of<SeamEdge> = std::tuple{
    field(&SeamEdge::a, {.name = "a", .range = {0, 2147483647}, .label = {"Vertex", "頂点"}}),
    field(&SeamEdge::b, {.name = "b", .range = {0, 2147483647}, .label = {"Other vertex", "もう一方の頂点"}}),
};
static_assert(well_described<SeamEdge>());

inline constexpr std::size_t most_seams = std::size_t(1) << 20;  // of an object

// How a chart is flattened.
enum class UnwrapMethod { lscm, spectral, mean_value, free_boundary };
template <>
inline constexpr std::array<Name, 4> names_of<UnwrapMethod>{
    {{"lscm", {"Least squares conformal", "最小二乗等角写像（LSCM）"}},
     {"spectral", {"Spectral conformal", "スペクトル等角写像"}},
     {"mean-value", {"Mean value, round border", "平均値座標（境界は円）"}},
     {"free-boundary", {"No flips, free border", "裏返りなし（境界は自由）"}}}};

struct Unwrapping {
  UnwrapMethod method = UnwrapMethod::lscm;
  bool automatic_seams = true;
  std::vector<SeamEdge> seams;
  double area_distortion = 1.1;
  double margin = 4;
  int texture_size = 2048;
  friend bool operator==(const Unwrapping&, const Unwrapping&) = default;
};

template <>
inline constexpr auto fields_of<Unwrapping> = std::tuple{
    field(
        &Unwrapping::method,
        {.name = "method",
         .label = {"Flattened by", "展開の方法"},
         .help = {"Conformal maps keep angles and may flip a triangle; the other two never flip one. The round border "
                  "costs angles, the free border time.",
                  "等角写像は角度を保つが、三角形が裏返ることがある。ほかの二つは決して裏返らない。"
                  "円い境界は角度、自由な境界は時間を犠牲にする。"}}),
    field(&Unwrapping::automatic_seams,
          {.name = "automatic_seams",
           .label = {"Seams by itself", "自動で切る"},
           .help = {"Cuts the mesh into charts with little distortion, besides along the marked seams.",
                    "印をつけた縫い目に加えて、歪みの少ない部分に自動で分ける。"}}),
    field(&Unwrapping::seams,
          {.name = "seams",
           .most = most_seams,
           .label = {"Seams", "縫い目"},
           .help = {"Marked edges: the charts part there.", "印をつけた辺。展開図はここで切れる。"}}),
    field(&Unwrapping::area_distortion,
          {.name = "area_distortion",
           .range = {1.001, 100},
           .slider = Range{1.01, 4},
           .scale = Scale::logarithmic,
           .label = {"Area distortion", "面積の歪み"},
           .help = {"The most that a chart may have before it is cut; 1 is none. Less of it means more charts.",
                    "これを超える部分は切り分ける。1 は歪みなし。小さくすると部分の数が増える。"}}),
    field(&Unwrapping::margin, {.name = "margin",
                                .unit = "px",
                                .range = {0, 64},
                                .slider = Range{0, 16},
                                .label = {"Margin", "余白"},
                                .help = {"Between charts, so that a filtered texel takes nothing from its neighbour.",
                                         "部分どうしの間隔。補間やミップマップで隣の色がにじむのを防ぐ。"}}),
    field(&Unwrapping::texture_size, {.name = "texture_size",
                                      .unit = "px",
                                      .range = {16, 16384},
                                      .scale = Scale::logarithmic,
                                      .label = {"Texture size", "テクスチャの大きさ"},
                                      .help = {"For which the margin is counted.", "余白を測る基準の画素数。"}}),
};

}  // namespace cg
