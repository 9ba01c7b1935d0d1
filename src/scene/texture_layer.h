// One of a material's textures: which picture, where its uv come from, how it is read, and what of the light model it
// changes. Layers are composed in their order.
#pragma once
#include <string>

#include "scene/mapping_parameters.h"
#include "scene/texture.h"
#include "scene/texture_image.h"

namespace cg {

// Where a layer's uv come from.
enum class UvSource { mesh, projector, unwrap };
template <>
inline constexpr std::array<Name, 3> names_of<UvSource>{{{"mesh", {"The mesh's own uv", "メッシュの uv"}},
                                                         {"projector", {"Projector (automatic)", "投影器（自動）"}},
                                                         {"unwrap", {"Unwrap (manual)", "展開図（手動）"}}}};

// What a layer changes. `colour` is what the light model has given, as the fixed function's texture environment does;
// all others are what the light model is given.
enum class LayerTarget { colour, k_a, k_d, k_s, n, k_r, k_t, emission, normal, opacity };
template <>
inline constexpr std::array<Name, 10> names_of<LayerTarget>{{{"colour", {"Lit colour", "照らした後の色"}},
                                                             {"k_a", {"Ambient k_a", "環境光 k_a"}},
                                                             {"k_d", {"Diffuse k_d", "拡散 k_d"}},
                                                             {"k_s", {"Specular k_s", "鏡面 k_s"}},
                                                             {"n", {"Shininess n", "鋭さ n"}},
                                                             {"k_r", {"Mirror k_r", "反射 k_r"}},
                                                             {"k_t", {"Transmission k_t", "透過 k_t"}},
                                                             {"emission", {"Emission E", "自己発光 E"}},
                                                             {"normal", {"Normal (bump)", "法線（バンプ）"}},
                                                             {"opacity", {"Opacity", "不透明度"}}}};

// GL_TEXTURE_ENV_MODE; `add` of OpenGL 1.3.
enum class LayerBlend { replace, modulate, decal, blend, add };
template <>
inline constexpr std::array<Name, 5> names_of<LayerBlend>{
    {{"replace", {"Replace: T", "置き換え：T"}},
     {"modulate", {"Modulate: C T", "乗算：C T"}},
     {"decal", {"Decal: C (1−a) + T a", "重ね貼り：C (1−a) + T a"}},
     {"blend", {"Blend: C (1−T) + C_c T", "混合：C (1−T) + C_c T"}},
     {"add", {"Add: C + T", "加算：C + T"}}}};

// How a picture is a normal.
enum class BumpKind { height, normal_map };
template <>
inline constexpr std::array<Name, 2> names_of<BumpKind>{
    {{"height", {"Height", "高さ"}}, {"normal-map", {"Normal map", "法線マップ"}}}};

// (u, v) -> R(turn) (u repeat_u, v repeat_v) + (offset_u, offset_v): GL_TEXTURE's matrix.
struct TextureMatrix {
  double repeat_u = 1, repeat_v = 1;
  double turn = 0;  // degrees
  double offset_u = 0, offset_v = 0;
  friend bool operator==(const TextureMatrix&, const TextureMatrix&) = default;
};

template <>
inline constexpr auto fields_of<TextureMatrix> = std::tuple{
    field(&TextureMatrix::repeat_u, {.name = "repeat_u",
                                     .range = {-1e6, 1e6},
                                     .slider = Range{0.1, 10},
                                     .gl = "glScale",
                                     .label = {"Repeats in u", "u の繰り返し"},
                                     .help = {"How often the picture stands side by side.", "横に並べる枚数。"}}),
    field(&TextureMatrix::repeat_v,
          {.name = "repeat_v",
           .range = {-1e6, 1e6},
           .slider = Range{0.1, 10},
           .gl = "glScale",
           .label = {"Repeats in v", "v の繰り返し"},
           .help = {"How often the picture stands one above the other.", "縦に並べる枚数。"}}),
    field(&TextureMatrix::turn,
          {.name = "turn",
           .unit = "deg",
           .range = {-1e6, 1e6},
           .slider = Range{-180, 180},
           .gl = "glRotate",
           .label = {"Turn", "回転"},
           .help = {"Turns uv about (0, 0), counter-clockwise.", "uv を原点のまわりに左へ回す。"}}),
    field(&TextureMatrix::offset_u, {.name = "offset_u",
                                     .range = {-1e6, 1e6},
                                     .slider = Range{-1, 1},
                                     .gl = "glTranslate",
                                     .label = {"Shift in u", "u のずらし"},
                                     .help = {"Added to u at the end.", "最後に u に足す。"}}),
    field(&TextureMatrix::offset_v, {.name = "offset_v",
                                     .range = {-1e6, 1e6},
                                     .slider = Range{-1, 1},
                                     .gl = "glTranslate",
                                     .label = {"Shift in v", "v のずらし"},
                                     .help = {"Added to v at the end.", "最後に v に足す。"}}),
};
static_assert(well_described<TextureMatrix>());

inline constexpr std::size_t most_layers = 16;  // of a material

struct TextureLayer {
  bool visible = true;
  bool solo = false;
  std::string image;
  Encoding encoding = Encoding::as_stored;
  UvSource uv = UvSource::mesh;
  Projector projector;
  TextureMatrix matrix;
  Sampling sampling;
  bool perspective = true;
  LayerTarget target = LayerTarget::colour;
  LayerBlend blend = LayerBlend::modulate;
  glm::dvec3 blend_colour{0, 0, 0};
  double amount = 1;
  double scale = 1;
  BumpKind bump = BumpKind::height;
  TextureHandle texture;  // what image and encoding stand for; null until it is loaded
  friend bool operator==(const TextureLayer&, const TextureLayer&) = default;
};

template <>
inline constexpr auto fields_of<TextureLayer> = std::tuple{
    field(&TextureLayer::visible,
          {.name = "visible", .label = {"Visible", "表示"}, .help = {"Off: muted.", "オフなら使わない。"}}),
    field(&TextureLayer::solo,
          {.name = "solo",
           .label = {"Solo", "単独"},
           .help = {"Where a layer is solo, only such layers count.", "単独のレイヤーがあれば、それだけを使う。"}}),
    field(&TextureLayer::image, {.name = "image",
                                 .label = {"Picture", "画像"},
                                 .help = {"A file, or the name of a picture that comes with the program.",
                                          "画像ファイル、または付属の画像の名前。"}}),
    field(&TextureLayer::encoding,
          {.name = "encoding",
           .label = {"Encoding", "値の意味"},
           .help =
               {"As stored: the numbers are light, as in OpenGL's fixed function. sRGB: they are what a screen "
                "shows, and are made light before anything is computed.",
                "そのままの値は OpenGL の固定機能と同じく光の量。sRGB は画面用の値なので、計算の前に光の量に直す。"}}),
    field(&TextureLayer::uv,
          {.name = "uv",
           .label = {"uv from", "uv の出所"},
           .help = {"Where each corner's place in the picture comes from.", "各頂点が画像のどこに当たるかの決め方。"}}),
    field(&TextureLayer::projector, {.name = "projector", .label = {"Projector", "投影器"}}),
    field(&TextureLayer::matrix, {.name = "matrix", .label = {"Texture matrix", "テクスチャ行列"}}),
    field(&TextureLayer::sampling, {.name = "sampling", .label = {"Sampling", "読み方"}}),
    field(&TextureLayer::perspective,
          {.name = "perspective",
           .gl = "GL_PERSPECTIVE_CORRECTION_HINT",
           .label = {"Perspective-correct", "透視補正"},
           .help = {"Off: uv go linearly over the picture, as early hardware did; textures swim and break at edges.",
                    "オフなら uv を画面上で線形補間する（初期のハードウェア）。模様が曲がり、辺で折れる。"}}),
    field(&TextureLayer::target,
          {.name = "target",
           .label = {"Feeds", "使う先"},
           .help = {"Which part of the light model the picture changes.", "画像が照明モデルのどの項を変えるか。"}}),
    field(&TextureLayer::blend,
          {.name = "blend",
           .gl = "GL_TEXTURE_ENV_MODE",
           .label = {"Combined by", "合成"},
           .help = {"C is what was there, T the picture, a its alpha.", "C は元の値、T は画像、a は画像のアルファ。"}}),
    field(&TextureLayer::blend_colour,
          {.name = "blend_colour",
           .symbol = "C_c",
           .meaning = Meaning::colour,
           .gl = "GL_TEXTURE_ENV_COLOR",
           .label = {"Blend colour", "混合色"},
           .help = {"Where “blend” goes as the picture grows.", "「混合」で画像の値が大きいほど近づく色。"}}),
    field(&TextureLayer::amount,
          {.name = "amount",
           .label = {"Amount", "量"},
           .help = {"0: as if the layer were not there; 1: all of it.", "0 ならレイヤーがないのと同じ、1 なら全部。"}}),
    field(&TextureLayer::scale, {.name = "scale",
                                 .range = {-1e6, 1e6},
                                 .slider = Range{0, 4},
                                 .label = {"Scale", "倍率"},
                                 .help = {"The picture's numbers are multiplied by it: the height of a bump, the "
                                          "largest n, light above 1.",
                                          "画像の値に掛ける数。バンプの高さ、n の最大値、1 を超える光など。"}}),
    field(&TextureLayer::bump, {.name = "bump",
                                .label = {"Normal from", "法線の元"},
                                .help = {"A grey picture of heights, or colours that are normals.",
                                         "高さの濃淡画像か、法線を色にした画像。"}}),
};

}  // namespace cg
