// Which of the light model's forms is used, and how it is spread over a face; OpenGL's names where it has them.
#pragma once
#include "params/field.h"

namespace cg {

enum class ShadingMode { flat, gouraud, phong };
template <>
inline constexpr std::array<Name, 3> names_of<ShadingMode>{
    {{"flat", {"Flat", "フラット"}}, {"gouraud", {"Gouraud", "グロー"}}, {"phong", {"Phong", "フォン"}}}};

// The two highlights: (N.H)^n, as OpenGL (Blinn 1977), and (R.V)^n, as the lecture (Phong 1975).
enum class Reflection { half_vector, reflection_vector };
template <>
inline constexpr std::array<Name, 2> names_of<Reflection>{
    {{"half-vector", {"N·H (half vector)", "N·H（ハーフベクトル）"}},
     {"reflection-vector", {"R·V (reflection vector)", "R·V（反射ベクトル）"}}}};

enum class NormalRule { file, face, mean, area, angle };
template <>
inline constexpr std::array<Name, 5> names_of<NormalRule>{{{"file", {"From the file", "ファイルの法線"}},
                                                           {"face", {"Face", "面の法線"}},
                                                           {"mean", {"Mean of the faces", "面の平均"}},
                                                           {"area", {"Weighted by area", "面積で重み付け"}},
                                                           {"angle", {"Weighted by angle", "角度で重み付け"}}}};

enum class NormalLength { off, rescale, normalize };
template <>
inline constexpr std::array<Name, 3> names_of<NormalLength>{{{"off", {"As it comes", "そのまま"}},
                                                             {"rescale", {"GL_RESCALE_NORMAL", "GL_RESCALE_NORMAL"}},
                                                             {"normalize", {"GL_NORMALIZE", "GL_NORMALIZE"}}}};

enum class ColorMaterial { off, ambient_and_diffuse, ambient, diffuse, specular, emission };
template <>
inline constexpr std::array<Name, 6> names_of<ColorMaterial>{
    {{"off", {"Off", "なし"}},
     {"ambient-and-diffuse", {"Ambient and diffuse", "環境光と拡散"}},
     {"ambient", {"Ambient", "環境光"}},
     {"diffuse", {"Diffuse", "拡散"}},
     {"specular", {"Specular", "鏡面"}},
     {"emission", {"Emission", "発光"}}}};

// Where the ambient term comes from: I_a k_a, the same at every point, or a radiosity solution (scene/radiosity.h).
enum class AmbientSource { constant, radiosity };
template <>
inline constexpr std::array<Name, 2> names_of<AmbientSource>{
    {{"constant", {"Constant I_a k_a", "一定の I_a k_a"}}, {"radiosity", {"Radiosity", "ラジオシティ"}}}};

// float or double: what the software reference computes in.
enum class Precision { single_precision, double_precision };
template <>
inline constexpr std::array<Name, 2> names_of<Precision>{
    {{"float", {"float", "float"}}, {"double", {"double", "double"}}}};
// What becomes of a surface that is not opaque everywhere. Test: a pixel is there or not. Blending mixes with what was
// drawn before, so it is right where the far is drawn first.
enum class Transparency { opaque, test, blend, sorted_blend };
template <>
inline constexpr std::array<Name, 4> names_of<Transparency>{
    {{"opaque", {"Ignored", "無視"}},
     {"test", {"Alpha test", "アルファテスト"}},
     {"blend", {"Blend, as drawn", "合成（描画順のまま）"}},
     {"sorted-blend", {"Blend, sorted", "合成（奥から順に）"}}}};

struct Shading {
  ShadingMode mode = ShadingMode::gouraud;
  Reflection reflection = Reflection::half_vector;
  NormalRule normals = NormalRule::file;
  double crease_angle = 180;
  glm::dvec3 ambient{0.2, 0.2, 0.2};
  AmbientSource ambient_source = AmbientSource::constant;
  bool local_viewer = false;
  bool two_sided = false;
  NormalLength normal_length = NormalLength::normalize;
  ColorMaterial color_material = ColorMaterial::off;
  bool clamp = true;
  Transparency transparency = Transparency::opaque;
  double alpha_threshold = 0.5;
  Precision precision = Precision::double_precision;
  friend bool operator==(const Shading&, const Shading&) = default;
};

template <>
inline constexpr auto fields_of<Shading> = std::tuple{
    field(&Shading::mode,
          {.name = "mode",
           .gl = "glShadeModel",
           .label = {"Shading", "シェーディング"},
           .help = {"Flat: one colour a face. Gouraud: the colours of the vertices, interpolated. Phong: the "
                    "normals of the vertices, interpolated.",
                    "フラットは面ごとに一色。グローは頂点の色を補間。フォンは頂点の法線を補間。"}}),
    field(&Shading::reflection,
          {.name = "reflection",
           .quantity = Quantity::specular,
           .label = {"Highlight", "ハイライトの式"},
           .help = {"(R·V)^n is the lecture's, (N·H)^n OpenGL's. For the same width N·H needs about 4n.",
                    "(R·V)^n は講義の式、(N·H)^n は OpenGL の式。同じ広がりには N·H で約 4n が要る。"}}),
    field(&Shading::normals,
          {.name = "normals",
           .symbol = "N",
           .label = {"Vertex normals", "頂点の法線"},
           .help = {"Where the normals of the vertices come from. A file without normals gets those weighted "
                    "by angle.",
                    "頂点の法線の決め方。法線のないファイルでは角度で重み付けする。"}}),
    field(&Shading::crease_angle,
          {.name = "crease_angle",
           .unit = "deg",
           .range = {0, 180},
           .label = {"Crease angle", "折り目の角度"},
           .help = {"Faces that meet at a larger angle keep an edge between them; 180° smooths all.",
                    "これより大きい角度で接する面の間には稜線が残る。180° ならすべて滑らか。"}}),
    field(&Shading::ambient, {.name = "ambient",
                              .symbol = "I_a",
                              .range = {-1e20, 1e20},
                              .slider = Range{0, 1},
                              .meaning = Meaning::colour,
                              .quantity = Quantity::ambient,
                              .gl = "GL_LIGHT_MODEL_AMBIENT",
                              .label = {"Ambient light", "環境光"},
                              .help = {"The light that comes from everywhere, before any lamp is lit.",
                                       "光源がなくても四方から来る光。"}}),
    field(&Shading::ambient_source,
          {.name = "ambient_source",
           .quantity = Quantity::ambient,
           .label = {"Ambient term from", "環境光項"},
           .help = {"Radiosity: the light that surfaces send to each other stands in for the constant I_a k_a.",
                    "ラジオシティ：面どうしが送り合う光を、一定の I_a k_a の代わりにする。"}}),
    field(&Shading::local_viewer,
          {.name = "local_viewer",
           .symbol = "V",
           .gl = "GL_LIGHT_MODEL_LOCAL_VIEWER",
           .label = {"Local viewer", "視点の位置を使う"},
           .help = {"Off: V is the same for all points (OpenGL's default). On: V points to the eye.",
                    "オフでは V はどの点でも同じ（OpenGL の既定）。オンでは V は視点を向く。"}}),
    field(&Shading::two_sided,
          {.name = "two_sided",
           .gl = "GL_LIGHT_MODEL_TWO_SIDE",
           .label = {"Light both sides", "両面を照らす"},
           .help = {"Back faces are lit with the reversed normal.", "裏の面を逆向きの法線で照らす。"}}),
    field(&Shading::normal_length,
          {.name = "normal_length",
           .gl = "GL_NORMALIZE",
           .label = {"Normal length", "法線の長さ"},
           .help = {"A scaled model scales its normals too, and with them N·L; GL_NORMALIZE mends it.",
                    "拡大縮小した形では法線の長さ、つまり N·L も変わる。GL_NORMALIZE で直る。"}}),
    field(&Shading::color_material,
          {.name = "color_material",
           .gl = "GL_COLOR_MATERIAL",
           .label = {"Colour material", "カラーマテリアル"},
           .help = {"Which reflectance follows glColor. Off: glColor does nothing under lighting.",
                    "どの反射率が glColor に従うか。なしでは光源計算中の glColor は効かない。"}}),
    field(&Shading::clamp,
          {.name = "clamp",
           .gl = "GL_CLAMP_VERTEX_COLOR",
           .label = {"Clamp to 0..1", "0..1 に制限"},
           .help = {"OpenGL limits each vertex's colour before it interpolates; here you can switch it off.",
                    "OpenGL は補間の前に頂点の色を制限する。ここでは外せる。"}}),
    field(&Shading::transparency, {.name = "transparency",
                                   .gl = "GL_ALPHA_TEST, GL_BLEND",
                                   .label = {"Transparency", "透明"},
                                   .help = {"What becomes of places whose opacity, from a texture, is below 1.",
                                            "テクスチャの不透明度が 1 未満の所をどう描くか。"}}),
    field(&Shading::alpha_threshold, {.name = "alpha_threshold",
                                      .gl = "glAlphaFunc",
                                      .label = {"Alpha threshold", "アルファのしきい値"},
                                      .help = {"Of the alpha test: what is not above it is not drawn.",
                                               "アルファテストで、これを超えない所は描かない。"}}),
    field(&Shading::precision,
          {.name = "precision",
           .label = {"Software precision", "ソフトウェアの精度"},
           .help = {"What the software reference computes in.", "ソフトウェア参照が計算に使う型。"}}),
};
static_assert(well_described<Shading>());

}  // namespace cg
