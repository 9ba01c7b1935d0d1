// The classic materials of OpenGL's lighting model: the 24 teapots of the OpenGL Programming Guide (Neider, Davis, Woo,
// 1993, plate 17; its program teapots.c by Mark Kilgard), whose numbers every course has used since. The exponent is
// 128 times the number given there.
#pragma once
#include <array>
#include <string_view>

#include "scene/material.h"

namespace cg {

struct NamedMaterial {
  std::string_view id;  // "green-rubber"
  Words label;
  glm::dvec3 k_a, k_d, k_s;
  double n;
};

// The material with its k and n taken from the table, and the rest left as it is.
inline Material with(Material material, const NamedMaterial& named) {
  material.k_a = named.k_a, material.k_d = named.k_d, material.k_s = named.k_s, material.n = named.n;
  return material;
}

namespace detail {
constexpr glm::dvec3 grey(double v) { return {v, v, v}; }
}  // namespace detail

// clang-format off
inline constexpr std::array<NamedMaterial, 24> named_materials{{
    {"emerald", {"Emerald", "エメラルド"},
     {0.0215, 0.1745, 0.0215}, {0.07568, 0.61424, 0.07568}, {0.633, 0.727811, 0.633}, 128 * 0.6},
    {"jade", {"Jade", "翡翠"},
     {0.135, 0.2225, 0.1575}, {0.54, 0.89, 0.63}, detail::grey(0.316228), 128 * 0.1},
    {"obsidian", {"Obsidian", "黒曜石"},
     {0.05375, 0.05, 0.06625}, {0.18275, 0.17, 0.22525}, {0.332741, 0.328634, 0.346435}, 128 * 0.3},
    {"pearl", {"Pearl", "真珠"},
     {0.25, 0.20725, 0.20725}, {1, 0.829, 0.829}, detail::grey(0.296648), 128 * 0.088},
    {"ruby", {"Ruby", "ルビー"},
     {0.1745, 0.01175, 0.01175}, {0.61424, 0.04136, 0.04136}, {0.727811, 0.626959, 0.626959}, 128 * 0.6},
    {"turquoise", {"Turquoise", "トルコ石"},
     {0.1, 0.18725, 0.1745}, {0.396, 0.74151, 0.69102}, {0.297254, 0.30829, 0.306678}, 128 * 0.1},
    {"brass", {"Brass", "真鍮"},
     {0.329412, 0.223529, 0.027451}, {0.780392, 0.568627, 0.113725}, {0.992157, 0.941176, 0.807843},
     128 * 0.21794872},
    {"bronze", {"Bronze", "青銅"},
     {0.2125, 0.1275, 0.054}, {0.714, 0.4284, 0.18144}, {0.393548, 0.271906, 0.166721}, 128 * 0.2},
    {"chrome", {"Chrome", "クロム"},
     detail::grey(0.25), detail::grey(0.4), detail::grey(0.774597), 128 * 0.6},
    {"copper", {"Copper", "銅"},
     {0.19125, 0.0735, 0.0225}, {0.7038, 0.27048, 0.0828}, {0.256777, 0.137622, 0.086014}, 128 * 0.1},
    {"gold", {"Gold", "金"},
     {0.24725, 0.1995, 0.0745}, {0.75164, 0.60648, 0.22648}, {0.628281, 0.555802, 0.366065}, 128 * 0.4},
    {"silver", {"Silver", "銀"},
     detail::grey(0.19225), detail::grey(0.50754), detail::grey(0.508273), 128 * 0.4},
    {"black-plastic", {"Black plastic", "黒のプラスチック"},
     detail::grey(0), detail::grey(0.01), detail::grey(0.5), 128 * 0.25},
    {"cyan-plastic", {"Cyan plastic", "シアンのプラスチック"},
     {0, 0.1, 0.06}, {0, 0.50980392, 0.50980392}, detail::grey(0.50196078), 128 * 0.25},
    {"green-plastic", {"Green plastic", "緑のプラスチック"},
     detail::grey(0), {0.1, 0.35, 0.1}, {0.45, 0.55, 0.45}, 128 * 0.25},
    {"red-plastic", {"Red plastic", "赤のプラスチック"},
     detail::grey(0), {0.5, 0, 0}, {0.7, 0.6, 0.6}, 128 * 0.25},
    {"white-plastic", {"White plastic", "白のプラスチック"},
     detail::grey(0), detail::grey(0.55), detail::grey(0.7), 128 * 0.25},
    {"yellow-plastic", {"Yellow plastic", "黄のプラスチック"},
     detail::grey(0), {0.5, 0.5, 0}, {0.6, 0.6, 0.5}, 128 * 0.25},
    {"black-rubber", {"Black rubber", "黒のゴム"},
     detail::grey(0.02), detail::grey(0.01), detail::grey(0.4), 128 * 0.078125},
    {"cyan-rubber", {"Cyan rubber", "シアンのゴム"},
     {0, 0.05, 0.05}, {0.4, 0.5, 0.5}, {0.04, 0.7, 0.7}, 128 * 0.078125},
    {"green-rubber", {"Green rubber", "緑のゴム"},
     {0, 0.05, 0}, {0.4, 0.5, 0.4}, {0.04, 0.7, 0.04}, 128 * 0.078125},
    {"red-rubber", {"Red rubber", "赤のゴム"},
     {0.05, 0, 0}, {0.5, 0.4, 0.4}, {0.7, 0.04, 0.04}, 128 * 0.078125},
    {"white-rubber", {"White rubber", "白のゴム"},
     detail::grey(0.05), detail::grey(0.5), detail::grey(0.7), 128 * 0.078125},
    {"yellow-rubber", {"Yellow rubber", "黄のゴム"},
     {0.05, 0.05, 0}, {0.5, 0.5, 0.4}, {0.7, 0.7, 0.04}, 128 * 0.078125},
}};
// clang-format on

}  // namespace cg
