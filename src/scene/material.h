// What a surface does with light: the k of the lecture's formula
//   I = I_a k_a + sum_i I_i [ k_d (N.L) + k_s (R.V)^n ] + k_r I_r + k_t I_t
#pragma once
#include "scene/texture_layer.h"

namespace cg {

struct Material {
  // OpenGL's own defaults (GL 2.1, table 2.10), but a specular term and an exponent that can be seen.
  glm::dvec3 k_a{0.2, 0.2, 0.2};
  glm::dvec3 k_d{0.8, 0.8, 0.8};
  glm::dvec3 k_s{0.5, 0.5, 0.5};
  double n = 32;
  glm::dvec3 k_r{0, 0, 0};
  glm::dvec3 k_t{0, 0, 0};
  glm::dvec3 emission{0, 0, 0};
  glm::dvec3 color{1, 1, 1};         // the current colour (glColor), used where colour material is on
  std::vector<TextureLayer> layers;  // of textures, in the order in which they are composed
  friend bool operator==(const Material&, const Material&) = default;
};

template <>
inline constexpr auto fields_of<Material> = std::tuple{
    field(&Material::k_a,
          {.name = "k_a",
           .symbol = "k_a",
           .meaning = Meaning::colour,
           .quantity = Quantity::ambient,
           .gl = "GL_AMBIENT",
           .label = {"Ambient reflectance", "環境光の反射率"},
           .help = {"The share of the ambient light I_a that the surface returns. It has no direction, so "
                    "alone it shows a silhouette without form.",
                    "環境光 I_a のうち面が返す割合。方向を持たないので、これだけでは立体感のない"
                    "影絵になる。"}}),
    field(&Material::k_d, {.name = "k_d",
                           .symbol = "k_d",
                           .meaning = Meaning::colour,
                           .quantity = Quantity::diffuse,
                           .gl = "GL_DIFFUSE",
                           .label = {"Diffuse reflectance", "拡散反射率"},
                           .help = {"The share that is scattered equally to all sides: Lambert's cosine, N·L.",
                                    "どの方向にも等しく散る光の割合。ランバートの余弦則 N·L に従う。"}}),
    field(&Material::k_s, {.name = "k_s",
                           .symbol = "k_s",
                           .meaning = Meaning::colour,
                           .quantity = Quantity::specular,
                           .gl = "GL_SPECULAR",
                           .label = {"Specular reflectance", "鏡面反射率"},
                           .help = {"The strength of the highlight.", "ハイライトの強さ。"}}),
    field(&Material::n, {.name = "n",
                         .symbol = "n",
                         .range = {0, 1e6},
                         .slider = Range{1, 1000},
                         .scale = Scale::logarithmic,
                         .quantity = Quantity::specular,
                         .gl = "GL_SHININESS",
                         .label = {"Shininess", "鏡面反射の鋭さ"},
                         .help = {"The exponent: the larger, the smaller the highlight. OpenGL takes 0 to 128.",
                                  "指数。大きいほどハイライトは小さい。OpenGL が受け付けるのは 0 から 128。"}}),
    field(&Material::k_r, {.name = "k_r",
                           .symbol = "k_r",
                           .meaning = Meaning::colour,
                           .quantity = Quantity::reflection,
                           .label = {"Mirror reflectance", "反射率（鏡）"},
                           .help = {"The share of the light I_r from the mirrored direction. Needs ray tracing.",
                                    "鏡の方向から来る光 I_r の割合。レイトレーシングが必要。"}}),
    field(&Material::k_t, {.name = "k_t",
                           .symbol = "k_t",
                           .meaning = Meaning::colour,
                           .quantity = Quantity::transmission,
                           .label = {"Transmittance", "透過率"},
                           .help = {"The share of the light I_t from behind the surface. Needs ray tracing.",
                                    "面の向こうから来る光 I_t の割合。レイトレーシングが必要。"}}),
    field(&Material::emission, {.name = "emission",
                                .symbol = "E",
                                .range = {0, 1e6},
                                .slider = Range{0, 1},
                                .meaning = Meaning::colour,
                                .quantity = Quantity::emission,
                                .gl = "GL_EMISSION",
                                .label = {"Emission", "自己発光"},
                                .help = {"Light that the surface gives off by itself, whatever falls on it.",
                                         "当たる光に関係なく、面自身が出す光。"}}),
    field(&Material::color,
          {.name = "color",
           .meaning = Meaning::colour,
           .gl = "glColor",
           .label = {"Current colour (glColor)", "現在の色（glColor）"},
           .help = {"Takes the place of reflectances where colour material is on; else it does nothing.",
                    "カラーマテリアルが有効なとき反射率の代わりになる。無効なら何もしない。"}}),
    field(&Material::layers, {.name = "layers",
                              .most = most_layers,
                              .label = {"Textures", "テクスチャ"},
                              .help = {"Pictures that change the material from place to place, one over the other.",
                                       "素材を場所ごとに変える画像。順に重ねる。"}}),
};

}  // namespace cg
