// A light of the lecture: directional (w = 0), point (w = 1) or spot, with OpenGL's attenuation.
#pragma once
#include "params/field.h"

namespace cg {

enum class LightKind { directional, point, spot };
template <>
inline constexpr std::array<Name, 3> names_of<LightKind>{
    {{"directional", {"Directional", "平行光源"}}, {"point", {"Point", "点光源"}}, {"spot", {"Spot", "スポット"}}}};

struct Light {
  bool enabled = true;
  LightKind kind = LightKind::point;
  // World coordinates. A directional light shines from `position` towards the origin (w = 0); the others stand
  // at position/w.
  glm::dvec3 position{10, 10, 10};
  double w = 1;
  glm::dvec3 ambient{0, 0, 0};
  glm::dvec3 diffuse{1, 1, 1};
  glm::dvec3 specular{1, 1, 1};
  glm::dvec3 direction{-1, -1, -1};  // where a spot shines to, world, any length
  double cutoff = 30;                // half the cone's opening, degrees; 180 is no cone
  double exponent = 0;
  double k_0 = 1, k_1 = 0, k_2 = 0;  // attenuation 1/(k_0 + k_1 r + k_2 r^2)
  friend bool operator==(const Light&, const Light&) = default;
};

inline constexpr int gl_light_limit = 8;  // GL_MAX_LIGHTS of every driver we know
inline constexpr int light_limit = 64;    // of a scene

template <>
inline constexpr auto fields_of<Light> = std::tuple{
    field(&Light::enabled, {.name = "enabled",
                            .gl = "GL_LIGHT0",
                            .label = {"On", "点灯"},
                            .help = {"glEnable( GL_LIGHT0 ).", "glEnable( GL_LIGHT0 )。"}}),
    field(&Light::kind,
          {.name = "kind",
           .label = {"Kind", "種類"},
           .help = {"Directional: rays are parallel (w = 0). Point: they start at a place (w = 1). Spot: a "
                    "point light with a cone.",
                    "平行光源は光線が平行（w = 0）。点光源は一点から出る（w = 1）。スポットは円錐に"
                    "限った点光源。"}}),
    field(&Light::position, {.name = "position",
                             .symbol = "L",
                             .unit = "m",
                             .range = {-1e30, 1e30},
                             .slider = Range{-20, 20},
                             .meaning = Meaning::position,
                             .gl = "GL_POSITION",
                             .label = {"Position", "位置"},
                             .help = {"Where the light stands; of a directional light, the direction it comes from.",
                                      "光源の位置。平行光源では光の来る方向。"}}),
    field(&Light::w, {.name = "w",
                      .symbol = "w",
                      .range = {-1e30, 1e30},
                      .slider = Range{0, 1},
                      .gl = "GL_POSITION",
                      .label = {"Homogeneous coordinate", "同次座標 w"},
                      .help = {"The fourth number of GL_POSITION: 0 makes the light directional.",
                               "GL_POSITION の 4 番目の数。0 にすると平行光源になる。"}}),
    field(&Light::ambient, {.name = "ambient",
                            .symbol = "I_a",
                            .range = {-1e20, 1e20},
                            .slider = Range{0, 1},
                            .meaning = Meaning::colour,
                            .quantity = Quantity::ambient,
                            .gl = "GL_AMBIENT",
                            .label = {"Ambient colour", "環境光成分"},
                            .help = {"What this light adds to the ambient light, wherever a face looks.",
                                     "面の向きに関係なく、この光源が加える環境光。"}}),
    field(&Light::diffuse, {.name = "diffuse",
                            .symbol = "I_d",
                            .range = {-1e20, 1e20},
                            .slider = Range{0, 1},
                            .meaning = Meaning::colour,
                            .quantity = Quantity::diffuse,
                            .gl = "GL_DIFFUSE",
                            .label = {"Diffuse colour", "拡散光成分"},
                            .help = {"The colour I_i that is multiplied by k_d (N·L).", "k_d (N·L) に掛かる色 I_i。"}}),
    field(&Light::specular,
          {.name = "specular",
           .symbol = "I_s",
           .range = {-1e20, 1e20},
           .slider = Range{0, 1},
           .meaning = Meaning::colour,
           .quantity = Quantity::specular,
           .gl = "GL_SPECULAR",
           .label = {"Specular colour", "鏡面光成分"},
           .help = {"The colour I_i that is multiplied by the highlight.", "ハイライトに掛かる色 I_i。"}}),
    field(&Light::direction, {.name = "direction",
                              .unit = "m",
                              .range = {-1e30, 1e30},
                              .slider = Range{-1, 1},
                              .meaning = Meaning::direction,
                              .gl = "GL_SPOT_DIRECTION",
                              .label = {"Spot direction", "スポットの向き"},
                              .help = {"Where the cone's axis points.", "円錐の軸の向き。"}}),
    field(&Light::cutoff, {.name = "cutoff",
                           .unit = "deg",
                           .range = {0, 90},
                           .also = 180.0,
                           .gl = "GL_SPOT_CUTOFF",
                           .label = {"Spot cut-off", "スポットの広がり"},
                           .help = {"Half the cone's opening, 0° to 90°; 180° is no cone.",
                                    "円錐の半頂角、0° から 90°。180° なら円錐なし。"}}),
    field(&Light::exponent, {.name = "exponent",
                             .range = {0, 128},
                             .gl = "GL_SPOT_EXPONENT",
                             .label = {"Spot exponent", "スポットの指数"},
                             .help = {"How fast the light fades from the axis to the edge of the cone.",
                                      "軸から縁に向かって光が弱まる速さ。"}}),
    field(&Light::k_0, {.name = "k_0",
                        .symbol = "k_0",
                        .range = {0, 1e20},
                        .slider = Range{0, 2},
                        .gl = "GL_CONSTANT_ATTENUATION",
                        .label = {"Constant attenuation", "減衰（定数）"},
                        .help = {"1/(k_0 + k_1 r + k_2 r²): the part that does not depend on the distance r.",
                                 "1/(k_0 + k_1 r + k_2 r²) のうち距離 r によらない部分。"}}),
    field(&Light::k_1, {.name = "k_1",
                        .symbol = "k_1",
                        .unit = "1/m",
                        .range = {0, 1e20},
                        .slider = Range{0, 1},
                        .gl = "GL_LINEAR_ATTENUATION",
                        .label = {"Linear attenuation", "減衰（一次）"},
                        .help = {"Grows with the distance r.", "距離 r に比例する減衰。"}}),
    field(&Light::k_2, {.name = "k_2",
                        .symbol = "k_2",
                        .unit = "1/m2",
                        .range = {0, 1e20},
                        .slider = Range{0, 1},
                        .gl = "GL_QUADRATIC_ATTENUATION",
                        .label = {"Quadratic attenuation", "減衰（二次）"},
                        .help = {"Grows with r², as light from a point really fades.",
                                 "r² に比例する減衰。点から出る光の本来の弱まり方。"}}),
};
static_assert(well_described<Light>());

}  // namespace cg
