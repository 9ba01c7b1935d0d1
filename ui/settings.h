// What a person sets about the window and not about the scene: described like every other parameter, so that the
// session saves it by walking the description.
#pragma once
#include <string>

#include "params/slots.h"
#include "radiosity/light_part.h"
#include "workbench/hemicube_show.h"
#include "workbench/view_mode.h"

namespace cg {

enum class Theme { dark, light };
template <>
inline constexpr std::array<Name, 2> names_of<Theme>{{{"dark", {"Dark", "暗い"}}, {"light", {"Light", "明るい"}}}};

// What the right side shows.
enum class Side { none, lesson, world, mistakes, presets, challenge, plan, mesh, trade, extremes, solver, hemicube };
template <>
inline constexpr std::array<Name, 12> names_of<Side>{{{"none", {"Closed", "閉じる"}},
                                                      {"lesson", {"Lesson", "授業"}},
                                                      {"world", {"World", "外から"}},
                                                      {"mistakes", {"Mistakes", "間違い"}},
                                                      {"presets", {"A | B", "A | B"}},
                                                      {"challenge", {"Match", "再現"}},
                                                      {"plan", {"Plan", "計画"}},
                                                      {"mesh", {"Mesh", "メッシュ"}},
                                                      {"trade", {"Trade", "速さと精度"}},
                                                      {"extremes", {"Extremes", "極端な値"}},
                                                      {"solver", {"Solver", "解法"}},
                                                      {"hemicube", {"Hemicube", "ヘミキューブ"}}}};

template <>
inline constexpr std::array<Name, 2> names_of<Language>{{{"en", {"English", "English"}}, {"ja", {"日本語", "日本語"}}}};

// What a recording shows, and what it becomes.
enum class Recorded { left, right, both, window };
template <>
inline constexpr std::array<Name, 4> names_of<Recorded>{{{"left", {"Left", "左"}},
                                                         {"right", {"Right", "右"}},
                                                         {"both", {"Both", "両方"}},
                                                         {"window", {"Window", "ウィンドウ"}}}};
enum class RecordedAs { gif, png };
template <>
inline constexpr std::array<Name, 2> names_of<RecordedAs>{
    {{"gif", {"Animated GIF", "GIF アニメーション"}}, {"png", {"PNG sequence", "連番 PNG"}}}};

struct Settings {
  Language language = Language::english;
  Theme theme = Theme::dark;
  double zoom = 1;                                    // of the type, on top of the monitor's scale
  std::string left = "gl-fixed", right = "software";  // ids of techniques
  ViewMode view = ViewMode::two;
  double wipe = 0.5;    // where the wipe's edge stands, from the left
  double gain = 32;     // of the difference
  bool handles = true;  // overlays: lights that can be dragged,
  bool vertex_normals = false, face_normals = false, wireframe = false;
  bool axes = false;     // of the world
  bool square = true;    // pictures are square; else they fill their panes
  bool clamped = false;  // mark the pixels that clamping changed
  double normal_length = 0.08;
  Side side = Side::none;
  bool divided_by_w = false;                 // the view from outside
  LightPart solver_part = LightPart::total;  // what of the light is drawn while the solver's panel is open,
  double solver_speed = 100;                 // and how many steps a second it plays
  bool code = true;                          // the listing, beside the equation;
  bool code_in_front = false;                // or, where there is no room for both, before it
  std::string knob, extreme;                 // ids of what the panels of trades and extremes have open; empty: none
  HemicubeShow hemicube = HemicubeShow::items;
  int patch = -1, other_patch = -1;    // whose hemicube is shown, and which it sees; -1: none was chosen
  int position = 0;                    // of the patch's hemicubes
  std::string lesson;                  // where the open lesson is: "03-shading:2"; empty: none
  Recorded picture = Recorded::right;  // what is saved or recorded
  RecordedAs record_as = RecordedAs::gif;
  double sweep_seconds = 4;  // that a slider which plays takes from end to end
  double left_width = 312, right_width = 320, strip_height = 200, code_width = 640;  // of the layout, units
  friend bool operator==(const Settings&, const Settings&) = default;
};

template <>
inline constexpr auto fields_of<Settings> = std::tuple{
    field(&Settings::language, {.name = "language", .label = {"Language", "言語"}}),
    field(&Settings::theme, {.name = "theme", .label = {"Theme", "配色"}}),
    field(&Settings::zoom, {.name = "zoom", .range = {0.5, 3}, .label = {"Zoom", "拡大率"}}),
    field(&Settings::left, {.name = "left", .label = {"Left technique", "左の手法"}}),
    field(&Settings::right, {.name = "right", .label = {"Right technique", "右の手法"}}),
    field(&Settings::view, {.name = "view", .label = {"View", "見方"}}),
    field(&Settings::wipe, {.name = "wipe", .range = {0, 1}, .label = {"Wipe", "ワイプ"}}),
    field(&Settings::gain,
          {.name = "gain",
           .range = {1, 1e6},
           .slider = Range{1, 255},
           .scale = Scale::logarithmic,
           .label = {"Gain", "増幅"},
           .help = {"The difference is multiplied by it before it is shown.", "差をこの倍率で強調して表示する。"}}),
    field(&Settings::handles,
          {.name = "handles",
           .label = {"Lights in the picture", "光源を表示"},
           .help = {"Shows each light in the picture; drag it there.", "光源を画面に表示する。ドラッグで動かせる。"}}),
    field(&Settings::vertex_normals, {.name = "vertex_normals",
                                      .symbol = "N",
                                      .label = {"Vertex normals", "頂点の法線"},
                                      .help = {"Draws the normal of each vertex.", "頂点ごとの法線を描く。"}}),
    field(&Settings::face_normals, {.name = "face_normals",
                                    .symbol = "N",
                                    .label = {"Face normals", "面の法線"},
                                    .help = {"Draws the normal of each face.", "面ごとの法線を描く。"}}),
    field(&Settings::wireframe, {.name = "wireframe",
                                 .label = {"Wireframe", "ワイヤーフレーム"},
                                 .help = {"Draws the edges of the faces.", "面の辺を描く。"}}),
    field(&Settings::axes, {.name = "axes",
                            .label = {"Axes", "座標軸"},
                            .help = {"Draws x, y and z of the world.", "ワールドの x・y・z 軸を描く。"}}),
    field(&Settings::square, {.name = "square",
                              .label = {"Square pictures", "正方形の画像"},
                              .help = {"Off: the pictures fill their panes.", "オフでは画像を枠いっぱいに描く。"}}),
    field(&Settings::clamped, {.name = "clamped",
                               .label = {"Clamped pixels", "クランプ画素"},
                               .help = {"Marks the pixels whose colour would leave 0..1 without clamping.",
                                        "クランプしなければ 0..1 を超える画素に印を付ける。"}}),
    field(&Settings::normal_length, {.name = "normal_length",
                                     .unit = "m",
                                     .range = {0, 1e6},
                                     .slider = Range{0, 0.5},
                                     .label = {"Length of drawn normals", "法線の長さ（表示）"}}),
    field(&Settings::side, {.name = "side", .label = {"Right side", "右側"}}),
    field(&Settings::divided_by_w, {.name = "divided_by_w", .label = {"After the division by w", "w で割った後"}}),
    field(&Settings::solver_part, {.name = "solver_part", .label = {"Light shown", "表示する光"}}),
    field(&Settings::solver_speed, {.name = "solver_speed",
                                    .unit = "1/s",
                                    .range = {0.1, 1e7},
                                    .slider = Range{1, 1e5},
                                    .scale = Scale::logarithmic,
                                    .label = {"Steps a second", "1 秒のステップ数"},
                                    .help = {"How fast it plays: a step is one row of the matrix, or one shot.",
                                             "再生の速さ。1 ステップは行列の 1 行、または 1 回の放出。"}}),
    field(&Settings::lesson, {.name = "lesson", .label = {"Lesson", "授業"}}),
    field(&Settings::knob, {.name = "knob", .label = {"Trade", "速さと精度"}}),
    field(&Settings::extreme, {.name = "extreme", .label = {"Extreme", "極端な値"}}),
    field(&Settings::hemicube, {.name = "hemicube", .label = {"Hemicube", "ヘミキューブ"}}),
    field(&Settings::patch, {.name = "patch", .range = {-1, 1 << 22}, .label = {"Patch", "パッチ"}}),
    field(&Settings::other_patch,
          {.name = "other_patch", .range = {-1, 1 << 22}, .label = {"Seen patch", "見えるパッチ"}}),
    field(&Settings::position, {.name = "position", .range = {0, 255}, .label = {"Position", "位置"}}),
    field(&Settings::picture, {.name = "picture", .label = {"Saved or recorded", "保存・録画するもの"}}),
    field(&Settings::record_as, {.name = "record_as", .label = {"Recorded as", "録画の形式"}}),
    field(&Settings::sweep_seconds, {.name = "sweep_seconds",
                                     .unit = "s",
                                     .range = {0.1, 600},
                                     .slider = Range{0.5, 30},
                                     .scale = Scale::logarithmic,
                                     .label = {"Pace of a slider that plays", "スライダ再生の片道の時間"}}),
    field(&Settings::code, {.name = "code",
                            .label = {"Program", "プログラム"},
                            .help = {"Shows the scene as OpenGL calls.", "シーンを OpenGL の呼び出しとして示す。"}}),
    field(&Settings::code_in_front, {.name = "code_in_front", .label = {"Program in front", "プログラムを手前に"}}),
    field(&Settings::left_width, {.name = "left_width", .range = {220, 600}, .label = {"Left width", "左の幅"}}),
    field(&Settings::right_width, {.name = "right_width", .range = {220, 800}, .label = {"Right width", "右の幅"}}),
    field(&Settings::strip_height,
          {.name = "strip_height", .range = {60, 500}, .label = {"Strip height", "下段の高さ"}}),
    field(&Settings::code_width,
          {.name = "code_width", .range = {200, 3000}, .label = {"Program width", "プログラムの幅"}}),
};

extern template Slots slots<Settings>(Settings&);  // in settings.cpp

}  // namespace cg
