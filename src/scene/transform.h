// Where an object stands: p' = T Rz Ry Rx S p, the order of glTranslate, glRotate z, y, x, glScale in a program.
#pragma once
#include "math/transform.h"
#include "params/field.h"

namespace cg {

struct Transform {
  glm::dvec3 translate{0, 0, 0};
  glm::dvec3 rotate{0, 0, 0};  // degrees about x, y, z
  glm::dvec3 scale{1, 1, 1};
  friend bool operator==(const Transform&, const Transform&) = default;
};

template <>
inline constexpr auto fields_of<Transform> = std::tuple{
    field(&Transform::translate, {.name = "translate",
                                  .unit = "m",
                                  .range = {-1e30, 1e30},
                                  .slider = Range{-5, 5},
                                  .meaning = Meaning::position,
                                  .gl = "glTranslate",
                                  .label = {"Translate", "移動"},
                                  .help = {"Moves the object.", "物体を動かす。"}}),
    field(&Transform::rotate, {.name = "rotate",
                               .unit = "deg",
                               .range = {-1e6, 1e6},
                               .slider = Range{-180, 180},
                               .gl = "glRotate",
                               .label = {"Rotate", "回転"},
                               .help = {"Turns about x, then y, then z.", "x、y、z の順に回す。"}}),
    field(&Transform::scale, {.name = "scale",
                              .range = {-1e30, 1e30},
                              .slider = Range{-3, 3},
                              .gl = "glScale",
                              .label = {"Scale", "拡大縮小"},
                              .help = {"A negative number mirrors.", "負の数では鏡像になる。"}}),
};
static_assert(well_described<Transform>());

inline glm::dmat4 matrix(const Transform& t) {
  return translation(t.translate) * rotation(radians(t.rotate.z), {0, 0, 1}) *
         rotation(radians(t.rotate.y), {0, 1, 0}) * rotation(radians(t.rotate.x), {1, 0, 0}) * scaling(t.scale);
}

}  // namespace cg
