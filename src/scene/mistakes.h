// The classic errors of a first OpenGL program, put in on purpose: each changes the calls that the fixed function is
// told and the line of the listing that is guilty. The other techniques draw the scene as it was meant, so that the
// difference shows the consequence.
#pragma once
#include "params/field.h"

namespace cg {

struct Mistakes {
  bool light_before_view = false;
  bool directional_w = false;
  bool no_normalize = false;
  bool no_color_material = false;
  bool flipped_normals = false;
  bool no_normals = false;
  bool no_gate = false;
  bool long_light_vector = false;
  bool no_depth_test = false;
  bool swapped_front_face = false;
  friend bool operator==(const Mistakes&, const Mistakes&) = default;
};

template <>
inline constexpr auto fields_of<Mistakes> = std::tuple{
    field(&Mistakes::light_before_view,
          {.name = "light_before_view",
           .gl = "GL_POSITION",
           .label = {"Light set before the view", "視野変換の前に光源を置く"},
           .help = {"glLight multiplies a position by the modelview matrix of that moment. Given before gluLookAt, the "
                    "light stands in eye coordinates and turns with the camera.",
                    "glLight は位置にその時点のモデルビュー行列を掛ける。gluLookAt より前に置くと視点座標に"
                    "固定され、光源がカメラと一緒に回る。"}}),
    field(&Mistakes::directional_w,
          {.name = "directional_w",
           .gl = "GL_POSITION",
           .label = {"w is 0 instead of 1", "w が 1 でなく 0"},
           .help = {"The fourth number of GL_POSITION: with 0 a point light becomes directional and does not fade.",
                    "GL_POSITION の 4 番目の数。0 では点光源が平行光源になり、減衰もしない。"}}),
    field(&Mistakes::no_normalize, {.name = "no_normalize",
                                    .gl = "GL_NORMALIZE",
                                    .label = {"No GL_NORMALIZE", "GL_NORMALIZE を忘れる"},
                                    .help = {"glScale changes the length of the normals too, and with it N·L.",
                                             "glScale は法線の長さも変え、N·L もその分変わる。"}}),
    field(&Mistakes::no_color_material,
          {.name = "no_color_material",
           .gl = "GL_COLOR_MATERIAL",
           .label = {"Colour material not enabled", "カラーマテリアルが無効"},
           .help = {"glColor does nothing while light is computed, unless GL_COLOR_MATERIAL is enabled.",
                    "光源計算中の glColor は、GL_COLOR_MATERIAL を有効にしなければ何もしない。"}}),
    field(&Mistakes::flipped_normals, {.name = "flipped_normals",
                                       .gl = "glNormal",
                                       .label = {"Normals point inwards", "法線が内向き"},
                                       .help = {"N·L is negative where the light is: the lit side is dark.",
                                                "光源の側で N·L が負になり、明るいはずの面が暗くなる。"}}),
    field(&Mistakes::no_normals,
          {.name = "no_normals",
           .gl = "glNormal",
           .label = {"No normals given", "法線を与えない"},
           .help = {"Every vertex has the current normal, (0, 0, 1): the whole mesh is lit alike.",
                    "すべての頂点が現在の法線 (0, 0, 1) を使い、全体が同じ明るさになる。"}}),
    field(&Mistakes::no_gate,
          {.name = "no_gate",
           .label = {"Highlight without N·L > 0", "N·L > 0 を調べない鏡面項"},
           .help = {"In a light model of one's own: without the test, faces turned away from the light shine.",
                    "自作の光源計算で判定を忘れると、光源に背を向けた面にもハイライトが出る。"}}),
    field(&Mistakes::long_light_vector,
          {.name = "long_light_vector",
           .label = {"L not normalised", "L を正規化しない"},
           .help = {"In a light model of one's own: N·L then is the cosine times the distance of the light.",
                    "自作の光源計算で L の長さを 1 にし忘れると、N·L が余弦×光源までの距離になる。"}}),
    field(&Mistakes::no_depth_test, {.name = "no_depth_test",
                                     .gl = "GL_DEPTH_TEST",
                                     .label = {"Depth test off", "デプステストなし"},
                                     .help = {"What is drawn last is seen, not what is nearest.",
                                              "手前のものではなく、最後に描いたものが見える。"}}),
    field(&Mistakes::swapped_front_face,
          {.name = "swapped_front_face",
           .gl = "glFrontFace",
           .label = {"glFrontFace swapped", "glFrontFace が逆"},
           .help = {"Front and back are exchanged: culling removes what faces the eye, and both-sided light lights the "
                    "wrong side.",
                    "表と裏が入れ替わる。カリングは手前の面を捨て、両面照明は反対側を照らす。"}}),
};
static_assert(well_described<Mistakes>());

}  // namespace cg
