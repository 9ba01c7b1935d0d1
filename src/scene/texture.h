// How a texture is read at a point: beyond its borders, between its texels, and where many of them lie in one pixel.
// The words and the meaning are OpenGL's: The OpenGL Graphics System 3.3, sections 3.8.4 and 3.8.11.
#pragma once
#include "params/field.h"

namespace cg {

enum class Wrap { repeat, mirror, clamp, border };
template <>
inline constexpr std::array<Name, 4> names_of<Wrap>{{{"repeat", {"Repeat", "繰り返し"}},
                                                     {"mirror", {"Mirrored repeat", "鏡像の繰り返し"}},
                                                     {"clamp", {"Clamp to edge", "端の色で延長"}},
                                                     {"border", {"Border colour", "境界色"}}}};

// One texel larger than a pixel.
enum class MagFilter { nearest, linear };
template <>
inline constexpr std::array<Name, 2> names_of<MagFilter>{
    {{"nearest", {"Nearest", "最近傍"}}, {"linear", {"Linear", "線形補間"}}}};

// Several texels in one pixel; the first word is within a level, the second between levels.
enum class MinFilter {
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear
};
template <>
inline constexpr std::array<Name, 6> names_of<MinFilter>{
    {{"nearest", {"Nearest", "最近傍"}},
     {"linear", {"Linear", "線形補間"}},
     {"nearest-mipmap-nearest", {"Nearest in the nearest mipmap", "最も近いミップマップの最近傍"}},
     {"linear-mipmap-nearest", {"Linear in the nearest mipmap", "最も近いミップマップの線形補間"}},
     {"nearest-mipmap-linear", {"Nearest, between two mipmaps", "2 つのミップマップの最近傍の間"}},
     {"linear-mipmap-linear", {"Trilinear", "三重線形補間"}}}};

struct Sampling {
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  MagFilter mag_filter = MagFilter::linear;
  MinFilter min_filter = MinFilter::linear_mipmap_linear;
  double bias = 0;
  int anisotropy = 1;
  glm::dvec3 border{0, 0, 0};
  double border_alpha = 0;
  friend bool operator==(const Sampling&, const Sampling&) = default;
};

template <>
inline constexpr auto fields_of<Sampling> = std::tuple{
    field(&Sampling::wrap_s,
          {.name = "wrap_s",
           .gl = "GL_TEXTURE_WRAP_S",
           .label = {"Beyond left and right", "左右の外側"},
           .help = {"What stands where u is below 0 or above 1.", "u が 0 未満や 1 を超える所の色。"}}),
    field(&Sampling::wrap_t,
          {.name = "wrap_t",
           .gl = "GL_TEXTURE_WRAP_T",
           .label = {"Beyond top and bottom", "上下の外側"},
           .help = {"What stands where v is below 0 or above 1.", "v が 0 未満や 1 を超える所の色。"}}),
    field(&Sampling::mag_filter,
          {.name = "mag_filter",
           .gl = "GL_TEXTURE_MAG_FILTER",
           .label = {"Magnified", "拡大時"},
           .help = {"Where a texel is larger than a pixel: its colour alone, or interpolated between four.",
                    "テクセルが画素より大きい所で、1 つの色を使うか 4 つを補間するか。"}}),
    field(&Sampling::min_filter,
          {.name = "min_filter",
           .gl = "GL_TEXTURE_MIN_FILTER",
           .label = {"Minified", "縮小時"},
           .help = {"Where many texels lie in a pixel. Without mipmaps only some of them are read: the picture "
                    "flickers. Mipmaps hold their means.",
                    "1 画素に多くのテクセルが入る所。ミップマップなしでは一部しか読まれず、ちらつく。ミップマップは"
                    "平均を持つ。"}}),
    field(&Sampling::bias, {.name = "bias",
                            .unit = "level",
                            .range = {-16, 16},
                            .slider = Range{-4, 4},
                            .gl = "GL_TEXTURE_LOD_BIAS",
                            .label = {"Level bias", "レベルの補正"},
                            .help = {"Added to the mipmap's level: above 0 it blurs, below 0 it flickers.",
                                     "ミップマップのレベルに足す。正ならぼけ、負ならちらつく。"}}),
    field(&Sampling::anisotropy,
          {.name = "anisotropy",
           .range = {1, 16},
           .gl = "GL_TEXTURE_MAX_ANISOTROPY_EXT",
           .label = {"Anisotropy", "異方性フィルタ"},
           .help = {"At most so many samples along the pixel's longer extent in the texture: keeps floors sharp.",
                    "画素がテクスチャ上で細長い方向に取る標本の最大数。床が遠くまで鮮明になる。"}}),
    field(&Sampling::border, {.name = "border",
                              .meaning = Meaning::colour,
                              .gl = "GL_TEXTURE_BORDER_COLOR",
                              .label = {"Border colour", "境界色"},
                              .help = {"What stands beyond the border.", "境界の外側の色。"}}),
    field(&Sampling::border_alpha, {.name = "border_alpha",
                                    .label = {"Border alpha", "境界のアルファ"},
                                    .help = {"0: nothing beyond the border; 1: the border colour covers.",
                                             "0 なら外側は透明、1 なら境界色が覆う。"}}),
};
static_assert(well_described<Sampling>());

constexpr bool uses_mipmaps(MinFilter f) { return f != MinFilter::nearest && f != MinFilter::linear; }
constexpr bool is_linear_within(MinFilter f) {
  return f == MinFilter::linear || f == MinFilter::linear_mipmap_nearest || f == MinFilter::linear_mipmap_linear;
}
constexpr bool is_linear_between(MinFilter f) {
  return f == MinFilter::nearest_mipmap_linear || f == MinFilter::linear_mipmap_linear;
}

}  // namespace cg
