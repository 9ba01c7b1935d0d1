// Named numbers of a scene and its picture, which lessons show, expect and set as goals: a colour, the width of a
// highlight, the difference of two techniques, a vertex on its way to the screen, a form factor.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "params/slots.h"
#include "scene/technique.h"
#include "workbench/solved_scenes.h"

namespace cg {

// One term of the light model, or their sum.
enum class LightTerm { all, ambient, diffuse, specular, emission };
template <>
inline constexpr std::array<Name, 5> names_of<LightTerm>{{{"all", {"All", "全体"}},
                                                          {"ambient", {"Ambient", "環境光"}},
                                                          {"diffuse", {"Diffuse", "拡散反射"}},
                                                          {"specular", {"Specular", "鏡面反射"}},
                                                          {"emission", {"Emission", "自己発光"}}}};
constexpr Quantity quantity_of(LightTerm term) {
  constexpr Quantity quantities[] = {Quantity::none, Quantity::ambient, Quantity::diffuse, Quantity::specular,
                                     Quantity::emission};
  return quantities[int(term)];
}

enum class Channel { red, green, blue, mean };
template <>
inline constexpr std::array<Name, 4> names_of<Channel>{{{"red", {"Red", "赤"}},
                                                        {"green", {"Green", "緑"}},
                                                        {"blue", {"Blue", "青"}},
                                                        {"mean", {"Mean of the three", "三つの平均"}}}};

// The coordinates of the pipeline, in the order of a vertex's way.
enum class Space { object, world, eye, clip, device, window };
template <>
inline constexpr std::array<Name, 6> names_of<Space>{{{"object", {"Object", "オブジェクト座標"}},
                                                      {"world", {"World", "ワールド座標"}},
                                                      {"eye", {"Eye", "視点座標"}},
                                                      {"clip", {"Clip", "クリップ座標"}},
                                                      {"device", {"Normalised device", "正規化デバイス座標"}},
                                                      {"window", {"Window", "ウィンドウ座標"}}}};

enum class Component { x, y, z, w, length };
template <>
inline constexpr std::array<Name, 5> names_of<Component>{
    {{"x", {"x", "x"}}, {"y", {"y", "y"}}, {"z", {"z", "z"}}, {"w", {"w", "w"}}, {"length", {"Length", "長さ"}}}};

// What a measurement may be told; each uses those that its description names.
struct MeasurementOptions {
  std::string technique = "software", other = "gl-fixed";
  int size = 256;           // of the picture, pixels a side
  double x = 0.5, y = 0.5;  // a place in the picture, from the top-left corner, shares of its size
  Channel channel = Channel::mean;
  LightTerm term = LightTerm::all;  // the term that is drawn alone,
  int light = -1;                   // of that light; -1: all
  double orbit = 0;                 // the camera is turned about the target first, degrees to the right
  int object = 0, vertex = 0;       // index into the mesh's positions
  int to = 1;                       // the object that light goes to
  Space space = Space::world;
  Component component = Component::x;
  double level = 0.5;  // of the maximum, or of brightness
  friend bool operator==(const MeasurementOptions&, const MeasurementOptions&) = default;
};

template <>
inline constexpr auto fields_of<MeasurementOptions> = std::tuple{
    field(&MeasurementOptions::technique, {.name = "technique", .label = {"Technique", "手法"}}),
    field(&MeasurementOptions::other, {.name = "other", .label = {"Other technique", "もう一つの手法"}}),
    field(&MeasurementOptions::size, {.name = "size", .range = {1, 1024}, .label = {"Picture size", "画像の大きさ"}}),
    field(&MeasurementOptions::x, {.name = "x", .label = {"Place across", "横の位置"}}),
    field(&MeasurementOptions::y, {.name = "y", .label = {"Place down", "縦の位置"}}),
    field(&MeasurementOptions::channel, {.name = "channel", .label = {"Channel", "チャンネル"}}),
    field(&MeasurementOptions::term, {.name = "term", .label = {"Term", "項"}}),
    field(&MeasurementOptions::light, {.name = "light", .range = {-2, 63}, .label = {"Light", "光源"}}),
    field(&MeasurementOptions::orbit,
          {.name = "orbit", .unit = "deg", .range = {-360, 360}, .label = {"Orbit", "カメラの回転"}}),
    field(&MeasurementOptions::object, {.name = "object", .range = {0, 1e5}, .label = {"Object", "物体"}}),
    field(&MeasurementOptions::vertex, {.name = "vertex", .range = {0, 1e9}, .label = {"Vertex", "頂点"}}),
    field(&MeasurementOptions::to, {.name = "to", .range = {0, 1e5}, .label = {"To object", "相手の物体"}}),
    field(&MeasurementOptions::space, {.name = "space", .label = {"Coordinates", "座標系"}}),
    field(&MeasurementOptions::component, {.name = "component", .label = {"Component", "成分"}}),
    field(&MeasurementOptions::level, {.name = "level", .label = {"Level", "しきい値"}}),
};

struct Measurement;

struct Measuring {
  const Measurement* what = nullptr;  // of measurements()
  MeasurementOptions options;
};

struct MeasureInput {
  const Scene& scene;    // meshes loaded; with its radiosity where it wants that
  const Scene& against;  // the second of two scenes; the same as `scene` where there is one
  const MeasurementOptions& options;
  std::span<const Technique> techniques;
  Progress& progress;
  SolvedScenes& solved;
};

struct Measurement {
  std::string_view id;  // "highlight-width"
  Words name;
  std::string_view unit;  // "1", "deg", "m", "pixel", "%"
  Words help;             // what is measured and which options count
  double (*measure)(const MeasureInput&);
};

std::span<const Measurement> measurements();

// Throws InputError that lists those there are.
const Measurement& find_measurement(std::string_view id);

// Draws what it needs, and solves the radiosity that a scene's ambient term asks for where `solved` does not hold it.
// `techniques` must not be used by another thread meanwhile. Throws InputError where a technique is missing,
// unavailable or cannot draw the scene, or where there is nothing to measure; and Cancelled.
double measure(const Measuring& measuring, const Scene& scene, const Scene& against,
               std::span<const Technique> techniques, Progress& progress, SolvedScenes& solved);

}  // namespace cg
