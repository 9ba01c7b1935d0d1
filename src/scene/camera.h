// Where the scene is seen from, and its matrices.
#pragma once
#include "math/transform.h"
#include "params/field.h"

namespace cg {

enum class Projection { perspective, orthographic };
template <>
inline constexpr std::array<Name, 2> names_of<Projection>{
    {{"perspective", {"Perspective", "透視投影"}}, {"orthographic", {"Orthographic", "平行投影"}}}};

struct Camera {
  glm::dvec3 position{0, 1, 3.4};
  glm::dvec3 target{0, 0, 0};
  glm::dvec3 up{0, 1, 0};
  Projection projection = Projection::perspective;
  double fov = 40;          // degrees, vertical
  double height = 2.4;      // of the orthographic view volume, metres
  double near_plane = 0.1;  // distance, metres, > 0
  double far_plane = 100;
  friend bool operator==(const Camera&, const Camera&) = default;
};

template <>
inline constexpr auto fields_of<Camera> = std::tuple{
    field(&Camera::position, {.name = "position",
                              .symbol = "V",
                              .unit = "m",
                              .range = {-1e30, 1e30},
                              .slider = Range{-10, 10},
                              .meaning = Meaning::position,
                              .gl = "gluLookAt",
                              .label = {"Eye", "視点"},
                              .help = {"Where the eye stands, in world coordinates.", "視点の位置（ワールド座標）。"}}),
    field(&Camera::target, {.name = "target",
                            .unit = "m",
                            .range = {-1e30, 1e30},
                            .slider = Range{-10, 10},
                            .meaning = Meaning::position,
                            .gl = "gluLookAt",
                            .label = {"Target", "注視点"},
                            .help = {"The point that the eye looks at.", "目が見つめる点。"}}),
    field(&Camera::up, {.name = "up",
                        .range = {-1e30, 1e30},
                        .slider = Range{-1, 1},
                        .meaning = Meaning::direction,
                        .gl = "gluLookAt",
                        .label = {"Up", "上方向"},
                        .help = {"The direction that stands upright in the picture.", "画面で上になる方向。"}}),
    field(&Camera::projection, {.name = "projection",
                                .label = {"Projection", "投影"},
                                .help = {"Perspective shrinks with distance; orthographic does not.",
                                         "透視投影は遠いほど小さい。平行投影は変わらない。"}}),
    field(&Camera::fov, {.name = "fov",
                         .unit = "deg",
                         .range = {1, 170},
                         .slider = Range{10, 120},
                         .gl = "gluPerspective",
                         .label = {"Field of view", "画角"},
                         .help = {"The vertical angle of the view.", "視野の縦の角度。"}}),
    field(&Camera::height, {.name = "height",
                            .unit = "m",
                            .range = {1e-20, 1e20},
                            .slider = Range{0.1, 20},
                            .scale = Scale::logarithmic,
                            .gl = "glOrtho",
                            .label = {"View height", "視野の高さ"},
                            .help = {"The height of the orthographic view.", "平行投影の視野の高さ。"}}),
    field(&Camera::near_plane,
          {.name = "near",
           .unit = "m",
           .range = {1e-20, 1e20},
           .slider = Range{1e-4, 10},
           .scale = Scale::logarithmic,
           .gl = "gluPerspective",
           .label = {"Near plane", "前方クリップ面"},
           .help = {"Nearer things are cut off. The nearer it is, the coarser the depths far away.",
                    "これより近いものは切り取られる。近いほど遠くの奥行きが粗くなる。"}}),
    field(&Camera::far_plane, {.name = "far",
                               .unit = "m",
                               .range = {1e-20, 1e20},
                               .slider = Range{1, 10000},
                               .scale = Scale::logarithmic,
                               .gl = "gluPerspective",
                               .label = {"Far plane", "後方クリップ面"},
                               .help = {"Farther things are cut off.", "これより遠いものは切り取られる。"}}),
};
static_assert(well_described<Camera>());

// World to eye coordinates.
inline glm::dmat4 view_matrix(const Camera& c) { return look_at(c.position, c.target, c.up); }

// Eye to clip coordinates, for a picture of `aspect` = width/height.
inline glm::dmat4 projection_matrix(const Camera& c, double aspect) {
  return c.projection == Projection::perspective ? perspective(radians(c.fov), aspect, c.near_plane, c.far_plane)
                                                 : orthographic(c.height, aspect, c.near_plane, c.far_plane);
}

}  // namespace cg
